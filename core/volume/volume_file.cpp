#include "core/volume/volume_file.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/volume/raw_volume.h"
#include "core/volume/slice_series.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace texloom {

namespace fs = std::filesystem;

namespace {

bool isRaw(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".json";
}

} // namespace

std::vector<fs::path> volumeFiles(const fs::path& path, int depth) {
    if (isRaw(path))
        return {path, fs::path(path).replace_extension(".raw")};
    return sliceFiles(path, depth);
}

std::vector<fs::path> filesOfVolume(const fs::path& path) {
    return isRaw(path) ? filesOfRawVolume(path) : filesOfSlices(path);
}

void checkFileBox(const Box& box) {
    box.check();
    if (box.size.voxels() > kLargestFileVoxels)
        failUsage("The box of {} has {} voxels, and one file holds up to {}; write several boxes, which fit "
                  "together.",
                  sizeText(box.size), grouped(static_cast<std::uint64_t>(box.size.voxels())),
                  grouped(static_cast<std::uint64_t>(kLargestFileVoxels)));
}

void writeVolume(const fs::path& path, const VolumeSource& source, const Box& box,
                 const VolumeWriteOptions& options, JobContext& context) {
    box.check();
    if (isRaw(path))
        writeRawVolume(path, source, box, options, context);
    else
        writeSlices(path, source, box, options, context);
}

LoadedVolume readVolume(const fs::path& path, JobContext& context, const VolumeReadOptions& options) {
    return isRaw(path) ? readRawVolume(path, context, options) : readSlices(path, context, options);
}

} // namespace texloom

#include "core/volume/volume_file.h"

#include "core/volume/raw_volume.h"
#include "core/volume/slice_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace texloom {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kFewestDigits = 4;

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
    const std::size_t digits = std::max(kFewestDigits, std::to_string(depth - 1).size());
    std::vector<fs::path> files;
    for (int z = 0; z < depth; ++z)
        files.push_back(path.parent_path() / fmt::format("{}-{:0{}}{}", path.stem().string(), z, digits,
                                                         path.extension().string()));
    return files;
}

std::vector<fs::path> filesOfVolume(const fs::path& path) {
    return isRaw(path) ? filesOfRawVolume(path) : filesOfSlices(path);
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

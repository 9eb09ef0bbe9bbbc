#pragma once

#include "core/io/image_file.h"
#include "core/volume/volume_source.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace texloom {

/// How a box of voxels becomes files.
struct VolumeWriteOptions {
    Depth depth = Depth::Bits16; ///< of numbered slices; raw volumes are always float
    /// To which colours are converted; "raw" for data. Slices of floats are "linear" for all who read them.
    std::string space = "srgb";
    std::string recipe; ///< written into each file that can hold it; empty for none
    /// Whether copies of the box beside each other join, as one of a period does; a TIFF cannot say so.
    bool repeats = false;
};

/// More voxels than this in one file are refused.
inline constexpr std::int64_t kLargestFileVoxels = 512LL << 20;

/// How a volume of a file is read.
struct VolumeReadOptions {
    /// Of slices: the colour space that they are in, "raw" for data; empty for what the files say. (A TIFF of
    /// floats is taken for linear light, since it has no word for data.)
    std::string space = {};
    std::int64_t largestVoxels = kLargestFileVoxels; ///< more are refused
};

/// A volume of a file, in the working space, and what the file says of it.
struct LoadedVolume {
    std::shared_ptr<const DenseSource> source;
    std::string recipe; ///< text, or empty
};

/// The files that writeVolume() makes for a box of this depth: for NAME.json it and NAME.raw, for NAME.png
/// (or another format of images) NAME-0000.png, NAME-0001.png … from the smallest z on.
std::vector<std::filesystem::path> volumeFiles(const std::filesystem::path& path, int depth);

/// The files that readVolume() reads for this name: the .json file and its data, or all slices. Only the name
/// itself where they cannot be told, as for a file that is not there.
std::vector<std::filesystem::path> filesOfVolume(const std::filesystem::path& path);

/// Writes a box of a source, a few z at a time, so that it need not be in memory whole: all files or none of
/// them. NAME.raw holds 32-bit little-endian floats: the channels of one voxel after the other, x fastest,
/// then y, then z; NAME.json says so, with size, place and recipe. (NumPy reads it with
/// fromfile(…, "<f4").reshape(d, h, w, c), and ParaView, ImageJ and others as raw data. NRRD would say less:
/// it has no word for what repeats, and its readers disagree on the axis of the channels.)
/// @throws Error or UsageError
void writeVolume(const std::filesystem::path& path, const VolumeSource& source, const Box& box,
                 const VolumeWriteOptions& options, JobContext& context);

/// Reads what writeVolume() wrote, by the name of the .json file or of any of the slices.
/// @throws Error or UsageError in one sentence if a file is missing, damaged, of another size than the others
/// or than it says, or too large.
LoadedVolume readVolume(const std::filesystem::path& path, JobContext& context,
                        const VolumeReadOptions& options = {});

} // namespace texloom

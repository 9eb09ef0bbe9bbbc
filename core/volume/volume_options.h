#pragma once

#include "core/io/image_file.h"
#include "core/volume/volume_source.h"

#include <cstdint>
#include <memory>
#include <string>

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

} // namespace texloom

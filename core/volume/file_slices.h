#pragma once

#include "core/volume/volume_source.h"

#include <filesystem>
#include <functional>
#include <string>

namespace texloom {

/// Calls `use` for each z of a box, in order from 0, with the picture at that z in the colour space of a
/// file. A few z are asked for at a time.
void forEachSlice(const VolumeSource& source, const Box& box, const std::string& space, JobContext& context,
                  const std::function<void(int z, const Image& picture)>& use);

/// Puts the picture of a file at one z of a volume, in the working space.
void putSlice(Image picture, const std::string& space, int z, Volume& volume);

/// Refuses a volume of a file that is too large to be read. @throws Error
void checkVolumeSize(const std::filesystem::path& path, const VolumeSize& size, int channels,
                     std::int64_t largestVoxels);

} // namespace texloom

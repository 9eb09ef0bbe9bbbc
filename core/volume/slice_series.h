#pragma once

#include "core/volume/volume_file.h"

namespace texloom {

/// A volume as one picture for each z: see writeVolume() and readVolume().
void writeSlices(const std::filesystem::path& path, const VolumeSource& source, const Box& box,
                 const VolumeWriteOptions& options, JobContext& context);
LoadedVolume readSlices(const std::filesystem::path& path, JobContext& context,
                        const VolumeReadOptions& options);
std::vector<std::filesystem::path> filesOfSlices(const std::filesystem::path& path);

} // namespace texloom

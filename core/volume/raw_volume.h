#pragma once

#include "core/volume/volume_options.h"

#include <filesystem>

namespace texloom {

/// A volume as one file of numbers and one that says what they are: see writeVolume() and readVolume().
void writeRawVolume(const std::filesystem::path& path, const VolumeSource& source, const Box& box,
                    const VolumeWriteOptions& options, JobContext& context);
LoadedVolume readRawVolume(const std::filesystem::path& path, JobContext& context,
                           const VolumeReadOptions& options);
std::vector<std::filesystem::path> filesOfRawVolume(const std::filesystem::path& path);

} // namespace texloom

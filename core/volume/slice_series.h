#pragma once

#include "core/volume/volume_options.h"

#include <filesystem>
#include <vector>

namespace texloom {

/// The files of that many pictures: of NAME.png they are NAME-0000.png, NAME-0001.png …
std::vector<std::filesystem::path> sliceFiles(const std::filesystem::path& path, int depth);

/// A volume as one picture for each z: see writeVolume() and readVolume().
void writeSlices(const std::filesystem::path& path, const VolumeSource& source, const Box& box,
                 const VolumeWriteOptions& options, JobContext& context);
LoadedVolume readSlices(const std::filesystem::path& path, JobContext& context,
                        const VolumeReadOptions& options);
std::vector<std::filesystem::path> filesOfSlices(const std::filesystem::path& path);

} // namespace texloom

#pragma once

#include "core/volume/volume_options.h"

#include <filesystem>
#include <vector>

namespace texloom {

/// The files that writeVolume() makes for a box of this depth: for NAME.json it and NAME.raw, for NAME.png
/// (or another format of images) NAME-0000.png, NAME-0001.png … from the smallest z on.
std::vector<std::filesystem::path> volumeFiles(const std::filesystem::path& path, int depth);

/// The files that readVolume() reads for this name: the .json file and its data, or all slices. Only the name
/// itself where they cannot be told, as for a file that is not there.
std::vector<std::filesystem::path> filesOfVolume(const std::filesystem::path& path);

/// @throws UsageError if a box has no voxels, lies too far out, or has more voxels than one call writes.
void checkFileBox(const Box& box);

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

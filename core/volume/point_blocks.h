#pragma once

#include "core/volume/volume_source.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace texloom {

/// Solids are asked for values at points in blocks of this side, and one voxel more along each axis for what
/// lies between two blocks.
inline constexpr int kBlockSide = 32;
/// Which block along each axis.
using BlockPlace = std::array<std::int64_t, 3>;

/// The voxels of a block.
Box boxOf(const BlockPlace& place);
/// The points by the block that they lie in.
/// @throws UsageError where a point lies further out than Box::kFarthest or is no number.
std::map<BlockPlace, std::vector<std::size_t>> blocksOf(std::span<const Eigen::Vector3d> points);
/// A block of a source; beyond its bounds it is 0.
Volume blockOf(const VolumeSource& source, const BlockPlace& place, JobContext& context);
/// The values at a point of a block, interpolated linearly among the eight voxels around it.
/// @param to gets one number for each channel.
void interpolate(const Volume& block, const BlockPlace& place, const Eigen::Vector3d& point, float* to);

} // namespace texloom

#pragma once

#include "core/volume/volume_source.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace texloom {

/// The values of a source at points, in voxels, interpolated linearly among the eight voxels around each:
/// channels numbers for each point. Only blocks of the solid that hold points are asked for, one after the
/// other, so that a surface through a large solid takes little memory. Beyond a source's bounds it is 0.
/// @throws UsageError where a point lies further out than Box::kFarthest or is no number.
std::vector<float> sampledAt(const VolumeSource& source, std::span<const Eigen::Vector3d> points,
                             JobContext& context);

} // namespace texloom

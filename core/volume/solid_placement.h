#pragma once

#include "core/volume/mesh.h"
#include "core/volume/volume_source.h"

#include <Eigen/Core>

#include <vector>

namespace texloom {

/// How a solid lies in a surface: a point p of the surface is at offset + scale R p, in voxels, where R turns
/// about x, then y, then z.
struct SolidPlacement {
    double scale = 1;                                 ///< voxels for one unit of the surface, more than 0
    Eigen::Vector3d angles = Eigen::Vector3d::Zero(); ///< in radians
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< the voxel at the surface's origin

    Eigen::Matrix3d rotation() const;
    Eigen::Vector3d at(const Eigen::Vector3d& point) const { return offset + scale * (rotation() * point); }
};

/// Red, green and blue of each vertex of a mesh: those of the solid at its place; a solid of fewer than three
/// channels is grey.
/// @throws UsageError if the scale is none, the mesh has no triangle, or a point lies too far out.
std::vector<float> vertexColours(const Mesh& mesh, const VolumeSource& solid, const SolidPlacement& placement,
                                 JobContext& context);

/// A mesh whose triangles are parted, each into four as often as it takes, until no edge is longer, or the
/// next parting would give more triangles than `most`: colours at vertices are as fine as these.
Mesh refined(Mesh mesh, double longestEdge, std::size_t most, JobContext& context);

} // namespace texloom

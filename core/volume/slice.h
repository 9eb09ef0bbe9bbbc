#pragma once

#include "core/volume/volume_source.h"

#include <Eigen/Core>

#include <optional>

namespace texloom {

/// The axis that a plane is square to.
enum class Axis { X, Y, Z };

/// A plane in space, as the pixels of a picture of it lie there: pixel (i, j) is at origin + i right + j
/// down, in voxels. Voxels are points: the one of coordinates (x, y, z) has its value there.
struct Plane {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::UnitX();
    Eigen::Vector3d down = Eigen::Vector3d::UnitY();

    /// Steps from one pixel to the next may have up to this many voxels.
    static constexpr double kLongestStep = 8;

    Eigen::Vector3d at(double x, double y) const { return origin + x * right + y * down; }
};

/// The plane square to an axis whose pixel (0, 0) lies at `origin`: square to z, x runs to the right and y
/// down; square to x, z to the right and y down; square to y, x to the right and z down. So the faces of a
/// cube that meet share their voxels, and y is down wherever it can be.
Plane axisPlane(Axis axis, const Eigen::Vector3d& origin);

/// That plane turned about `pivot`: by `turn` radians about its own down direction, then by `tilt` about its
/// own right one. A turn of π / 4 cuts a cube at 45°.
Plane turned(const Plane& plane, const Eigen::Vector3d& pivot, double turn, double tilt);

/// The picture of a plane of a source. Where rows and columns of the picture are rows of voxels, the values
/// are those of the voxels, bit for bit; else each pixel is interpolated linearly among the eight voxels
/// around it. Pixels beyond the bounds of a source that ends are 0.
/// @throws UsageError if the plane's directions are no such, or it lies too far out or nowhere in the bounds.
Image slice(const VolumeSource& source, const Plane& plane, Size size, JobContext& context);

/// The same; nothing where all of it lies beyond the source's bounds.
std::optional<Image> sliceWithin(const VolumeSource& source, const Plane& plane, Size size,
                                 JobContext& context);

} // namespace texloom

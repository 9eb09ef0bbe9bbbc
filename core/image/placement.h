#pragma once

#include "core/base/value.h"
#include "core/image/size.h"

#include <Eigen/Core>

#include <utility>

namespace texloom {

/// Where the pixels of an edited image lie in the image it was made from: a projective map of the plane.
class Placement {
public:
    /// The identity on an image.
    explicit Placement(Size size) : Placement(size, Eigen::Matrix3d::Identity()) {}
    /// @param size of the edited image. @param toSource from its homogeneous coordinates to the source's.
    Placement(Size size, Eigen::Matrix3d toSource) : m_size(size), m_toSource(std::move(toSource)) {}

    Size size() const { return m_size; }
    /// The source's point for a point of the edited image, and the inverse.
    PlanePoint toSource(PlanePoint point) const;
    PlanePoint fromSource(PlanePoint point) const;
    /// The partial derivatives of the source's point with respect to the edited image's, as columns.
    Eigen::Matrix2d jacobian(PlanePoint point) const;
    /// Whether every pixel falls exactly on a pixel of the source.
    bool exact() const;

    /// The composition with `next`, which belongs to an image made from this one's.
    Placement after(const Placement& next) const { return {next.m_size, m_toSource * next.m_toSource}; }

private:
    Size m_size;
    Eigen::Matrix3d m_toSource;
};

/// The placement that moves an image's origin to this point of its source.
Eigen::Matrix3d shifted(double x, double y);

} // namespace texloom

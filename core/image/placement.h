#pragma once

#include "core/image/exemplar_edit.h"

#include <Eigen/Core>

namespace texloom {

/// Where the pixels of an edited image lie in the image it was made from: a projective map of the plane.
class Placement {
public:
    /// The image as it is.
    explicit Placement(Size size) : m_size(size), m_toSource(Eigen::Matrix3d::Identity()) {}

    Size size() const { return m_size; }
    /// The source's point for a point of the edited image, and the other way round.
    PlanePoint toSource(PlanePoint point) const;
    PlanePoint fromSource(PlanePoint point) const;
    /// How the source's point moves with the edited image's: its partial derivatives as columns.
    Eigen::Matrix2d jacobian(PlanePoint point) const;
    /// Whether every pixel lies on one of the source.
    bool exact() const;

    /// The same after a further edit; flattening moves nothing. @throws UsageError as sizeAfter()
    Placement after(const ExemplarEdit& edit) const;

private:
    Size m_size;
    Eigen::Matrix3d m_toSource;
};

/// Where all edits together lead.
Placement placementOf(const ExemplarEdits& edits, Size source);

} // namespace texloom

#pragma once

#include "core/image/placement.h"

#include <memory>
#include <variant>

namespace texloom {

/// A dense field of the plane: any smooth function from the points of an edited image to its source's.
/// Evaluated point by point, from several threads, so that any part of an image can be made on its own.
class WarpField {
public:
    virtual ~WarpField() = default;

    virtual PlanePoint toSource(PlanePoint point) const = 0;
    /// Its partial derivatives as columns; differences over a pixel unless a field overrides this.
    virtual Eigen::Matrix2d jacobian(PlanePoint point) const;
};

/// Where the pixels of a geometrically edited image come from: a placement, or a dense field.
class Warp {
public:
    // Implicit: a placement may be used wherever a warp is expected.
    Warp(Placement placement) : m_size(placement.size()), m_map(std::move(placement)) {} // NOLINT
    /// @param size of the edited image.
    Warp(Size size, std::shared_ptr<const WarpField> field) : m_size(size), m_map(std::move(field)) {}

    Size size() const { return m_size; }
    /// The source's point for a point of the edited image.
    PlanePoint toSource(PlanePoint point) const;
    /// The inverse; of a field by Newton's method from `near`, and not a number where that does not converge.
    PlanePoint fromSource(PlanePoint point, PlanePoint near) const;
    /// The partial derivatives of the source's point with respect to the edited image's, as columns.
    Eigen::Matrix2d jacobian(PlanePoint point) const;
    /// Whether every pixel is known to fall exactly on a pixel of the source.
    bool exact() const;

    /// The composition with `next`, which belongs to an image made from this one's.
    Warp after(const Warp& next) const;

private:
    using Field = std::shared_ptr<const WarpField>;

    Size m_size;
    std::variant<Placement, Field> m_map;
};

} // namespace texloom

#pragma once

#include "core/image/placement.h"

#include <memory>
#include <variant>

namespace texloom {

/// A dense field of the plane: any smooth function from the points of an edited image to its source's. Asked
/// at points, from several threads, so that any part of an image can be made alone.
class WarpField {
public:
    virtual ~WarpField() = default;

    virtual PlanePoint toSource(PlanePoint point) const = 0;
    /// Its partial derivatives as columns; by differences over a pixel unless a field knows better.
    virtual Eigen::Matrix2d jacobian(PlanePoint point) const;
};

/// Where the pixels of an image that geometry made come from: a placement, or a dense field.
class Warp {
public:
    // Every placement is a warp, so that it may stand where one is asked for.
    Warp(Placement placement) : m_size(placement.size()), m_map(std::move(placement)) {} // NOLINT
    /// @param size of the edited image.
    Warp(Size size, std::shared_ptr<const WarpField> field) : m_size(size), m_map(std::move(field)) {}

    Size size() const { return m_size; }
    /// The source's point for a point of the edited image.
    PlanePoint toSource(PlanePoint point) const;
    /// The other way round; of a field by Newton's method from `near`, and not a number where that finds
    /// nothing.
    PlanePoint fromSource(PlanePoint point, PlanePoint near) const;
    /// How the source's point moves with the edited image's: its partial derivatives as columns.
    Eigen::Matrix2d jacobian(PlanePoint point) const;
    /// Whether every pixel is known to lie on one of the source.
    bool exact() const;

    /// Where `next` and this lead together: `next` is of an image made from this one's.
    Warp after(const Warp& next) const;

private:
    using Field = std::shared_ptr<const WarpField>;

    Size m_size;
    std::variant<Placement, Field> m_map;
};

} // namespace texloom

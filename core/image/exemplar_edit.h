#pragma once

#include "core/image/size.h"

#include <array>
#include <variant>
#include <vector>

namespace texloom {

/// A place between pixels: pixel (x, y) covers the square from (x, y) to (x + 1, y + 1).
struct PlanePoint {
    double x = 0, y = 0;

    friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// Keeps a rectangle, in pixels of the image as the edits before it left it.
struct CropEdit {
    Region area;

    friend bool operator==(const CropEdit&, const CropEdit&) = default;
};

/// Turns clockwise. Quarter turns move pixels; other angles keep the largest upright rectangle that lies in
/// the turned image.
struct RotateEdit {
    double degrees = 0; ///< -360 to 360

    friend bool operator==(const RotateEdit&, const RotateEdit&) = default;
};

/// Mirrors: left becomes right, or top becomes bottom.
struct FlipEdit {
    enum class Axis { Horizontal, Vertical };
    Axis axis = Axis::Horizontal;

    friend bool operator==(const FlipEdit&, const FlipEdit&) = default;
};

/// Makes a rectangle of the quadrangle that a plane rectangle is in a photograph taken at a slant.
struct RectifyEdit {
    std::array<PlanePoint, 4> corners{}; ///< top left, top right, bottom right, bottom left
    Size size;                           ///< of the rectangle; empty: as long as the longer of opposite sides

    friend bool operator==(const RectifyEdit&, const RectifyEdit&) = default;
};

/// Takes slow changes of light out of the colours; see flattened().
struct FlattenEdit {
    enum class Model {
        Smooth,     ///< the light is what a wide Gaussian window sees
        Polynomial, ///< the light is a low polynomial over the whole image
    };
    Model model = Model::Smooth;
    double width = 0.25; ///< of the window, in shares of the shorter side, 0.02 to 1
    int order = 2;       ///< of the polynomial, 1 to 4
    double strength = 1; ///< 0 (nothing) to 1 (all of the unevenness)

    friend bool operator==(const FlattenEdit&, const FlattenEdit&) = default;
};

/// One change of an exemplar, made when it is used: the file stays as it is. Mask and companion maps take
/// part in all but flattening.
using ExemplarEdit = std::variant<CropEdit, RotateEdit, FlipEdit, RectifyEdit, FlattenEdit>;
using ExemplarEdits = std::vector<ExemplarEdit>;

/// The size that an image has after an edit. @throws UsageError that names the value and the limit where the
/// edit cannot be made.
Size sizeAfter(const ExemplarEdit& edit, Size before);
Size sizeAfter(const ExemplarEdits& edits, Size before);

} // namespace texloom

#pragma once

#include "core/image/image.h"

#include <functional>

namespace texloom {

/// How two images are compared, sample by sample: a is the first, b the second.
enum class DifferenceKind {
    Absolute, ///< |a − b|; the number is its mean
    Squared,  ///< (a − b)²; the number is the square root of its mean (RMSE)
    Relative, ///< |a − b| / (|b| + 0.01), so that dark samples count as much as bright ones; its mean
};

/// The difference between two images.
struct Difference {
    Image image; ///< of the common part: aligned at the top left, with the channels both have
    double number = 0;
    float largest = 0; ///< sample in the image
};

/// @param check called for every row; may throw.
Difference difference(
    const ImageView& a, const ImageView& b, DifferenceKind kind, const std::function<void()>& check = [] {});

} // namespace texloom

#pragma once

#include "core/image/image.h"

#include <functional>

namespace texloom {

/// The image at half its size, rounded down (a side of 1 stays): filtered with a Gaussian of standard
/// deviation 0.8 px, border pixels repeated, so that pixel x of the result lies in the middle of pixels 2x
/// and 2x + 1.
/// @param check called for every row; may throw.
Image halved(
    const ImageView& image, const std::function<void()>& check = [] {});

/// A mask of one channel at half its size: 1 where none of the pixels that halved() averages is 0.
/// @param check called for every row; may throw.
Image halvedMask(
    const PlaneView& mask, const std::function<void()>& check = [] {});

/// One channel of row `y` of an image at this size by bilinear interpolation, in `to`; both axes wrap.
void enlargeRow(const PlaneView& plane, Size size, int y, float* to);

} // namespace texloom

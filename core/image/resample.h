#pragma once

#include "core/image/image.h"
#include "core/image/warp.h"

#include <functional>

namespace texloom {

/// The image under a warp, by Catmull and Rom's cubic; where the warp shrinks it, each pixel is the
/// mean of enough samples. Pixels that fall exactly on a pixel of the source are copied bit for bit; beyond
/// the source's edges its outermost pixels are repeated. @param check called for every row; may throw.
Image resampled(
    const ImageView& source, const Warp& warp, const std::function<void()>& check = [] {});

/// The same for a mask: 0 wherever any pixel that resampled() would use is 0 in it, else 1.
Image resampledMask(
    const ImageView& mask, const Warp& warp, const std::function<void()>& check = [] {});

/// The size with its longer side scaled down to `longest` px, if it is longer.
Size sizeWithin(Size size, int longest);
/// The image stretched to another size.
Image resized(
    const ImageView& source, Size to, const std::function<void()>& check = [] {});

} // namespace texloom

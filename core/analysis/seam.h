#pragma once

#include "core/image/image.h"

#include <functional>

namespace texloom {

/// How visible the seam is where copies of an image meet: mean absolute difference of pixels that meet across
/// the border, relative to that of neighbours inside, along each axis. About 1 where the image tiles, larger
/// where it does not; 1 for an image that is constant along the axis.
struct SeamScore {
    double x = 1;
    double y = 1;
};

/// @param check called for every row; may throw.
SeamScore seamScore(
    const ImageView& image, const std::function<void()>& check = [] {});

} // namespace texloom

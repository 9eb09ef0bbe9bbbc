#pragma once

#include "core/image/image.h"

namespace texloom {

/// How visible the seam is where copies of an image meet: mean absolute difference of pixels that meet across
/// the border, over that of neighbours inside. About 1 when the image tiles, larger when it does not.
/// @return 1 for an image that is constant along the axis.
double seamScoreX(const ImageView& image);
double seamScoreY(const ImageView& image);

} // namespace texloom

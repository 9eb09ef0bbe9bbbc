#pragma once

#include "core/image/image.h"

namespace texloom {

/// Whether a mask's value says that a pixel belongs to the region: black does, and what is nearer to it than
/// to white.
inline bool inRegion(float value) {
    return value < 0.5F;
}

/// The region of a picture where none is painted: the middle half of its width and height, at least a pixel.
Region middleRegion(Size picture);

} // namespace texloom

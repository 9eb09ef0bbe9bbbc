#pragma once

#include "core/image/image.h"

namespace texloom {

/// An image whose patches may be found.
struct PatchSource {
    ImageView image;
    PlaneView mask; ///< one channel of the image's size, or {}: no patch with a pixel where it is 0 is found
    double weight = 1; ///< how much more often than those of others its patches are to be drawn
};

} // namespace texloom

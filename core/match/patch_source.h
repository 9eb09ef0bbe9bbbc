#pragma once

#include "core/image/image.h"

#include <functional>
#include <span>

namespace texloom {

/// An image whose patches may be found.
struct PatchSource {
    ImageView image;
    PlaneView mask; ///< one channel of the image's size, or {}: no patch with a pixel where it is 0 is found
    double weight = 1; ///< how much more often its patches are drawn than those of others
};

/// The mean square of a pixel's distance from `means`, one per channel, over all pixels of all exemplars.
/// @param check called for every row; may throw.
double pixelVariance(std::span<const PatchSource> exemplars, std::span<const double> means,
                     const std::function<void()>& check);

} // namespace texloom

#pragma once

#include "core/image/image.h"

#include <functional>

namespace texloom {

/// The pictures in which a texture's lattice is looked for.

/// The exemplar without slow changes of light: each channel less the quadratic surface that fits it best.
/// @param check called every few milliseconds; may throw.
Image withoutLight(const ImageView& exemplar, const std::function<void()>& check);

/// How much the exemplar changes at each pixel, in one channel: the length of the gradient of all channels
/// together. Joints between bricks of any colours look alike in it. Blurred by a 160th of the exemplar, so
/// that joints need not lie exactly where a lattice has them, and without slow changes.
/// @param check called every few milliseconds; may throw.
Image edgesOf(const ImageView& exemplar, const std::function<void()>& check);

} // namespace texloom

#pragma once

#include "core/image/image.h"

#include <functional>

namespace texloom {

/// Scales of images (Raad, thesis 2016, section 3.4). An axis that wraps counts as periodic; on one that does
/// not, images are mirrored at their borders, which keeps the Fourier transform free of a jump there.

/// The image convolved with a Gaussian of standard deviation `sigma` pixels. @param check called now and
/// then.
Image blurred(const ImageView& image, double sigma, Wrap wrap, const std::function<void()>& check);

/// Every second pixel of an image, from the first: ⌈width / 2⌉ × ⌈height / 2⌉ (eq. 3.9).
Image everySecond(const ImageView& image);

/// Standard deviation of the Gaussian that must precede everySecond() to avoid aliasing.
inline constexpr double kZoomSigma = 1.4;

/// The image with as many new pixels between its own, by zero padding of its Fourier transform (eq. 3.11).
/// @param size of the result: twice the image's, or 1 less on either side; an axis that wraps then still
/// closes, a little less than twice as long.
Image zoomedIn(const ImageView& image, Size size, Wrap wrap, const std::function<void()>& check);

} // namespace texloom

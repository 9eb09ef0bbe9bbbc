#pragma once

#include "core/image/image.h"

#include <functional>

namespace texloom::flatten {

/// What light is taken to be.
enum class Model {
    Smooth,     ///< what a wide Gaussian window sees
    Polynomial, ///< a low polynomial over the whole image
};

struct Settings {
    Model model = Model::Smooth;
    double width = 0.25; ///< of the window, in shares of the shorter side
    int order = 2;       ///< of the polynomial
    double strength = 1; ///< 0 (nothing) to 1 (all of the unevenness)
};

/// Evens out light that changes slowly over an image: fits the logarithm of the brightness over a coarse grid
/// by a wide window or a low polynomial, and divides it out of the first three channels (or of the only one),
/// so that colours keep their hue and the mean brightness stays.
/// @param image in values proportional to light. @param mask one channel, or null: pixels where it is 0 do
/// not count. @param check called for every row; may throw.
void evenOut(Image& image, const Settings& settings, const Image* mask, const std::function<void()>& check);

} // namespace texloom::flatten

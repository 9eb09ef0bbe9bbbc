#pragma once

#include "core/image/exemplar_edit.h"
#include "core/image/image.h"

#include <functional>

namespace texloom {

/// Evens out light that changes slowly over an image: fits the logarithm of the brightness over a coarse grid
/// by a wide window or a low polynomial, and divides it out of the first three channels (or of the only one),
/// so that colours keep their hue and the mean brightness stays.
/// @param image in values proportional to light. @param mask one channel, or null: pixels where it is 0 do
/// not count. @param check called for every row; may throw.
void flatten(
    Image& image, const FlattenEdit& edit, const Image* mask = nullptr,
    const std::function<void()>& check = [] {});

} // namespace texloom

#pragma once

#include "core/image/image.h"

#include <functional>
#include <vector>

namespace texloom {

/// Gives invisible pixels, whose alpha is 0, the colours of the visible ones around them, nearest first: the
/// colours that a file stores there must not affect statistics, averages and comparisons. Where nothing is
/// visible, nothing changes.
/// (Pull and push of Gortler, Grzeszczuk, Szeliski and Cohen, "The Lumigraph", 1996, with weights 0 and 1.)
/// @param alpha the alpha channel. @param colours the channels to fill. @param check called for every row;
/// may throw, and leaves the image half filled.
void fillHidden(
    Image& image, int alpha, const std::vector<int>& colours, const std::function<void()>& check = [] {});

} // namespace texloom

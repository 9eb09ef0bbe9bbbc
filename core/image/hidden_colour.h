#pragma once

#include "core/image/image.h"

#include <vector>

namespace texloom {

/// Gives pixels that nobody sees, since their alpha is 0, the colours of what is visible around them, near
/// ones first: whatever a file has there must take no part in statistics, averages and comparisons. Where
/// nothing is visible, nothing changes.
/// (Pull and push of Gortler, Grzeszczuk, Szeliski and Cohen, "The Lumigraph", 1996, with weights 0 and 1.)
/// @param alpha the channel of alpha. @param colours the channels to fill.
void fillHidden(Image& image, int alpha, const std::vector<int>& colours);

} // namespace texloom

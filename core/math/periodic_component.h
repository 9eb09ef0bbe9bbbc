#pragma once

#include "core/image/image.h"

#include <functional>

namespace texloom {

/// The periodic component p of u = p + s (Moisan, "Periodic plus smooth image decomposition", J. Math.
/// Imaging Vis. 39, 2011): p has no jump where its borders meet, s is smooth and has mean 0, so that p keeps
/// the mean. The spectrum of p is free of the cross that the borders of u cause in its own. Channels are
/// treated separately.
/// @param check called every few milliseconds; may throw.
Image periodicComponent(
    const ImageView& image, const std::function<void()>& check = [] {});

} // namespace texloom

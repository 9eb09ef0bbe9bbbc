#pragma once

#include "core/image/image.h"
#include "core/image/warp.h"

#include <functional>

namespace texloom {

/// A mask after a brush stroke that was painted on the edited image.
/// @param mask of the source's size, or null for one that hides nothing. @param warp from the edited image
/// to the source. @param stroke one channel of the edited image's size: not 0 where the brush went.
/// @param hide whether the brush hides or shows again. @param check called for every row; may throw.
Image paintedMask(
    const Image* mask, Size source, const Warp& warp, const Image& stroke, bool hide,
    const std::function<void()>& check = [] {});

} // namespace texloom

#pragma once

#include "core/base/value.h"
#include "core/image/image.h"

#include <functional>

/// What a painter does with a selection: one channel of a picture's size, 1 where it is selected, 0 where it
/// is not, and between at soft edges. What lies beyond the picture counts neither way.
namespace texloom::selections {

/// The pixels whose middles lie in a polygon, as a selection. Where its sides cross, all that they go around
/// lies within (nonzero winding).
/// @param corners in pixels of the picture; the last is joined to the first.
Image polygon(Size size, const PlanePoints& corners);

/// A selection with a shape added or taken away; both have one size.
Image combined(const ImageView& selection, const ImageView& shape, bool add);

/// What was selected is not, and the other way round.
Image inverted(const ImageView& selection);

/// Each pixel as selected as the most selected one up to `pixels` away.
/// @param check called for every row; may throw.
Image grown(
    const ImageView& selection, int pixels, const std::function<void()>& check = [] {});

/// Each pixel as selected as the least selected one up to `pixels` away. @param check as of grown()
Image shrunk(
    const ImageView& selection, int pixels, const std::function<void()>& check = [] {});

/// A soft edge outside what is wholly selected, which stays as it is: a pixel d away from it is selected to
/// 1 − d / (pixels + 1), or as it was if that is more. @param check as of grown()
Image feathered(
    const ImageView& selection, int pixels, const std::function<void()>& check = [] {});

} // namespace texloom::selections

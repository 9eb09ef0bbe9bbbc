#pragma once

#include "core/image/position_map.h"

#include <functional>

namespace texloom {

/// Gives every pixel of an exemplar a colour of its own, similar for neighbours and different for distant
/// pixels (Raad & Galerne, IPOL 2017, section 4: the position map, fig. 5). Three channels, 0 to 1.
/// @param exemplar its number, @param count of how many: each gets its own range of hues.
Image positionPicture(Size exemplarSize, int exemplar = 0, int count = 1);

/// The synthesis map as a picture: every output pixel in the colour that positionPicture() gives its source;
/// pixels without a source are 0. Areas in which the colour changes smoothly are verbatim copies.
Image synthesisPicture(const PositionMap& map);

/// The verbatim copies: pixels that were copied together, with the same offset, have one colour, and the
/// borders between them are black. Three channels, 0 to 1; pixels without a source are 0.
Image copiedRegionsPicture(const PositionMap& map);

/// Share of horizontally and vertically neighbouring output pixels whose sources are not neighbours in the
/// same way: 0 for a copy of the exemplar, near 1 where every pixel comes from elsewhere.
/// @param check called for every row; may throw.
double innovation(
    const PositionMap& map, const std::function<void()>& check = [] {});

} // namespace texloom

#pragma once

#include "core/image/image.h"
#include "core/image/map_role.h"

#include <Eigen/Core>

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace texloom {

/// Id of the outputs that are STMaps: for each pixel the place in an exemplar that it comes from, which lies
/// between pixels. Four channels, as compositors have them: x over the width, 1 − y over the height, both
/// from 0 to 1 with the origin at the bottom left, the exemplar's number, and 1 where there is a place.
inline constexpr std::string_view kStMapPort = "stmap";

/// The partial derivatives of the place in pixels, as columns, from differences to neighbouring pixels. Where
/// the exemplar is mirrored or repeated the map turns round or jumps: the side that does not is taken.
/// The identity where these say nothing, as in a picture of one row.
/// @param exemplar the size of the exemplar that the pixel comes from.
Eigen::Matrix2d stMapJacobian(const ImageView& stmap, Size exemplar, int x, int y);

/// Whether every place is the middle of a pixel, to a thirty-second, so that a PositionMap can say the same.
bool addressesPixels(const ImageView& stmap, const std::vector<Size>& exemplars);

/// The picture that an STMap makes of `exemplars`, by Catmull and Rom's cubic, mirrored at their borders;
/// where the map shrinks them, each pixel is the mean of enough samples. Pixels without a place are 0.
/// @param check called for every row; may throw.
/// @throws Error where a place lies in an exemplar that is not there.
Image appliedStMap(
    const ImageView& stmap, std::span<const ImageView> exemplars, const std::function<void()>& check = [] {});

} // namespace texloom

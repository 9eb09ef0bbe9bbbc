#pragma once

#include "core/image/image.h"

#include <cstddef>
#include <span>

namespace texloom {

/// The colours of points as light, linear Rec.709: a row of three channels, of which grey volumes have the
/// same in each and volumes of more channels the first three.
/// @param values in the working space, `channels` for each point; no numbers (NaN) stay none.
Image lightOfPoints(std::span<const float> values, std::size_t channels);

} // namespace texloom

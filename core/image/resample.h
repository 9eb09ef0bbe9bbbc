#pragma once

#include "core/image/image.h"
#include "core/image/placement.h"

#include <functional>

namespace texloom {

/// The image under a placement, by Catmull and Rom's cubic; where the placement shrinks it, each pixel is the
/// mean of enough samples. Pixels that lie on one of the source are copied bit for bit; beyond its edges the
/// source goes on as at the edge. @param check called for every row; may throw.
Image resampled(
    const ImageView& source, const Placement& placement, const std::function<void()>& check = [] {});

/// The same for a mask: 0 wherever any pixel that resampled() would use is 0 in it, else 1.
Image resampledMask(
    const ImageView& mask, const Placement& placement, const std::function<void()>& check = [] {});

} // namespace texloom

#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"

namespace texloom::sparse {

/// About twice the size, by Catmull and Rom's cubic; pixel x of the image lies in the middle of the pixels 2x
/// and 2x + 1. Beyond the ends the image goes on as `wrap` says: from its start, or by its last pixel.
/// @param size of the result.
Image enlargedCubic(const Image& image, Size size, Wrap wrap, JobContext& context);

} // namespace texloom::sparse

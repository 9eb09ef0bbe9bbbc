#pragma once

#include "core/job/job_context.h"
#include "core/match/interleaved.h"

namespace texloom {

/// Every `step`-th pixel of the top left `size` pixels of a canvas, as an image of its first `channels`.
Image canvasImage(const Interleaved& canvas, Size size, int channels, int step, JobContext& context);

} // namespace texloom

#pragma once

#include "core/methods/method.h"
#include "core/methods/pixel_grower.h"

namespace texloom::efros_leung {

/// What growth from coarse to fine has in common, whether a hole is filled or a whole output made.

/// Scales hold windows of this side at least, in pixels, where the output's are as large; smaller ones show
/// too little.
inline constexpr int kLeastWindow = 9;

/// How pixels grow at a scale.
/// @param request at this scale; the window shrinks to what fits its exemplars and masks.
/// @param coarsest whether there is no guess: few windows are then all compared, more by components.
pixel_growth::Settings settingsAt(const Request& request, const pixel_growth::Settings& settings, int level,
                                  bool coarsest, JobContext& context);

/// What a scale takes of the work of `levels` of them, each a fixed share of the next finer one; all add
/// to 1.
double shareOfScale(int level, int levels);

/// Growth's settings whose memory is that of all scales.
pixel_growth::Settings largestAtAnyScale(pixel_growth::Settings settings);

} // namespace texloom::efros_leung

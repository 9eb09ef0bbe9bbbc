#pragma once

namespace texloom {

/// The point whose weighted sum of distances to all others is smallest.
/// @param points `count` points of `dimension` values (at most 16), one after another; @param weights of the
/// points, above 0.
/// @param result `dimension` values: where to start on entry, the median on return.

/// A step shorter than `tolerance` times the mean distance ends it.
/// Weiszfeld's iteration with the step of Vardi & Zhang (PNAS 2000), which may pass through the points.
void geometricMedian(const float* points, const float* weights, int count, int dimension, float* result,
                     double tolerance = 1e-6);

/// Douglas–Rachford splitting of the consensus problem (Gutierrez, thesis 2020, eq. 3.26) with γ a quarter of
/// the mean distance from the start. At most 64 points.
void geometricMedianByDouglasRachford(const float* points, const float* weights, int count, int dimension,
                                      float* result);

} // namespace texloom

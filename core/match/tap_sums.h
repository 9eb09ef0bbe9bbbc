#pragma once

namespace texloom {

/// to[i] = Σ_t weights[t] × taps[t][i] for i from 0 to length − 1, added in the order of the taps: a
/// correlation of rows with few weights, whose sums stay in registers. The same bits on every machine.
/// @param taps `count` rows of at least `length` floats, of any alignment.
void sumTaps(const float* const* taps, const float* weights, int count, int length, float* to);

} // namespace texloom

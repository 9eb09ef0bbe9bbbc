#pragma once

#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice.h"

namespace texloom {

/// The offset of the top of the parabola through three values one apart, −0.5 to 0.5.
double parabolaTop(double before, double here, double after);

/// The lattice that comes nearest to the maxima of γ at all its multiples, by least squares, reduced: a
/// fraction of a pixel. The same lattice where γ has no such maxima nearby.
Lattice fitted(const CorrelationPeaks& peaks, const Lattice& rough);

} // namespace texloom

#pragma once

#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice.h"

namespace texloom {

/// The offset of the vertex of the parabola through three values one apart, −0.5 to 0.5.
double parabolaTop(double before, double here, double after);

/// The least-squares fit of a lattice to the maxima of γ at all its multiples, reduced, accurate to a
/// fraction of a pixel. The lattice unchanged where γ has no such maxima nearby.
Lattice fitted(const CorrelationPeaks& peaks, const Lattice& rough);

} // namespace texloom

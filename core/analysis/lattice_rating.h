#pragma once

#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice_candidate.h"

namespace texloom {

/// Eq. 3.22 for a mean γ over `multiples` multiples.
double goodnessOf(double correlation, double multiples);

/// Eq. 3.22 from the nearest multiples alone: quick, to sort very many lattices.
double roughGoodness(const CorrelationPeaks& peaks, const Lattice& lattice);

/// The lattice with its goodness, over all significant multiples; 0 where one of the vectors has none, as in
/// the source.
LatticeCandidate rated(const CorrelationPeaks& peaks, const Lattice& lattice);

/// From 0 to 1: how far γ at the multiples stands out from γ at all points between them, in height and
/// against its scatter. Chance lattices, of which the best of very many is looked at, have few multiples.
double confidenceIn(const CorrelationPeaks& peaks, const LatticeCandidate& candidate);

/// How γ changes along rows, as a mean over all multiples of a lattice whose points lie on them, from place
/// to place within the lattice's period.
struct PlaceEffect {
    double dip = 0; ///< by what share it falls from the highest to the lowest place
    /// The variance between places over that of such means by chance (the F of an analysis of variance):
    /// about 1 if the rows lie against each other at random.
    double ratio = 0;
};

/// @param along unit vector of the rows. @param distance between those rows that hold points of the lattice,
/// in pixels.
PlaceEffect placeEffect(const CorrelationPeaks& peaks, const Lattice& lattice, Vec2 along, double distance);

} // namespace texloom

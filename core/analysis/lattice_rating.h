#pragma once

#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice_candidate.h"

namespace texloom {

/// Eq. 3.22 for a mean γ over `multiples` multiples. @param alpha see LatticeCriteria
double goodnessOf(double correlation, double multiples, double alpha);

/// Eq. 3.22 from the nearest multiples alone: quick, to sort very many lattices.
double roughGoodness(const CorrelationPeaks& peaks, const Lattice& lattice);

/// The lattice with its goodness, over all significant multiples; 0 where one of the vectors has none, as in
/// the source.
LatticeCandidate rated(const CorrelationPeaks& peaks, const Lattice& lattice);

/// From 0 to 1: how far γ at the multiples stands out from γ at all points between them, in height and
/// against its scatter. Lattices found by chance, as the best of very many, have few multiples.
double confidenceIn(const CorrelationPeaks& peaks, const LatticeCandidate& candidate);

/// How γ varies along rows within the lattice's period, averaged over all multiples of a lattice whose points
/// lie on the rows.
struct PlaceEffect {
    double dip = 0; ///< relative drop from the highest to the lowest place
    /// The variance between places relative to that of such means by chance (the F of an analysis of
    /// variance): about 1 if the rows are shifted at random against each other.
    double ratio = 0;
};

/// @param along unit vector of the rows. @param distance between those rows that hold points of the lattice,
/// in pixels.
PlaceEffect placeEffect(const CorrelationPeaks& peaks, const Lattice& lattice, Vec2 along, double distance);

} // namespace texloom

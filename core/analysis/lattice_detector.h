#pragma once

#include "core/analysis/correlation.h"
#include "core/analysis/lattice_candidate.h"
#include "core/image/image.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// What is known of a texture's regularity: everything that a window shows.
struct LatticeAnalysis {
    /// γ of the exemplar with itself, with slow changes of light removed.
    Correlation correlation;
    /// γ of the exemplar's edges, where the lattice was found in those; else empty.
    Correlation edges;
    /// The lattice, then at most three runners-up, best first: plausible alternatives. Empty if nothing in
    /// the exemplar repeats.
    std::vector<LatticeCandidate> candidates;
    /// From 0 to 1: how far the first candidate stands out from what a texture without a lattice gives.
    double confidence = 0;
    LatticeCriteria criteria; ///< by which they were chosen

    /// Whether the first candidate is reliable.
    bool found() const { return !candidates.empty() && confidence >= 0.5; }
    bool foundInEdges() const { return !edges.size().empty(); }
    /// The γ that lattices are rated by.
    const Correlation& rating() const { return foundInEdges() ? edges : correlation; }
};

/// Finds the two shortest vectors by which a near-regular texture repeats itself (López Recas 2011,
/// section 3.3): pairs of local maxima of γ, rated by the mean of γ at their multiples with a preference for
/// smaller tiles. Beyond the source: a quadratic surface of light is first subtracted from each channel,
/// every pair is fitted to the maxima at all its multiples, to a fraction of a pixel, and lattices with two
/// and three times the points of a good one are tried as well. Where that finds nothing, it is done again
/// with the exemplar's edges (edgesOf()), and with five and seven times the points: colours of bricks differ,
/// their joints are alike. A vector is found if the exemplar is about twice as long. Where only rows repeat
/// (findRows()), the lattice has a vector of one pixel along them, and lattices that explain nothing within
/// the rows are left out. Where nothing repeats, but rows run through the whole exemplar (findOrderedRows()),
/// their direction is the result. The runners-up include the smallest tile that is half as good, the rows,
/// and the best of the edges or colours in which nothing was found.
/// @param check called every few milliseconds; may throw.
LatticeAnalysis analyzeLattice(
    const ImageView& exemplar, const std::function<void()>& check = [] {},
    const LatticeCriteria& criteria = {});

/// A lattice drawn roughly by hand, fitted to the maxima of γ at all its multiples and rated as the
/// candidates are. Its vectors stay near those drawn and are not reduced.
/// @param check called every few milliseconds; may throw.
LatticeCandidate fittedLattice(
    const LatticeAnalysis& analysis, const Lattice& rough, const std::function<void()>& check = [] {});

/// A lattice as it is, rated as the candidates are: how well the exemplar agrees with one set by hand.
/// @param check called every few milliseconds; may throw.
LatticeCandidate ratedLattice(
    const LatticeAnalysis& analysis, const Lattice& lattice, const std::function<void()>& check = [] {});

/// Upper bound of the memory that analyzeLattice() takes, and a rough time on one thread.
std::uint64_t latticeBytesFor(Size exemplar, int channels);
double latticeSecondsFor(Size exemplar);

} // namespace texloom

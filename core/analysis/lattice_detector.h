#pragma once

#include "core/analysis/correlation.h"
#include "core/analysis/lattice_candidate.h"
#include "core/image/image.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// What is known of a texture's regularity: all that a window shows of it.
struct LatticeAnalysis {
    /// γ of the exemplar with itself, its slow changes of light taken out.
    Correlation correlation;
    /// The lattice, then at most three runners-up, best first: lattices that someone may want instead. Empty
    /// if nothing in the exemplar repeats.
    std::vector<LatticeCandidate> candidates;
    /// From 0 to 1: how far the first candidate stands out from what a texture without a lattice gives.
    double confidence = 0;

    /// Whether the first candidate is to be relied on.
    bool found() const { return !candidates.empty() && confidence >= 0.5; }
};

/// Finds the two shortest vectors by which a near-regular texture repeats itself (López Recas 2011,
/// section 3.3): pairs of local maxima of γ, rated by the mean of γ at their multiples with some favour to
/// the smaller tile. Past the source: a quadratic surface of light is taken out of each channel first, every
/// pair is fitted to the maxima at all its multiples, which gives fractions of a pixel, and lattices with two
/// and three times the points of a good one are tried as well. A vector is found if the exemplar is about two
/// of it long. Where only rows repeat (findRows()), the lattice has a vector of one pixel along them:
/// lattices that explain nothing of what lies in the rows are left out. Where nothing repeats, but rows run
/// through the whole exemplar (findOrderedRows()), their direction is the answer. Among the runners-up are
/// the smallest tile that is half as good, and the rows.
/// @param check called every few milliseconds; may throw.
LatticeAnalysis analyzeLattice(
    const ImageView& exemplar, const std::function<void()>& check = [] {});

/// A lattice that someone saw and drew roughly: fitted to the maxima of γ at all its multiples, and rated as
/// the candidates are. Its vectors stay near those drawn, rather than reduced.
/// @param correlation of the analysis. @param check called every few milliseconds; may throw.
LatticeCandidate fittedLattice(
    const Correlation& correlation, const Lattice& rough, const std::function<void()>& check = [] {});

/// Upper bound of the memory that analyzeLattice() takes, and a rough time on one thread.
std::uint64_t latticeBytesFor(Size exemplar, int channels);
double latticeSecondsFor(Size exemplar);

} // namespace texloom

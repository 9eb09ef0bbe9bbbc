#pragma once

#include "core/analysis/lattice.h"

namespace texloom {

/// What decides between lattices; the source's numbers unless told otherwise (López Recas 2011,
/// section 3.3.1).
struct LatticeCriteria {
    /// α of eq. 3.22, at least 1: how much smaller tiles, which have more multiples, are preferred. 1: not at
    /// all.
    double alpha = 1.12;
    /// From 0 to 1: the share of a tile by which the moved exemplar must overlap itself for a multiple to
    /// count.
    double significance = 0.85;

    friend bool operator==(const LatticeCriteria&, const LatticeCriteria&) = default;
};

/// A lattice that a texture may have, and how well it fits.
struct LatticeCandidate {
    Lattice lattice; ///< reduced, accurate to a fraction of a pixel
    /// (Σ γ)^α / n over the n significant multiples of the vectors (eq. 3.22; LatticeCriteria).
    double goodness = 0;
    double correlation = 0; ///< mean γ over those multiples
    int multiples = 0;      ///< n
};

} // namespace texloom

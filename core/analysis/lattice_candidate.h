#pragma once

#include "core/analysis/lattice.h"

namespace texloom {

/// A lattice that a texture may have, and how well it fits.
struct LatticeCandidate {
    Lattice lattice; ///< reduced, accurate to a fraction of a pixel
    /// (Σ γ)^α / n over the n significant multiples of the vectors, α = 1.12 (eq. 3.22).
    double goodness = 0;
    double correlation = 0; ///< mean γ over those multiples
    int multiples = 0;      ///< n
};

} // namespace texloom

#pragma once

#include "core/methods/causal_synthesis.h"

namespace texloom::analogy {

/// Parameters of image analogies (Hertzmann et al., SIGGRAPH 2001).
struct Settings {
    int neighbourhood = 5;  ///< side in pixels; an even one counts as the next odd
    int levels = 4;         ///< scales, at most; each is half the one before
    double coherence = 5;   ///< κ
    double guideWeight = 3; ///< how much the unfiltered pictures count beside the filtered ones
    int leaf = 8;           ///< most neighbourhoods in a leaf of the tree

    CausalOptions options() const {
        CausalOptions options;
        options.side = oddSide(neighbourhood);
        options.levels = levels;
        options.leaf = leaf;
        options.coherence = coherence;
        options.falloff = true;
        return options;
    }
};

} // namespace texloom::analogy

#pragma once

#include "core/methods/causal_synthesis.h"

namespace texloom::wei_levoy {

/// How the nearest neighbourhood is found.
enum class Search { Tree, Exact };

/// Parameters of the causal synthesis of Wei & Levoy (SIGGRAPH 2000).
struct Settings {
    int neighbourhood = 9; ///< side in pixels; an even one counts as the next odd
    int levels = 4;        ///< scales, at most; each is half the one before
    int parent = 3;        ///< side of the square that is compared on the next coarser scale; 0 for none
    Search search = Search::Tree;
    int leaf = 8;   ///< most neighbourhoods in a leaf of the tree
    int passes = 1; ///< on each scale; those after the first compare whole squares

    CausalOptions options() const {
        CausalOptions options;
        options.side = oddSide(neighbourhood);
        options.levels = levels;
        options.parent = parent > 0 ? oddSide(parent) : 0;
        options.exact = search == Search::Exact;
        options.leaf = leaf;
        options.passes = passes;
        return options;
    }
};

} // namespace texloom::wei_levoy

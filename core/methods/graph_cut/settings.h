#pragma once

namespace texloom::graph_cut {

/// How the place of the exemplar that is pasted next is chosen.
enum class Placement { Random, Entire, SubPatch };

/// Parameters of graph-cut textures (Kwatra et al. 2003).
struct Settings {
    Placement placement = Placement::Entire;
    int patch = 32;         ///< side of the square that is compared, in pixels
    double tolerance = 0.1; ///< k: a place of cost C is drawn in proportion to exp(−C / (k σ²))
    int refine = 10;        ///< bad seams that are mended at the end
    bool gradient = true;   ///< seams cost less where the pictures change anyway
};

} // namespace texloom::graph_cut

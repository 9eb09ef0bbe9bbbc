#pragma once

#include "core/methods/patch_fields.h"

namespace texloom::patch_assignment {

/// Where the exemplar's patches lie: at every stride-th pixel, at random, or at random but on the finest
/// scale.
enum class Grid { Regular, Random, Hybrid };

/// Which patches there are for an output of another size: all of them equally often, or drawn at random.
enum class Supply { Duplicate, Bootstrap };

/// How the geometric median is found.
enum class Median { Weiszfeld, DouglasRachford };

/// Parameters of patch assignment (Gutierrez, thesis 2020, algorithm 1 and sections 3.4 and 3.5).
struct Settings {
    int patch = 8;             ///< side w; patches lie w/4 apart
    int scales = 3;            ///< at most
    int coarseIterations = 50; ///< at most, on each scale but the finest
    int fineIterations = 10;
    Grid grid = Grid::Regular;
    double epsilon = 0;   ///< of the auction, for colours from 0 to 1; 0: the optimal assignment
    bool relaxed = false; ///< whether patches may be used more or less often than they should
    double rho = 5;       ///< ρ: the cost of each such use
    Supply supply = Supply::Duplicate;
    Median median = Median::Weiszfeld;
    PatchFinish finish = PatchFinish::Blend;

    int stride() const { return patch / 4; }
};

} // namespace texloom::patch_assignment

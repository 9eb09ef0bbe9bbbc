#pragma once

#include "core/methods/patch_fields.h"

namespace texloom::patch_assignment {

/// Where the exemplar's patches lie: at every stride-th pixel, at random, or at random but on the finest
/// scale.
enum class Grid { Regular, Random, Hybrid };

/// Which patches there are for an output of another size: all of them equally often, or drawn at random.
enum class Supply { Duplicate, Bootstrap };

/// How the assignment is found: whole, from all costs at once, or narrowed to a few choices of each patch;
/// automatic: whole where that takes minutes at most.
enum class Solve { Automatic, Whole, Narrowed };

/// How overlapping patches are joined: the geometric median (r = 1), the mean (r = 2), iteratively reweighted
/// means (r = 0.8), the same with a Gaussian over the patch (fig. 3.14).
enum class Aggregation { Median, Mean, Robust, RobustFalloff };

/// How the geometric median is found.
enum class Median { Weiszfeld, DouglasRachford };

/// Parameters of patch assignment (Gutierrez, thesis 2020, algorithm 1 and sections 3.4 and 3.5).
struct Settings {
    int patch = 8;             ///< side w; patches lie w/4 apart
    int scales = 3;            ///< at most
    int coarseIterations = 50; ///< at most, on each scale but the finest
    int fineIterations = 10;
    Grid grid = Grid::Regular;
    Solve solve = Solve::Automatic;
    double epsilon = 0;           ///< of the auction, for colours from 0 to 1; 0: the optimal assignment
    bool constantEpsilon = false; ///< whether ε stays the same on the finest scale, as published
    /// Where assignments are not optimal, iterations end when the cost falls by less than this share: the
    /// last changes only choose among equals. On scales on which others build, by an eighth of it. 0: none
    /// ends.
    double settle = 0.04;
    bool relaxed = false; ///< whether patches may be used more or less often than they should
    double rho = 5;       ///< ρ: the cost of each such use
    Supply supply = Supply::Duplicate;
    Aggregation aggregation = Aggregation::Median;
    Median median = Median::Weiszfeld;
    PatchFinish finish = PatchFinish::Blend;

    int stride() const { return patch / 4; }
};

} // namespace texloom::patch_assignment

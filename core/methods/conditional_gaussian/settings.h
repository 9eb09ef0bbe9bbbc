#pragma once

#include "core/match/patch_grid.h"

namespace texloom::conditional_gaussian {

/// How the pixels that a patch shares with its neighbours are treated: they stay as they are (CLG), or are
/// varied a little first (RCLG).
enum class Model { Exact, Relaxed };

/// Which patch of the conditional Gaussian is placed.
enum class Choose { Sample, MostProbable };

/// Parameters of conditional locally Gaussian synthesis (Raad, thesis 2016, algorithms 3 and 4).
struct Settings {
    int patch = 40;     ///< side n in pixels
    int neighbours = 5; ///< m: patches that a Gaussian is learnt from; 30 in the source
    double overlap = 0.5;
    int border = 4; ///< of what is there, in pixels, that a patch is drawn to continue; 0, all, in the source
    Model model = Model::Exact;
    double theta = 5; ///< θ in per cent of the exemplars' standard deviation
    Choose choose = Choose::Sample;
    double sigma = 5;    ///< σ in per cent of the exemplars' standard deviation
    double contrast = 1; ///< see ContrastBalance::share; 0 in the source
    bool bounded = true; ///< see boundPatch(); not in the source

    int overlapPixels() const { return overlapFor(patch, overlap); }
};

} // namespace texloom::conditional_gaussian

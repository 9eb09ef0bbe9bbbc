#pragma once

#include "core/match/patch_stitch.h"

namespace texloom::multiscale_gaussian {

/// Parameters of multiscale locally Gaussian synthesis (Raad, thesis 2016, algorithm 5).
struct Settings {
    int patch = 20;     ///< side n in pixels, at every scale
    int neighbours = 5; ///< m: patches that a Gaussian is learnt from; 20 to 50 in the source
    int scales = 3;     ///< K: the exemplar and its halves
    /// How patches join at all scales but the coarsest. The source pastes them (None).
    PatchStitch stitch = PatchStitch::Cut;
    /// How they join at the coarsest scale. The source averages, which halves what patches differ in.
    PatchStitch coarsest = PatchStitch::Cut;
    double contrast = 1; ///< see ContrastBalance::share; 0 in the source
    bool bounded = true; ///< see boundPatch(); not in the source

    int overlapPixels() const { return patch / 2; }
};

} // namespace texloom::multiscale_gaussian

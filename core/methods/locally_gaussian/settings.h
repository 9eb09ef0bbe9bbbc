#pragma once

#include "core/match/patch_grid.h"
#include "core/match/patch_stitch.h"

namespace texloom::locally_gaussian {

/// Parameters of locally Gaussian synthesis (Raad, thesis 2016, algorithm 2).
struct Settings {
    int patch = 30;       ///< side n in pixels
    int neighbours = 10;  ///< m: patches that a Gaussian is learnt from
    double overlap = 0.5; ///< o as a share of the patch
    PatchStitch stitch = PatchStitch::Cut;
    double contrast = 1; ///< see ContrastBalance::share; 0 in the source
    bool bounded = true; ///< see boundPatch(); not in the source

    int overlapPixels() const { return overlapFor(patch, overlap); }
};

} // namespace texloom::locally_gaussian

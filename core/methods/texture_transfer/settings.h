#pragma once

#include "core/match/patch_grid.h"

#include <algorithm>
#include <cmath>

namespace texloom::texture_transfer {

/// Parameters of texture transfer (Efros & Freeman, SIGGRAPH 2001, section 4).
struct Settings {
    int patch = 40;         ///< side in the first pass, in pixels
    double overlap = 0.25;  ///< as a share of the patch
    double tolerance = 0.1; ///< ε: a patch up to (1 + ε) times as far as the nearest may be drawn
    int passes = 3;         ///< N
    double firstAlpha = 0.1;
    double lastAlpha = 0.9;
    double blur = 2;        ///< σ in pixels of the luminance that is compared; 0 for none
    bool matchTones = true; ///< whether the target's luminance gets the mean and deviation of the exemplars'

    static constexpr int kLeastPatch = 5;

    /// α of a pass, from 0: how much the overlap counts; the rest is the target's. 1 is plain quilting.
    double alpha(int pass) const {
        const double at = passes > 1 ? static_cast<double>(pass) / (passes - 1) : 0.5;
        return firstAlpha + (lastAlpha - firstAlpha) * at;
    }
    /// Side of the patches of a pass, from 0: two thirds of that before, and at least kLeastPatch.
    int patchOf(int pass) const {
        const auto side = static_cast<int>(std::lround(patch * std::pow(2.0 / 3, pass)));
        return std::min(patch, std::max(kLeastPatch, side));
    }
    int overlapOf(int pass) const { return overlapFor(patchOf(pass), overlap); }
};

} // namespace texloom::texture_transfer

#pragma once

#include "core/match/patch_grid.h"
#include "core/math/waves.h"

namespace texloom::fourier_mask {

/// Parameters of quilting along the regular part (Nicoll, Meseth, Müller & Klein 2005).
struct Settings {
    double threshold = 0.25; ///< least height of a peak of the spectrum, over the highest
    int waves = 24;          ///< at most
    double weight = 1;       ///< of the regular part beside the overlap
    int patch = 32;          ///< side in pixels
    double overlap = 0.25;   ///< as a share of the patch
    double tolerance = 0.1;  ///< ε: a patch up to (1 + ε) times as far as the nearest may be drawn

    int overlapPixels() const { return overlapFor(patch, overlap); }
    WaveOptions waveOptions() const { return {threshold, waves}; }
};

} // namespace texloom::fourier_mask

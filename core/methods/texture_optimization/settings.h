#pragma once

#include "core/methods/patch_fields.h"

namespace texloom::texture_optimization {

/// How the nearest patch is found.
enum class Search { Exact, PatchMatch };

/// How overlapping patches are joined: the mean (r = 2), iteratively reweighted least squares (r = 0.8), the
/// same with a Gaussian over the patch, or the geometric median.
enum class Aggregation { Mean, Robust, RobustFalloff, Median };

/// Parameters of texture optimisation (Kwatra et al. 2005; Gutierrez, thesis 2020, sections 3.1 and 3.2).
struct Settings {
    int scales = 3;        ///< at most
    int iterations = 8;    ///< at most, for each patch width of each scale
    int largestPatch = 32; ///< widths are 32, 16 and 8 px up to this
    Aggregation aggregation = Aggregation::RobustFalloff;
    Search search = Search::Exact;
    bool histogram = false;     ///< match colour histograms (section 3.2.1)
    bool bidirectional = false; ///< exemplar patches choose, too (section 3.2.2)
    double alpha = 0.5;         ///< share of the forward energy where both directions count
    double uniformity = 0;      ///< λ_occ of the spatial uniformity (section 3.2.3)
    PatchFinish finish = PatchFinish::Blend;
};

} // namespace texloom::texture_optimization

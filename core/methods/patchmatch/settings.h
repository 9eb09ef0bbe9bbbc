#pragma once

namespace texloom::patchmatch {

/// Parameters of multiscale PatchMatch synthesis.
struct Settings {
    int patch = 7;         ///< side in pixels
    int iterations = 5;    ///< rounds of matching and voting on each scale
    int scales = 4;        ///< at most; each is half the one before
    double uniformity = 1; ///< λ_occ: how much more a patch costs that is used as often as all are on average
};

} // namespace texloom::patchmatch

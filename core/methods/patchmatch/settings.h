#pragma once

namespace texloom::patchmatch {

/// Parameters of multiscale PatchMatch synthesis.
struct Settings {
    int patch = 7;         ///< side in pixels
    int iterations = 5;    ///< rounds of matching and voting on each scale
    int scales = 4;        ///< at most; each is half the one before
    double uniformity = 1; ///< λ_occ: extra cost of a patch that is used as often as the average
    int radius = 0;        ///< in exemplars of the output's size, how far a hole's sources lie; 0: anywhere
    int context = 200;     ///< where a hole is filled, how far around it is copied from; see withoutHole()
    bool seams = true; ///< where a hole is filled, whether seams between copies are moved; see moveSeams()
    bool tone = true;  ///< where a hole is filled, whether its tone is evened out; see evenTone()
};

} // namespace texloom::patchmatch

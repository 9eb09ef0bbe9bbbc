#pragma once

#include "core/match/patch_grid.h"
#include "core/match/patch_quilter.h"
#include "core/methods/synthesis.h"

namespace texloom::quilting {

/// Parameters of image quilting (Raad & Galerne, IPOL 2017, algorithm 1).
struct Settings {
    int patch = 40;                               ///< side w_p in pixels
    double overlap = QuiltOptions::kUsualOverlap; ///< w_o as a share of the patch
    /// ε: a patch up to (1 + ε) times as far as the nearest may be drawn
    double tolerance = QuiltOptions::kUsualTolerance;
    PatchStitch stitch = PatchStitch::Cut; ///< how a new patch is joined to what is there
    int softness = 3;                      ///< half the width in pixels over which a smooth cut blends
    double contrast = QuiltOptions::kUsualContrast; ///< see ContrastBalance::share; 0 in the source
    double variety = QuiltOptions::kUsualVariety;   ///< see QuiltOptions::variety; 0 in the source
    int radius = 0;    ///< in exemplars of the output's size, how far a hole's sources lie; 0: anywhere
    int context = 200; ///< where a hole is filled, how far around it is copied from; see withoutHole()
    bool seams = true; ///< where a hole is filled, whether seams between copies are moved; see joinCopies()
    bool tone = true;  ///< where a hole is filled, whether its tone is evened out; see evenTone()

    /// Whether every pixel of a filled hole is copied from one patch, so that copies can be moved and evened.
    bool copies() const { return stitch == PatchStitch::Cut || stitch == PatchStitch::Poisson; }
    /// Not for the Poisson stitch, which joins copies of different brightness, too.
    bool movesSeams() const { return seams && stitch == PatchStitch::Cut; }
    bool evensTone() const { return stitch == PatchStitch::Poisson || (tone && copies()); }

    /// w_o in pixels.
    int overlapPixels() const { return overlapFor(patch, overlap); }
    /// What the quilter is told; refers to the request.
    QuiltOptions quiltOptions(const Request& request) const {
        QuiltOptions options;
        options.size = request.size;
        options.wrap = request.wrap;
        options.patch = patch;
        options.overlap = overlapPixels();
        options.tolerance = tolerance;
        options.contrast = contrast;
        options.variety = variety;
        options.stitch = stitch;
        options.softness = stitch == PatchStitch::SmoothCut ? softness : 0;
        options.initial = request.initial();
        return options;
    }
};

} // namespace texloom::quilting

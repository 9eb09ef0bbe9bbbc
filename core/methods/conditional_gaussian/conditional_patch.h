#pragma once

#include "core/image/image.h"
#include "core/match/patch_distances.h"

#include <span>

namespace texloom::conditional_gaussian {

/// How a patch is drawn.
struct Drawing {
    double sigma = 0; ///< σ, in the values' unit
    /// Only pixels of the overlap at most so far from what is drawn are given, in pixels; 0: all of them.
    int border = 0;
    /// How far a sample gets the contrast of the patches, which one that is bound to what it hardly explains
    /// lacks: 0, as it is drawn, to 1.
    double contrast = 0;
    bool bounded = false; ///< whether what is drawn is kept within what the patches show: see boundPatch()
};

/// Draws a patch from the Gaussian of `patches` plus white noise of deviation σ, given its pixels on the
/// overlap (Raad, thesis 2016, algorithm 3): these stay as they are in `known`, the others get the
/// conditional model's part of low rank. Their own white noise is left to the caller.
/// Where an output closes, more pixels are given than the model can fit, so at the right and bottom the drawn
/// patch fades into the existing pixels.
/// @param known patch × patch, read on the overlap. @param normals one standard normal number for each patch,
/// or none for the most probable patch, eq. 3.5. @param fresh gets the result.
void conditionPatch(std::span<const ImageView> patches, const Image& known, const Overlap& overlap,
                    const Drawing& drawing, std::span<const double> normals, Image& fresh);

} // namespace texloom::conditional_gaussian

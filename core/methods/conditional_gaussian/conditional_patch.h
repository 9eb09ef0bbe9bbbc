#pragma once

#include "core/image/image.h"
#include "core/match/patch_distances.h"

#include <span>

namespace texloom::conditional_gaussian {

/// Draws a patch from the Gaussian of `patches` plus white noise of deviation σ, given its pixels on the
/// overlap (Raad, thesis 2016, algorithm 3): these stay as they are in `known`, the others get the
/// conditional model's part of low rank. Their own white noise is left to the caller.
/// Where an output closes, more pixels are given than the model can fit, so at the right and bottom the drawn
/// patch fades into the existing pixels.
/// @param known patch × patch, read on the overlap. @param normals one standard normal number for each patch,
/// or none for the most probable patch, eq. 3.5. @param fresh gets the result.
void conditionPatch(std::span<const ImageView> patches, const Image& known, const Overlap& overlap,
                    double sigma, std::span<const double> normals, Image& fresh);

} // namespace texloom::conditional_gaussian

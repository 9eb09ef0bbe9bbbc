#pragma once

#include "core/image/image.h"
#include "core/match/patch_distances.h"

namespace texloom {

/// Weights of the old pixels of a patch, 0 to 1, by which a fresh one is joined to what is there. Each fills
/// all of `weight`, which is patch × patch like `old` and `fresh`.

/// 1 beyond the boundary of least error and 0 within it (see minimumErrorCut()).
/// @param softness 0 for a sharp cut, else half the width in pixels over which it blends: the mean over
/// squares of the cut's weights.
/// @param error working memory of the patch's size. @return the error along the cut.
double cutWeights(const ImageView& old, const ImageView& fresh, const Overlap& overlap, int softness,
                  PlaneSpan error, PlaneSpan weight);

/// One half on the overlap (Raad, thesis 2016, eq. 3.14).
void averageWeights(const Overlap& overlap, PlaneSpan weight);

/// From 1 at the outer border of the overlap down to 0 at the inner: 1 − (1 − α)(1 − β) of Raad's thesis
/// 2016, section 2.2, with more factors where an output closes.
void rampWeights(const Overlap& overlap, PlaneSpan weight);

} // namespace texloom

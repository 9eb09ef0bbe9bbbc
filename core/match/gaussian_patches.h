#pragma once

#include "core/image/image.h"
#include "core/job/random.h"
#include "core/match/patch_grid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace texloom {

/// The Gaussian of m patches has their mean μ and the covariance PPᵗ/(m − 1), where the columns of P are the
/// patches minus μ (Raad, thesis 2016, eq. 2.1; the double sum printed there is a slip). Its samples are μ +
/// P a/√(m − 1), that is, weighted sums of the patches themselves, so no matrix is ever formed.

/// The weights that give the vector with coefficients a: they add up to 1.
std::vector<double> gaussianWeights(std::span<const double> coefficients);

/// The sum of patches times weights. @param to of the patches' size and channels.
void combinePatches(std::span<const ImageView> patches, std::span<const double> weights, Image& to);

/// Keeps a patch drawn from the Gaussian of others within what they show: at every pixel its lightness, the
/// mean over the channels, and its colour, what the channels differ from it by, are drawn towards those of
/// the patches' mean until they lie between the least and the greatest of the patches there. A Gaussian goes
/// on where its patches end, and mirrors at their mean what only some of them show: that makes sparks whiter
/// and blacker than any, and colours opposite to the exemplar's.
/// @param to of the patches' size and channels.
void boundPatch(std::span<const ImageView> patches, Image& to);

/// Standard normal numbers for the patch at a place of the grid: draws `first` onwards.
std::vector<double> normalNumbers(const Random& random, const PatchCell& cell, std::size_t count,
                                  std::uint32_t first = 0);

/// Draws a vector of the Gaussian of these patches for a place of the grid, with draws `first` onwards.
/// @param bounded whether it is kept within what the patches show: see boundPatch().
void drawPatch(std::span<const ImageView> patches, const Random& random, const PatchCell& cell,
               std::uint32_t first, bool bounded, Image& to);

/// The standard deviation of each value over the patches, averaged over all values: σ̄ of Raad's thesis 2016,
/// section 2.2. 0 for a single patch.
double meanPatchDeviation(std::span<const ImageView> patches);

} // namespace texloom

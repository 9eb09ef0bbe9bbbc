#pragma once

#include "core/base/param.h"
#include "core/image/image.h"
#include "core/match/blend.h"
#include "core/match/patch_distances.h"

#include <array>
#include <map>
#include <vector>

namespace texloom {

/// Weights of the old pixels of a patch, 0 to 1, by which a fresh one is joined to the existing pixels. Each
/// fills all of `weight`, which is patch × patch like `old` and `fresh`.

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

/// Mixes the old pixels into a fresh patch by these weights.
void mixPatches(const ImageView& old, const PlaneView& weight, Image& fresh);

/// How a patch is joined to the existing pixels: along the cut of least error, sharp or smoothed; by the mean
/// on the overlap (by a ramp where the output closes and every border is known); or not at all, so that the
/// new patch hides what it overlaps; by Poisson or midway blending in the middle of the overlap; or by a ramp
/// over all of it (Liang et al., "Real-time texture synthesis by patch-based sampling", 2001).
enum class PatchStitch { Cut, SmoothCut, Average, None, Poisson, Midway, Feather };

/// The entries of a PatchStitch parameter.
std::vector<Choice> patchStitchChoices();

/// Joins patches in one way. One object serves any number of threads, each with its own Scratch.
class PatchStitcher {
public:
    struct Scratch {
        Image error, weight;
    };

    PatchStitcher(PatchStitch stitch, int patch, const MidwayOptions& midway = {});

    /// Prepares for an overlap; not to be called while other threads join.
    void prepare(const Overlap& overlap);

    Scratch scratch() const;
    /// Turns `fresh` into the patch to be placed. @param old the patch as it is on the canvas, known on
    /// `overlap`.
    void join(const ImageView& old, const Overlap& overlap, Image& fresh, Scratch& scratch) const;
    /// How much of each pixel that join() makes is the old one's, 0 to 1; where it blends, 1 on the old side
    /// of the middle of the overlap and 0 on the new. Not for cuts, whose shares are those of cutWeights().
    void shares(const Overlap& overlap, PlaneSpan weight) const;

    /// Upper bound of the memory that a stitcher for these overlaps and the joins of `threads` threads take.
    /// @param overlaps how many different ones.
    static std::uint64_t bytesFor(PatchStitch stitch, int patch, int overlap, int overlaps, int threads);

private:
    bool blends() const { return m_stitch == PatchStitch::Poisson || m_stitch == PatchStitch::Midway; }
    void blend(const ImageView& old, const Overlap& overlap, Image& fresh) const;

    PatchStitch m_stitch;
    int m_patch;
    MidwayOptions m_midway;
    /// By the overlap's widths: left, top, right, bottom.
    std::map<std::array<int, 4>, std::vector<BlendBand>> m_bands;
};

} // namespace texloom

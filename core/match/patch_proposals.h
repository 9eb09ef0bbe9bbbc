#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/match/grid_match.h"

#include <vector>

namespace texloom {

/// Reduces colours that are too frequent: Kopf's histogram matching (Gutierrez, thesis 2020, eq. 3.8) with
/// the histograms of the last round, so that pixels do not depend on the order in which they are made.
class ColorBalance {
public:
    /// @param images the exemplars, channels side by side.
    ColorBalance(const std::vector<const Interleaved*>& images, int channels);
    /// Compares the histograms of `canvas` (its top left `size` pixels) with the exemplars'.
    void compare(const Interleaved& canvas, Size size);
    /// Factor for the weight of a proposed pixel: at most 1.
    float factor(const float* pixel) const;

private:
    static constexpr int kBins = 16;
    std::size_t bin(const float* pixel, int channel) const;
    std::vector<double> histogram(const Interleaved& image, Size size) const;

    int m_channels;
    std::vector<float> m_low, m_scale; ///< by channel
    std::vector<double> m_wanted;      ///< share of each bin of each channel
    std::vector<float> m_excess;       ///< excess over the wanted share, relative to it
};

/// Weights of a patch's pixels, row by row: a Gaussian with a standard deviation of a quarter of the patch
/// (Kwatra et al., SIGGRAPH 2005).
std::vector<float> gaussianFalloff(int patch);

/// What the overlapping patches of a lattice propose for the pixels of its canvas.
struct PatchProposals {
    std::vector<const Interleaved*> images; ///< by exemplar
    PatchLattice lattice;
    const PatchField* field = nullptr;
    std::vector<float> weights; ///< of each patch of the lattice, row by row
    std::vector<float> falloff; ///< of each pixel of a patch, row by row; empty: all the same
    /// Further sources that the patches propose, those of patch i from extraBegin[i] to extraBegin[i + 1].
    std::vector<int> extraBegin;
    std::vector<Source> extra;
    float extraWeight = 1;
    const ColorBalance* balance = nullptr;
};

/// Joins the proposals for one row of the canvas. One object for each thread.
class ProposalRow {
public:
    explicit ProposalRow(const PatchProposals& proposals);

    /// The weighted mean (Gutierrez, eq. 3.5 and 3.7). @param pixels the row of the canvas, channels side by
    /// side.
    void mean(int y, float* pixels);
    /// The weighted geometric median (eq. 3.18), by Weiszfeld's iteration or Douglas–Rachford splitting.
    enum class Solver { Weiszfeld, DouglasRachford };
    void median(int y, Solver solver, float* pixels);
    /// For each pixel the proposed source whose pixel is nearest to that of `pixels`.
    void nearest(int y, const float* pixels, Source* sources) const;

private:
    template <class Visit> void everyRun(int y, const Visit& visit) const;
    template <class Visit>
    void visitPatch(int column, int line, const Source& first, float weight, const Visit& visit) const;
    template <int Pixel> void meanOf(int y, float* pixels);
    template <int Pixel> void nearestOf(int y, const float* pixels, Source* sources) const;
    void collect(int y);

    const PatchProposals& m_proposals;
    int m_pixel;
    std::vector<float> m_weight;      ///< of each pixel of the row
    std::vector<float> m_points;      ///< proposals, pixel by pixel of the row
    std::vector<float> m_pointWeight; ///< weights of the proposals
    std::vector<int> m_count;         ///< number of proposals of each pixel
    int m_most = 0;                   ///< capacity for each pixel
};

/// For each pixel of a canvas the proposed source whose pixel is nearest to it.
/// @param canvas of proposals.lattice.canvas pixels or more. @param exemplars their sizes.
PositionMap nearestProposed(const PatchProposals& proposals, const Interleaved& canvas,
                            std::vector<Size> exemplars, JobContext& context);

} // namespace texloom

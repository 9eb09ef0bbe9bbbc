#pragma once

#include "core/job/job_context.h"
#include "core/match/interleaved.h"
#include "core/match/patch_match.h"
#include "core/methods/patch_assignment/settings.h"

#include <span>
#include <vector>

namespace texloom::patch_assignment {

/// The exemplars' patches on one scale: those that are to be assigned. Exemplars are mirrored at their
/// borders, so that patches lie around every pixel of the grid.
class ExemplarPatches {
public:
    /// The number of similar patches kept for each patch, at most.
    static constexpr int kSimilar = 6;
    /// The largest rounding error of a cost or of a bound, as a share of it.
    static constexpr float kRounding = 1e-5F;

    ExemplarPatches(std::span<const PatchSource> sources, const Settings& settings, bool random,
                    JobContext& context);

    int count() const { return static_cast<int>(m_sources.size()); }
    /// Patches that are equal to the bit, as flat parts have them, are of one kind: they are assigned as one
    /// patch of several places, since they would outbid each other for ever. Kinds are numbered in the order
    /// of their first patches.
    int kinds() const { return static_cast<int>(m_begin.size()) - 1; }
    int kindOf(int patch) const { return m_kind[static_cast<std::size_t>(patch)]; }
    /// The patches of a kind, in reading order.
    std::span<const int> members(int kind) const {
        const auto k = static_cast<std::size_t>(kind);
        return std::span(m_members).subspan(static_cast<std::size_t>(m_begin[k]),
                                            static_cast<std::size_t>(m_begin[k + 1] - m_begin[k]));
    }
    /// Top left pixel of each patch in the mirrored exemplars.
    const std::vector<Source>& sources() const { return m_sources; }
    /// The mirrored exemplars.
    std::vector<const Interleaved*> images() const;
    /// The same pixel in the exemplar itself.
    Source unmirrored(const Source& source) const;
    /// The patch nearest to a place in a mirrored exemplar, or −1 far from any.
    int nearest(int exemplar, int x, int y) const;
    /// How often each patch should be used by `wanted` patches, in the order in which they are handed out:
    /// all once, at random, then all again; by the mask's values where there is one, and by the exemplars'
    /// weights.
    std::vector<int> supply(int wanted, Supply kind, JobContext& context) const;

    /// Costs are for patches in this form: pixels of one channel after another.
    int patchFloats() const { return m_area * m_channels; }
    void planar(const float* pixels, std::ptrdiff_t stride, float* to) const;
    /// Sum over the pixels of the Euclidean distance between colours, ‖·‖₁,₂, of two patches.
    float distance(const float* planar, const float* other) const;
    float cost(const float* planar, int kind) const { return distance(planar, own(kind)); }
    /// The costs of the kinds from `first` on, `last` excluded.
    void costs(const float* planar, int first, int last, float* to) const;
    void costs(const float* planar, std::span<const int> kinds, float* to) const;

    /// Sums of a patch over 2 × 2 pixels, in the form of planar(). The distance between sums is a lower bound
    /// of the sum of distances between colours.
    int sumFloats() const { return m_sumArea * m_channels; }
    void sums(const float* planar, float* to) const;
    /// Lower bounds of the costs, with a minus sign (see AssignmentCosts), in a quarter of the time.
    void bounds(const float* sums, int first, int last, float* to) const;

    /// kSimilar patches similar to each one.
    void findSimilar(JobContext& context);
    const int* similar(int patch) const {
        return m_similar.data() + static_cast<std::ptrdiff_t>(patch) * kSimilar;
    }

private:
    void add(const PatchSource& source);
    void choose(std::span<const PatchSource> sources, bool random, JobContext& context);
    const float* own(int kind) const {
        return m_planar.data() + static_cast<std::ptrdiff_t>(kind) * patchFloats();
    }
    void sort(JobContext& context);
    double weightOf(const PatchSource& source, int x, int y) const;

    int m_patch, m_stride, m_channels, m_area, m_sumArea, m_pad;
    std::vector<Size> m_sizes;
    std::vector<Interleaved> m_images;
    std::vector<Source> m_sources;
    std::vector<double> m_weights;
    std::vector<int> m_kind;                 ///< of each patch
    std::vector<int> m_members, m_begin;     ///< of each kind, and where its own begin
    std::vector<float> m_planar, m_sums;     ///< of each kind
    std::vector<std::vector<int>> m_nearest; ///< by exemplar and cell of the grid
    std::vector<int> m_similar;
};

} // namespace texloom::patch_assignment

#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/patch_match.h"
#include "core/match/patch_target.h"

#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// Overlapping patches of an image that closes on itself on both axes, one at every `stride`-th pixel.
struct PatchLattice {
    Size canvas; ///< of the image
    int patch = 8;
    int stride = 2;

    /// Patches in each direction.
    Size count() const {
        return {(canvas.width + stride - 1) / stride, (canvas.height + stride - 1) / stride};
    }
};

/// Finds similar patches for all patches of a lattice, starting from existing matches: the rounds of
/// PatchMatch (Barnes et al., SIGGRAPH 2009) for an image that changes from one round to the next.
class GridMatcher {
public:
    /// Fills `to` with the rectangle of `extent` pixels of the canvas at (x, y), which may wrap around the
    /// border. Called on any thread.
    using Gather = std::function<void(int x, int y, Size extent, Interleaved& to)>;

    /// @param sources copied; each with at least one patch.
    GridMatcher(std::span<const PatchSource> sources, const PatchLattice& lattice, JobContext& context);

    const PatchLattice& lattice() const { return m_lattice; }
    const PatchTarget& target(int exemplar) const { return m_targets[static_cast<std::size_t>(exemplar)]; }
    int exemplars() const { return static_cast<int>(m_targets.size()); }

    /// An allowed patch, drawn for place (x, y).
    Source any(int x, int y) const;
    /// `source` if it is an allowed patch, else one drawn for place (x, y).
    Source allowed(const Source& source, int x, int y) const;

    /// Makes patches that are used often cost more from now on: Kaspar's spatial uniformity (Gutierrez,
    /// thesis 2020, eq. 3.10–3.12), with the mean distance of the matches as the unit. The penalty is
    /// averaged with the previous one: all patches choose at once, and would otherwise all abandon a good one
    /// together.
    /// @param weight λ_occ; 0 for none.
    void discourage(const PatchField& field, double weight);

    /// What limit() leaves.
    struct Limit {
        const std::vector<std::uint8_t>* patches =
            nullptr;    ///< of the lattice by rows, 1 where matches are wanted
        int radius = 0; ///< how far from its own place a match may lie, in both directions, in pixels, in
                        ///< exemplars of the canvas's size; 0: anywhere
    };
    /// Leaves out patches, whose sources in fields stay invalid, and far matches.
    /// @param limit what it refers to must outlive the matcher.
    void limit(const Limit& limit) { m_limit = limit; }

    /// One round over all patches: the distance to the current match is recomputed, then those of the
    /// neighbours' matches and of random ones at most `radius` pixels away are tried.
    /// @param round number of the round; it determines the direction of the scan and the random numbers.
    void improve(PatchField& field, const Gather& gather, int round, int radius);

    static std::uint64_t bytesFor(std::span<const Size> exemplars, int channels, int patch, int stride,
                                  int threads);

private:
    struct Tile {
        int left, top, right, bottom;
    };
    Tile tile(int number) const;
    void improveTile(PatchField& field, const Gather& gather, int number, int round, int radius);
    void improvePatch(PatchField& field, int x, int y, const float* patch, std::ptrdiff_t stride, int round,
                      int radius) const;
    float penalty(const Source& source) const;
    bool wanted(int x, int y) const {
        return !m_limit.patches || (*m_limit.patches)[static_cast<std::size_t>(y) *
                                                          static_cast<std::size_t>(m_lattice.count().width) +
                                                      static_cast<std::size_t>(x)] != 0;
    }
    bool anyWanted(const Tile& area) const;

    PatchLattice m_lattice;
    Size m_tiles;
    int m_channels;
    JobContext& m_context;
    std::vector<PatchTarget> m_targets;
    std::vector<std::vector<float>> m_penalties; ///< by exemplar and position; empty: none
    std::int64_t m_count = 0;
    Limit m_limit;
    Pool<Interleaved> m_pool;
};

} // namespace texloom

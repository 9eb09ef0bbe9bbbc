#pragma once

#include "core/image/position_map.h"
#include "core/match/interleaved.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// A k-d tree over patches by their first principal components: a patch is looked up in one leaf, whose few
/// patches are likely among the nearest, and identical ones always are there. Random starts rarely hit a
/// match at a single position, so PatchMatch starts from the leaves, as in propagation-assisted k-d trees (He
/// & Sun, CVPR 2012). nanoflann's exact search over the same numbers takes 12 to 38 times as long for each
/// lookup (11 to 23 µs here, 8 neighbours, 512² exemplars, patches of 4 to 16 px), for patches 2 to 8 %
/// nearer.
class PatchTree {
public:
    /// Most patches in a leaf.
    static constexpr int kLeaf = 8;

    /// @param images to find patches in. @param has says whether the patch with this top left pixel may be
    /// found. @param check called every few milliseconds; may throw.
    PatchTree(std::span<const Interleaved* const> images, int channels, int patch,
              const std::function<bool(const Source&)>& has, const std::function<void()>& check);

private:
    /// Four sums at once: left to itself, the compiler vectorises the wrong dimension.
    using Vector = float __attribute__((vector_size(16)));
    static constexpr int kAxes = 8;
    using Descriptor = std::array<float, kAxes>;

public:
    /// The leaves near one patch, the patch's own first.
    class Lookup {
    public:
        /// @param pixels where the patch begins, a row of it every `stride` floats.
        Lookup(const PatchTree& tree, const float* pixels, std::ptrdiff_t stride);
        /// The patches in the next leaf: the one across the nearest of the splits passed so far. Empty when
        /// there is none.
        std::span<const Source> next();

    private:
        struct Branch {
            float gap = 0;
            int node = 0;
        };
        static constexpr int kBranches = 4;
        void remember(const Branch& branch);

        const PatchTree& m_tree;
        Descriptor m_descriptor{};
        int m_next = -1;
        std::array<Branch, kBranches> m_other{}; ///< by increasing gap
        int m_others = 0;
    };

private:
    struct Entry {
        Descriptor descriptor;
        Source source;
    };
    struct Node {
        int axis = -1; ///< negative: a leaf
        float split = 0;
        int first = 0, second = 0; ///< children, or begin and end of the leaf
    };

    void learnAxes(std::span<const Interleaved* const> images, int channels);
    Descriptor describe(const float* pixels, std::ptrdiff_t stride) const;
    int divide(std::vector<Entry>& entries, int begin, int end, const std::function<void()>& check);

    int m_patch;
    int m_pixel;
    std::vector<Vector> m_weights; ///< kAxes for each float of a patch, by rows
    std::vector<Node> m_nodes;
    std::vector<Source> m_sources;
};

} // namespace texloom

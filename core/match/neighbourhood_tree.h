#pragma once

#include "core/job/job_context.h"
#include "core/match/neighbourhood.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// Finds neighbourhoods that are nearly the nearest in time that grows with the logarithm of their number:
/// tree-structured vector quantisation (Wei & Levoy, SIGGRAPH 2000). The set is divided again and again by
/// 2-means, and a search goes down to the nearer centroid. It is done on the vectors' first principal
/// components, which hold nearly all of their variance at a tenth of the cost; the vectors that it meets are
/// compared whole.
class NeighbourhoodTree {
public:
    struct Options {
        int leaf = 8;           ///< most neighbourhoods that are not divided any more
        int axes = 16;          ///< most principal components
        double variance = 0.95; ///< share of the variance that is enough
    };

    /// Calls body(i) for each i from 0 to count − 1, in any order, on any threads.
    using Each = std::function<void(int count, const std::function<void(int)>& body)>;
    /// One after the other.
    static void inTurn(int count, const std::function<void(int)>& body);

    /// @param set must outlive the tree. @param check called every few milliseconds; may throw. @param each
    /// does what can be done at the same time.
    NeighbourhoodTree(const NeighbourhoodSet& set, const Options& options, const std::function<void()>& check,
                      const Each& each = &NeighbourhoodTree::inTurn);
    /// On the threads of a job.
    NeighbourhoodTree(const NeighbourhoodSet& set, const Options& options, JobContext& context);

    /// The leaves near a vector, its own first.
    class Lookup {
    public:
        Lookup(const NeighbourhoodTree& tree, const float* wanted);
        /// The neighbourhoods of the next leaf: the one beyond the most doubtful of the divisions that were
        /// passed so far. Empty when there is none.
        std::span<const Source> next();

    private:
        struct Branch {
            float doubt = 0; ///< how much nearer the centroid was that was followed
            int node = 0;
        };
        static constexpr std::size_t kBranches = 24;
        void remember(const Branch& branch);

        const NeighbourhoodTree& m_tree;
        std::vector<float> m_descriptor;
        int m_next = 0;
        std::array<Branch, kBranches> m_others{}; ///< by rising doubt
        std::size_t m_count = 0;
    };

    /// The nearest of those in the first `leaves` leaves, of equal ones the first in order of reading.
    Source nearest(const float* wanted, int leaves) const;

    /// Upper bound of the bytes that a tree takes while it is made.
    static std::uint64_t bytesFor(std::span<const Size> exemplars, const Options& options);

private:
    struct Node {
        int left = -1, right = -1; ///< children, or none in a leaf
        int begin = 0, end = 0;
        std::size_t centroids = 0; ///< where those of the children are
    };
    using Check = std::function<void()>;

    void learnAxes(const Options& options, const Check& check);
    void describe(const float* vector, float* descriptor) const;
    void divide(std::vector<int>& order, int leaf, const Check& check, const Each& each);
    void divideLevel(std::vector<int>& order, std::span<const int> nodes, const Check& check,
                     const Each& each);
    int partition(std::vector<int>& order, int begin, int end, float* centroids) const;
    void spread(const std::vector<int>& order, int begin, int end, int step, float* centroids,
                int& axis) const;
    void twoMeans(const std::vector<int>& order, int begin, int end, int step, float* centroids) const;
    bool nearerFirst(const float* descriptor, const float* centroids) const;
    const float* descriptorOf(int entry) const {
        return m_descriptors.data() + static_cast<std::size_t>(entry) * static_cast<std::size_t>(m_axes);
    }

    const NeighbourhoodSet& m_set;
    int m_axes = 0;               ///< floats of a descriptor
    std::vector<int> m_chosen;    ///< floats of a vector that it is made of
    std::vector<float> m_weights; ///< m_axes for each of them
    std::vector<float> m_descriptors;
    std::vector<Node> m_nodes;
    std::vector<float> m_centroids;
    std::vector<Source> m_sources; ///< leaf by leaf
};

} // namespace texloom

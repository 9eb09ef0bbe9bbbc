#pragma once

#include "core/job/job_context.h"
#include "core/match/neighbourhood_tree.h"
#include "core/match/patch_match.h"

#include <span>
#include <vector>

namespace texloom::jump_map {

/// A place of the exemplar whose surroundings look like another's.
struct Jump {
    Source to;
    float likeness = 0; ///< 1: the same; 0: no more alike than two places drawn at random
};

/// For every pixel of the exemplars the places that look most like it, at least some way from it and from
/// each other, so that jumps lead to different parts (Zelinka & Garland, "Towards real-time texture synthesis
/// with the jump map", EGWR 2002, section 3).
class JumpLists {
public:
    /// @param set the pixels that may be jumped to and from; must outlive the lists. @param count of jumps
    /// for each pixel, at most. @param apart least distance in pixels.
    JumpLists(const NeighbourhoodSet& set, int count, int apart, JobContext& context);

    /// By falling likeness; fewer than wanted where an exemplar has no more that are nearly as alike as the
    /// best.
    std::span<const Jump> of(const Source& source) const;

    static std::uint64_t bytesFor(std::span<const Size> exemplars, int count);

private:
    void find(std::size_t number, const NeighbourhoodTree& tree, double unlike);
    double meanDistance(const Random& random) const;
    bool farFrom(const Source& one, const Source& other) const;

    const NeighbourhoodSet& m_set;
    int m_count, m_apart;
    std::vector<std::vector<int>> m_numbers; ///< of each exemplar's pixels in the set, row by row
    std::vector<Jump> m_jumps;               ///< m_count for each
};

} // namespace texloom::jump_map

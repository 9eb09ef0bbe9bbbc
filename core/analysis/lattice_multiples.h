#pragma once

#include "core/analysis/lattice.h"

#include <algorithm>
#include <cmath>

namespace texloom {

/// Longest vector searched for, as a share of the exemplar, into which it must fit about twice.
inline constexpr double kLongestVector = 0.55;
/// Shortest vector that can be distinguished from the maximum of γ at 0, in pixels.
inline constexpr double kShortestVector = 3.5;

/// The largest number of multiples of a lattice's vectors that fit in the displacements of an exemplar.
inline int ringsOf(Size exemplar, const Lattice& lattice) {
    // Height of the parallelogram over each side: how many rows of the lattice fit in the reach.
    const double longest = std::hypot(exemplar.width, exemplar.height);
    const double height = lattice.area() / std::max(lattice.v1.length(), lattice.v2.length());
    return static_cast<int>(std::ceil(longest / std::max(1.0, height)));
}

/// Visits the multiples a v1 + b v2 with |a|, |b| ≤ rings in one half plane, without 0, at which the exemplar
/// overlaps itself by a few pixels: visit(a, b, point).
template <class Visit> void eachMultiple(Size exemplar, const Lattice& lattice, int rings, Visit visit) {
    constexpr int kMargin = 3;
    for (int b = 0; b <= rings; ++b)
        for (int a = b == 0 ? 1 : -rings; a <= rings; ++a) {
            const Vec2 p = lattice.at(a, b);
            if (std::abs(p.x) + kMargin < exemplar.width && std::abs(p.y) + kMargin < exemplar.height)
                visit(a, b, p);
        }
}

/// Whether (a, b) belongs to an evenly spread subset of a few thousand multiples, which are as good as all.
class Thinned {
public:
    /// @param rings as eachMultiple().
    Thinned(Size exemplar, const Lattice& lattice, int rings) {
        constexpr double kEnough = 1500;
        const double all = std::min(2.0 * static_cast<double>(exemplar.area()) / lattice.area(),
                                    2.0 * rings * (rings + 1.0));
        m_step = std::max(1, static_cast<int>(all / kEnough));
    }
    bool keeps(int a, int b) const { return (a + b) % m_step == 0; }

private:
    int m_step = 1;
};

/// Whether the overlap of an exemplar with itself, moved by this much, holds the bounding box of the
/// lattice's tile.
inline bool overlapHoldsTile(Size exemplar, const Lattice& lattice, Vec2 displacement) {
    const Vec2 extent = lattice.extent();
    return exemplar.width - std::round(std::abs(displacement.x)) >= extent.x + 1 &&
           exemplar.height - std::round(std::abs(displacement.y)) >= extent.y + 1;
}

/// Whether an exemplar moved by this much overlaps itself by at least this share of the lattice's tile
/// (section 3.3.1).
inline bool significant(Size exemplar, const Lattice& lattice, Vec2 displacement, double share) {
    if (overlapHoldsTile(exemplar, lattice, displacement))
        return true;
    const Size overlap{exemplar.width - static_cast<int>(std::lround(std::abs(displacement.x))),
                       exemplar.height - static_cast<int>(std::lround(std::abs(displacement.y)))};
    if (static_cast<double>(overlap.area()) < share * lattice.area())
        return false;
    return tileCoverage(lattice, overlap) >= share;
}

} // namespace texloom

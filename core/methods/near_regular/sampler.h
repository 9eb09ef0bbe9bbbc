#pragma once

#include "core/analysis/lattice.h"
#include "core/job/random.h"
#include "core/methods/near_regular/border_match.h"
#include "core/methods/near_regular/layout.h"

#include <vector>

namespace texloom::near_regular {

/// Where patches that look like a block of the output lie in the exemplar: at the multiples of the lattice
/// vectors from the place of the block (López Recas 2011, section 4.2.1). Points name a patch by its top left
/// pixel.
class Sampler {
public:
    /// @param exemplar its size. @param from the lattice in the exemplar. @param to the lattice in the
    /// output, which differs where the output wraps. @param origin the exemplar's point at the output's top
    /// left. @param match says which patches the mask allows; there must be one.
    Sampler(Size exemplar, const Lattice& from, const Lattice& to, Vec2 origin, const Layout& layout,
            const Random& random, const BorderMatch& match);

    /// Whether patches may come from anywhere.
    bool free() const { return m_from.free(); }
    /// All patches that lie on the lattice, to the nearest pixel.
    std::vector<Point> alike(Cell cell) const;
    /// One of alike(), drawn by the block's place; the allowed patch nearest to one where there is none.
    Point drawn(Cell cell) const;
    Size positions() const { return m_positions; }

private:
    Vec2 target(Cell cell) const;
    bool inOrder(const Point& p) const;
    Point nearestAllowed(Cell cell) const;

    Size m_positions;
    Lattice m_from, m_to;
    Vec2 m_origin;
    const Layout& m_layout;
    const Random& m_random;
    const BorderMatch& m_match;
    bool m_ordered;               ///< rows keep the order of the exemplar
    std::vector<Point> m_allowed; ///< all patches, row by row, where a mask leaves some out
};

} // namespace texloom::near_regular

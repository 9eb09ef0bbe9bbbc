#pragma once

#include "core/job/random.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/tile_colours.h"

#include <vector>

namespace texloom::wang_tiles {

/// Which tile lies in which cell of an output.
class Tiling {
public:
    /// Sides of the cells along an axis: tiles in full from the first pixel on; on an axis that wraps, as
    /// many as it takes, narrower where need be, so that they close.
    static std::vector<int> lengths(int output, int tile, bool wraps);

    /// Full sets: the colour of every edge or corner is drawn by its place, so that any cell is known alone.
    /// Compact ones: cells are taken in reading order, each one of the two tiles that fit what is above and
    /// to the left.
    Tiling(const Request& request, const Settings& settings, const Random& random);

    int columns() const { return static_cast<int>(m_widths.size()); }
    int rows() const { return static_cast<int>(m_heights.size()); }
    const std::vector<int>& widths() const { return m_widths; }
    const std::vector<int>& heights() const { return m_heights; }
    Colours colours(int column, int row) const;

private:
    int drawn(int column, int row, std::uint32_t axis) const;
    Colours begun(int column, int row) const;
    void fillCompact();

    Match m_match;
    int m_colours;
    Random m_random;
    std::vector<int> m_widths, m_heights;
    std::vector<Colours> m_compact; ///< by cell; empty for full sets
};

} // namespace texloom::wang_tiles

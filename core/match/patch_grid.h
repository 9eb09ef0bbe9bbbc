#pragma once

#include "core/image/size.h"
#include "core/match/patch_distances.h"

#include <vector>

namespace texloom {

/// The width in pixels of an overlap given as a share of the patch: at least 1, at most half the patch.
int overlapFor(int patch, double share);

/// Where patches lie along one axis of the output.
class PatchAxis {
public:
    /// @param length of the output, in pixels; @param overlap wanted, at most half the patch. On an axis that
    /// does not wrap the last patch may reach beyond the output. On one that wraps the patches divide the
    /// length evenly, so that overlaps differ by a pixel and may be a little wider.
    PatchAxis(int length, int patch, int overlap, bool wraps);

    int count() const { return static_cast<int>(m_starts.size()); }
    int start(int index) const { return m_starts[static_cast<std::size_t>(index)]; }
    bool wraps() const { return m_wraps; }
    /// Pixels that the canvas needs.
    int canvas() const { return m_canvas; }
    /// Width of the overlap of patch `index` with the one before it, across the border where the axis wraps.
    int overlapBefore(int index) const;
    /// Width of the overlap of patch `index` with the one after it.
    int overlapAfter(int index) const { return overlapBefore((index + 1) % count()); }

private:
    std::vector<int> m_starts;
    int m_patch;
    int m_canvas;
    bool m_wraps;
};

/// One patch of the output: its place in the grid and on the canvas, and where it meets earlier ones.
struct PatchCell {
    int column = 0, row = 0;
    int x = 0, y = 0;
    Overlap overlap;
};

/// The patches of an output in the order of synthesis, row by row. Where the x axis wraps, each row begins
/// one patch further right than the row above, so that rows can still follow each other in a wavefront
/// although every row closes on itself.
class PatchGrid {
public:
    PatchGrid(const PatchAxis& horizontal, const PatchAxis& vertical);

    const std::vector<PatchCell>& cells() const { return m_cells; }
    const PatchCell& cell(int index) const { return m_cells[static_cast<std::size_t>(index)]; }
    int count() const { return static_cast<int>(m_cells.size()); }
    /// The cells that must be done before cell `index`, of those that come earlier: its predecessor in the
    /// row, and the last one of the row above that it touches (Raad & Galerne, IPOL 2017, section 3.2).
    std::vector<int> before(int index) const;
    /// Earlier cells at most `reach` columns and rows away, across the border where an axis wraps, of those
    /// that before() makes sure of: the same whatever the order in which cells that do not depend on each
    /// other are done.
    std::vector<int> nearby(int index, int reach) const;
    /// Columns or rows between two cells, whichever are more, the shorter way round where an axis wraps.
    int away(int index, int other) const;

private:
    int m_columns, m_rows;
    int m_lag; ///< how many patches the row above must be ahead
    bool m_wrapsX, m_wrapsY;
    std::vector<PatchCell> m_cells;
};

} // namespace texloom

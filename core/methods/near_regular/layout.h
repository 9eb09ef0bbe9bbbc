#pragma once

#include "core/image/size.h"

#include <utility>
#include <vector>

namespace texloom::near_regular {

/// Where blocks lie along one axis. On an axis that does not wrap, they all have the same length and continue
/// without bound in both directions, so that a block does not depend on the output's size; on one that wraps
/// an even number of blocks, whose lengths differ by a pixel at most, divides the output.
class Axis {
public:
    /// @param block length in pixels; on an axis that wraps, the largest allowed.
    Axis(int length, int block, bool wraps);

    bool wraps() const { return m_count > 0; }
    /// Number of blocks on an axis that wraps.
    int count() const { return m_count; }
    int start(int index) const;
    int length(int index) const { return start(index + 1) - start(index); }
    /// The block that holds a pixel.
    int at(int pixel) const;
    /// The index from 0 that stands for the same block.
    int identity(int index) const { return wraps() ? ((index % m_count) + m_count) % m_count : index; }
    /// The shortest block over the longest.
    double evenness() const;

private:
    int m_length;
    int m_block;
    int m_count = 0;
};

/// A block of the output by column and row. As on a chessboard, those with an even sum are sampled at random,
/// the others are the gaps between them.
struct Cell {
    int column = 0, row = 0;

    bool sampled() const { return ((column + row) & 1) == 0; }
    friend bool operator==(const Cell&, const Cell&) = default;
    friend bool operator<(const Cell& a, const Cell& b) {
        return std::pair(a.column, a.row) < std::pair(b.column, b.row);
    }
};

/// All blocks of an output, and the patches that fill them: squares of one side, which reach beyond the block
/// by half a border at the top and left, and at least as far at the bottom and right.
class Layout {
public:
    /// @param block side in pixels, which becomes a little less where an axis wraps. @param border even, at
    /// most half the block.
    Layout(Size output, const Wrap& wrap, int block, int border);

    const Axis& horizontal() const { return m_horizontal; }
    const Axis& vertical() const { return m_vertical; }
    int patch() const { return m_patch; }
    int reach() const { return m_border / 2; }
    Cell at(int x, int y) const { return {m_horizontal.at(x), m_vertical.at(y)}; }
    Cell identity(Cell cell) const {
        return {m_horizontal.identity(cell.column), m_vertical.identity(cell.row)};
    }
    /// The sampled block that a pixel belongs to as long as no gap is filled: its own, or, in a gap, the
    /// neighbour it is nearest to, which makes the borders wedge-shaped (fig. 4.8 b).
    Cell sampledAt(int x, int y) const { return sampledAt(x, y, at(x, y)); }
    /// The same where the pixel's block is known.
    Cell sampledAt(int x, int y, Cell cell) const;
    /// The gaps whose patches touch a part of the output, each by one index, those of even rows first.
    std::vector<Cell> gapsOf(const Region& part) const;

private:
    Axis m_horizontal, m_vertical;
    int m_border;
    int m_patch;
};

} // namespace texloom::near_regular

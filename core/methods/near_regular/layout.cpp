#include "core/methods/near_regular/layout.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <tuple>

namespace texloom::near_regular {

namespace {

int dividedDown(int a, int b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// The block length, not much below the one asked for, for which the axes that wrap divide most evenly:
/// patches are as long as the longest block.
int evenBlock(Size output, const Wrap& wrap, int block) {
    int best = block;
    double evenest = 0;
    for (int length = block; length >= std::max(2, 2 * block / 3); --length) {
        const double shortest = std::min(wrap.x ? Axis(output.width, length, true).evenness() : 1.0,
                                         wrap.y ? Axis(output.height, length, true).evenness() : 1.0);
        if (shortest > evenest + 0.02) {
            evenest = shortest;
            best = length;
        }
    }
    return best;
}

} // namespace

Axis::Axis(int length, int block, bool wraps) : m_length(length), m_block(block) {
    if (wraps)
        m_count = 2 * ((length + 2 * block - 1) / (2 * block));
}

int Axis::start(int index) const {
    if (!wraps())
        return index * m_block;
    const int round = dividedDown(index, m_count);
    const std::int64_t within = index - static_cast<std::int64_t>(round) * m_count;
    return round * m_length + static_cast<int>(within * m_length / m_count);
}

int Axis::at(int pixel) const {
    if (!wraps())
        return dividedDown(pixel, m_block);
    const int round = dividedDown(pixel, m_length);
    int index = static_cast<int>(static_cast<std::int64_t>(pixel - round * m_length) * m_count / m_length) +
                round * m_count;
    while (start(index + 1) <= pixel)
        ++index;
    while (start(index) > pixel)
        --index;
    return index;
}

double Axis::evenness() const {
    const int shortest = wraps() ? m_length / m_count : m_block;
    return static_cast<double>(shortest) / m_block;
}

Layout::Layout(Size output, const Wrap& wrap, int block, int border)
    : m_horizontal(output.width, evenBlock(output, wrap, block), wrap.x),
      m_vertical(output.height, evenBlock(output, wrap, block), wrap.y), m_border(border),
      m_patch(evenBlock(output, wrap, block) + border) {}

Cell Layout::sampledAt(int x, int y, Cell cell) const {
    if (cell.sampled())
        return cell;
    const int left = x - m_horizontal.start(cell.column), top = y - m_vertical.start(cell.row);
    const int right = m_horizontal.start(cell.column + 1) - 1 - x;
    const int bottom = m_vertical.start(cell.row + 1) - 1 - y;
    const int nearest = std::min({left, top, right, bottom});
    if (left == nearest)
        return {cell.column - 1, cell.row};
    if (right == nearest)
        return {cell.column + 1, cell.row};
    return {cell.column, top == nearest ? cell.row - 1 : cell.row + 1};
}

std::vector<Cell> Layout::gapsOf(const Region& part) const {
    const auto last = [](const Axis& axis, int first, int end) {
        return axis.wraps() ? std::min(end, first + axis.count() - 1) : end;
    };
    // One block further than the patches that touch the part: their cuts run into those of these neighbours.
    const Cell from = at(part.x, part.y), to = at(part.right() - 1, part.bottom() - 1);
    std::set<std::tuple<int, int, int>> order;
    for (int row = from.row - 2; row <= last(m_vertical, from.row - 2, to.row + 2); ++row)
        for (int column = from.column - 2; column <= last(m_horizontal, from.column - 2, to.column + 2);
             ++column)
            if (const Cell cell = identity({column, row}); !cell.sampled())
                order.emplace(cell.row & 1, cell.row, cell.column);
    std::vector<Cell> cells;
    for (const auto& [odd, row, column] : order)
        cells.push_back({column, row});
    return cells;
}

} // namespace texloom::near_regular

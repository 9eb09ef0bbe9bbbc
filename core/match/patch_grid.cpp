#include "core/match/patch_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace texloom {

namespace {

int dividedUp(int a, int b) {
    return (a + b - 1) / b;
}

} // namespace

int overlapFor(int patch, double share) {
    return std::clamp(static_cast<int>(std::lround(share * patch)), 1, patch / 2);
}

PatchAxis::PatchAxis(int length, int patch, int overlap, bool wraps) : m_patch(patch), m_wraps(wraps) {
    const int step = patch - overlap;
    if (!wraps) {
        const int count = length <= patch ? 1 : 1 + dividedUp(length - patch, step);
        for (int i = 0; i < count; ++i)
            m_starts.push_back(i * step);
        m_canvas = m_starts.back() + patch;
        return;
    }
    // At most as many patches as keep every overlap within half the patch, which the wavefront relies on.
    const int count = std::min(dividedUp(length, step), length / dividedUp(patch, 2));
    for (int i = 0; i < count; ++i)
        m_starts.push_back(static_cast<int>(static_cast<std::int64_t>(i) * length / count));
    m_canvas = length;
}

int PatchAxis::overlapBefore(int index) const {
    const int previous = index > 0 ? start(index - 1) : m_starts.back() - m_canvas;
    return m_patch - (start(index) - previous);
}

PatchGrid::PatchGrid(const PatchAxis& horizontal, const PatchAxis& vertical)
    : m_columns(horizontal.count()), m_rows(vertical.count()), m_lag(horizontal.wraps() ? 2 : 1),
      m_wrapsX(horizontal.wraps()), m_wrapsY(vertical.wraps()) {
    for (int row = 0; row < vertical.count(); ++row)
        for (int nth = 0; nth < m_columns; ++nth) {
            const int column = horizontal.wraps() ? (row + nth) % m_columns : nth;
            Overlap overlap;
            if (nth > 0)
                overlap.left = horizontal.overlapBefore(column);
            if (row > 0)
                overlap.top = vertical.overlapBefore(row);
            if (horizontal.wraps() && nth == m_columns - 1)
                overlap.right = horizontal.overlapAfter(column);
            if (vertical.wraps() && row == vertical.count() - 1)
                overlap.bottom = vertical.overlapAfter(row);
            m_cells.push_back({column, row, horizontal.start(column), vertical.start(row), overlap});
        }
}

std::vector<int> PatchGrid::before(int index) const {
    const int row = index / m_columns;
    const int nth = index % m_columns;
    std::vector<int> needed;
    if (nth > 0)
        needed.push_back(index - 1);
    if (row > 0)
        needed.push_back((row - 1) * m_columns + std::min(nth + m_lag, m_columns - 1));
    return needed;
}

int PatchGrid::away(int index, int other) const {
    const auto apart = [](int a, int b, int count, bool wraps) {
        const int straight = std::abs(a - b);
        return wraps ? std::min(straight, count - straight) : straight;
    };
    const PatchCell &one = cell(index), &two = cell(other);
    return std::max(apart(one.column, two.column, m_columns, m_wrapsX),
                    apart(one.row, two.row, m_rows, m_wrapsY));
}

std::vector<int> PatchGrid::nearby(int index, int reach) const {
    const int row = index / m_columns, nth = index % m_columns;
    std::vector<int> found;
    for (int other = 0; other <= row; ++other) {
        const int above = row - other;
        if (std::min(above, m_wrapsY ? m_rows - above : above) > reach)
            continue;
        // Of its own row all before it, of the rows above those that before() waits for.
        const int end = above > 0 ? std::min(m_columns, nth + m_lag * above + 1) : nth;
        for (int n = 0; n < end; ++n)
            if (away(index, other * m_columns + n) <= reach)
                found.push_back(other * m_columns + n);
    }
    return found;
}

} // namespace texloom

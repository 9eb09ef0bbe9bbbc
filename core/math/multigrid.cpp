#include "core/math/multigrid.h"

#include <algorithm>
#include <utility>

namespace texloom {

namespace {

constexpr int kCellsBetweenChecks = 1 << 15;
/// Levels with no more cells than this are not coarsened.
constexpr std::size_t kFewest = 32;
/// At the coarsest level, which must be solved accurately.
constexpr int kSweeps = 8;

/// Allocates in steps, since the system is slow to provide much memory at once.
template <class T>
void fillTo(std::vector<T>& values, std::size_t count, const T& value, const Multigrid::Check& check) {
    constexpr std::size_t kStep = 1 << 18;
    values.reserve(count);
    while (values.size() < count) {
        check();
        values.resize(std::min(count, values.size() + kStep), value);
    }
}

/// The weights of a cell's links to its neighbours.
float linksOf(const std::vector<Multigrid::Cell>& cells, const Multigrid::Cell& cell) {
    return cell.toRight + cell.toDown + cells[static_cast<std::size_t>(cell.left)].toRight +
           cells[static_cast<std::size_t>(cell.up)].toDown;
}

} // namespace

template <class Visit> void Multigrid::each(const Level& level, Visit visit) const {
    const int count = static_cast<int>(level.cells.size()) - 1;
    for (int begin = 0; begin < count; begin += kCellsBetweenChecks) {
        m_check();
        for (int i = begin, end = std::min(count, begin + kCellsBetweenChecks); i < end; ++i)
            visit(static_cast<std::size_t>(i), level.cells[static_cast<std::size_t>(i)]);
    }
}

template <class Visit> void Multigrid::eachBackwards(const Level& level, Visit visit) const {
    for (int end = static_cast<int>(level.cells.size()) - 1; end > 0; end -= kCellsBetweenChecks) {
        m_check();
        for (int i = end - 1, begin = std::max(0, end - kCellsBetweenChecks); i >= begin; --i)
            visit(static_cast<std::size_t>(i), level.cells[static_cast<std::size_t>(i)]);
    }
}

Multigrid::Multigrid(const std::vector<Pixel>& pixels, const std::vector<float>& given, Check check)
    : m_check(std::move(check)) {
    Level finest;
    link(finest, pixels);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        Cell& cell = finest.cells[i];
        cell.toRight = cell.right < static_cast<int>(pixels.size()) ? 1 : 0;
        cell.toDown = cell.down < static_cast<int>(pixels.size()) ? 1 : 0;
    }
    finish(finest, given);
    std::vector<Pixel> places = pixels;
    for (int side = 1; finest.cells.size() > kFewest; side *= 2) {
        Level coarser = coarsened(finest, places, side);
        m_levels.push_back(std::move(finest));
        finest = std::move(coarser);
    }
    m_levels.push_back(std::move(finest));
}

void Multigrid::link(Level& level, const std::vector<Pixel>& pixels) const {
    const int count = static_cast<int>(pixels.size());
    const Cell alone{count, count, count, count};
    fillTo(level.cells, pixels.size() + 1, alone, m_check);
    // Pixels come by rows, so that those above are met in the same order.
    std::size_t above = 0;
    each(level, [&](std::size_t i, const Cell&) {
        const auto [x, y] = pixels[i];
        if (i > 0 && pixels[i - 1].y == y && pixels[i - 1].x == x - 1) {
            level.cells[i].left = static_cast<int>(i) - 1;
            level.cells[i - 1].right = static_cast<int>(i);
        }
        while (pixels[above].y < y - 1 || (pixels[above].y == y - 1 && pixels[above].x < x))
            ++above;
        if (pixels[above].y == y - 1 && pixels[above].x == x) {
            level.cells[i].up = static_cast<int>(above);
            level.cells[above].down = static_cast<int>(i);
        }
    });
}

Multigrid::Level Multigrid::coarsened(Level& finer, std::vector<Pixel>& pixels, int side) const {
    std::vector<Pixel> places;
    finer.parents.resize(pixels.size());
    const auto rowEnd = [&](std::size_t from) {
        std::size_t end = from;
        while (end < pixels.size() && pixels[end].y == pixels[from].y)
            ++end;
        return end;
    };
    // Two rows are merged into one of cells.
    for (std::size_t first = 0; first < pixels.size();) {
        m_check();
        const std::size_t middle = rowEnd(first);
        const bool paired = middle < pixels.size() && pixels[middle].y / 2 == pixels[first].y / 2;
        const std::size_t end = paired ? rowEnd(middle) : middle;
        for (std::size_t a = first, b = middle; a < middle || b < end;) {
            const bool upper = b == end || (a < middle && pixels[a].x / 2 <= pixels[b].x / 2);
            const std::size_t one = upper ? a++ : b++;
            const Pixel place{pixels[one].x / 2, pixels[one].y / 2};
            if (places.empty() || places.back().x != place.x || places.back().y != place.y)
                places.push_back(place);
            finer.parents[one] = static_cast<int>(places.size()) - 1;
        }
        first = end;
    }
    Level level;
    link(level, places);
    // Cells are twice as far apart and their links twice as many: half the sum. Links to given pixels grow
    // less, as they run from the centre of a cell to that of a pixel.
    const float farther = static_cast<float>(side + 1) / static_cast<float>(2 * side + 1);
    std::vector<float> given(places.size(), 0);
    each(finer, [&](std::size_t i, const Cell& cell) {
        const int parent = finer.parents[i];
        const auto number = static_cast<std::size_t>(parent);
        given[number] += farther * std::max(0.0F, cell.diagonal - linksOf(finer.cells, cell));
        if (cell.toRight > 0 && finer.parents[static_cast<std::size_t>(cell.right)] != parent)
            level.cells[number].toRight += 0.5F * cell.toRight;
        if (cell.toDown > 0 && finer.parents[static_cast<std::size_t>(cell.down)] != parent)
            level.cells[number].toDown += 0.5F * cell.toDown;
    });
    finish(level, given);
    pixels = std::move(places);
    return level;
}

void Multigrid::finish(Level& level, const std::vector<float>& given) const {
    std::vector<Cell>& cells = level.cells;
    each(level, [&](std::size_t i, const Cell& cell) {
        cells[i].diagonal = linksOf(cells, cell) + given[i];
        cells[i].inverse = cell.diagonal > 0 ? 1 / cell.diagonal : 0;
    });
    fillTo(level.right, cells.size(), 0.0F, m_check);
    fillTo(level.values, cells.size(), 0.0F, m_check);
}

void Multigrid::multiply(const std::vector<double>& from, std::vector<double>& to) const {
    each(m_levels.front(), [&](std::size_t i, const Cell& cell) {
        const auto value = [&](int neighbour) { return from[static_cast<std::size_t>(neighbour)]; };
        // All weights are 1.
        const double sum = value(cell.left) + value(cell.right) + value(cell.up) + value(cell.down);
        to[i] = static_cast<double>(cell.diagonal) * from[i] - sum;
    });
}

/// Solves the equation of one cell (Gauss–Seidel).
void Multigrid::relax(Level& level, std::size_t i, const Cell& cell) {
    std::vector<float>& values = level.values;
    const auto left = static_cast<std::size_t>(cell.left), up = static_cast<std::size_t>(cell.up);
    const auto right = static_cast<std::size_t>(cell.right), down = static_cast<std::size_t>(cell.down);
    values[i] =
        (level.right[i] + level.cells[left].toRight * values[left] + level.cells[up].toDown * values[up] +
         cell.toRight * values[right] + cell.toDown * values[down]) *
        cell.inverse;
}

void Multigrid::smoothForwards(Level& level) const {
    each(level, [&](std::size_t i, const Cell& cell) { relax(level, i, cell); });
}

void Multigrid::smoothBackwards(Level& level) const {
    eachBackwards(level, [&](std::size_t i, const Cell& cell) { relax(level, i, cell); });
}

void Multigrid::descend(std::size_t number) {
    Level& level = m_levels[number];
    std::fill(level.values.begin(), level.values.end(), 0.0F);
    smoothForwards(level);
    if (number + 1 == m_levels.size()) {
        for (int sweep = 1; sweep < kSweeps; ++sweep) {
            smoothBackwards(level);
            smoothForwards(level);
        }
    } else {
        Level& coarser = m_levels[number + 1];
        std::fill(coarser.right.begin(), coarser.right.end(), 0.0F);
        const std::vector<float>& values = level.values;
        // After a forward sweep from 0, the residual of a cell is what the cells after it contribute, which
        // were still 0.
        each(level, [&](std::size_t i, const Cell& cell) {
            coarser.right[static_cast<std::size_t>(level.parents[i])] +=
                cell.toRight * values[static_cast<std::size_t>(cell.right)] +
                cell.toDown * values[static_cast<std::size_t>(cell.down)];
        });
        descend(number + 1);
        each(level, [&](std::size_t i, const Cell&) {
            level.values[i] += coarser.values[static_cast<std::size_t>(level.parents[i])];
        });
    }
    smoothBackwards(level);
}

const std::vector<float>& Multigrid::precondition() {
    descend(0);
    return m_levels.front().values;
}

} // namespace texloom

#include "core/methods/near_regular/phase_deviation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace texloom::near_regular {

namespace {

/// The places of a tile as cells of about a pixel, cyclic in both directions.
class Cells {
public:
    explicit Cells(const Lattice& lattice)
        : m_lattice(lattice), m_columns(countOf(lattice.v1.length())), m_rows(countOf(lattice.v2.length())) {}

    int columns() const { return m_columns; }
    int rows() const { return m_rows; }
    std::size_t count() const {
        return static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows);
    }
    std::size_t of(int x, int y) const {
        const Vec2 c = m_lattice.coordinates({x + 0.5, y + 0.5});
        return index(static_cast<int>((c.x - std::floor(c.x)) * m_columns),
                     static_cast<int>((c.y - std::floor(c.y)) * m_rows));
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>((row % m_rows + m_rows) % m_rows) *
                   static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>((column % m_columns + m_columns) % m_columns);
    }

private:
    static int countOf(double length) { return std::clamp(static_cast<int>(std::lround(length)), 1, 512); }

    Lattice m_lattice;
    int m_columns, m_rows;
};

/// The standard deviation of the pixels in each cell; the mean of all where a cell has fewer than two.
std::vector<double> deviationsIn(const ImageView& exemplar, const Cells& cells) {
    std::vector<double> squares(cells.count(), 0.0), counts(cells.count(), 0.0);
    std::vector<std::size_t> of;
    for (int y = 0; y < exemplar.height; ++y)
        for (int x = 0; x < exemplar.width; ++x) {
            of.push_back(cells.of(x, y));
            ++counts[of.back()];
        }
    for (int c = 0; c < exemplar.channels; ++c) {
        std::vector<double> sums(cells.count(), 0.0), own(cells.count(), 0.0);
        std::size_t i = 0;
        for (int y = 0; y < exemplar.height; ++y)
            for (int x = 0; x < exemplar.width; ++x, ++i) {
                const auto value = static_cast<double>(exemplar(x, y, c));
                sums[of[i]] += value;
                own[of[i]] += value * value;
            }
        for (std::size_t cell = 0; cell < squares.size(); ++cell)
            if (counts[cell] > 1)
                squares[cell] +=
                    std::max(0.0, own[cell] - sums[cell] * sums[cell] / counts[cell]) / (counts[cell] - 1);
    }
    double mean = 0, known = 0;
    for (std::size_t cell = 0; cell < squares.size(); ++cell)
        if (counts[cell] > 1) {
            squares[cell] = std::sqrt(squares[cell]);
            mean += squares[cell];
            ++known;
        }
    for (std::size_t cell = 0; cell < squares.size(); ++cell)
        if (counts[cell] <= 1)
            squares[cell] = known > 0 ? mean / known : 0;
    return squares;
}

/// Sums over cyclic windows of half the cells around each, along one axis.
std::vector<double> halfSums(const std::vector<double>& values, const Cells& cells, bool alongRows) {
    std::vector<double> sums(values.size(), 0.0);
    const int length = alongRows ? cells.columns() : cells.rows(), half = length / 4;
    for (int row = 0; row < cells.rows(); ++row)
        for (int column = 0; column < cells.columns(); ++column)
            for (int step = -half; step <= half; ++step)
                sums[cells.index(column, row)] +=
                    values[alongRows ? cells.index(column + step, row) : cells.index(column, row + step)];
    return sums;
}

} // namespace

PhaseDeviation phaseDeviation(const ImageView& exemplar, const Lattice& lattice) {
    const Cells cells(lattice);
    const std::vector<double> deviations = deviationsIn(exemplar, cells);
    PhaseDeviation found{Image(exemplar.size(), 1), {}};
    for (int y = 0; y < exemplar.height; ++y)
        for (int x = 0; x < exemplar.width; ++x)
            found.at(x, y, 0) = static_cast<float>(deviations[cells.of(x, y)]);
    const std::vector<double> around = halfSums(halfSums(deviations, cells, true), cells, false);
    const auto best = std::max_element(around.begin(), around.end()) - around.begin();
    const int column = static_cast<int>(best) % cells.columns(),
              row = static_cast<int>(best) / cells.columns();
    found.middle = {(column + 0.5) / cells.columns(), (row + 0.5) / cells.rows()};
    return found;
}

} // namespace texloom::near_regular

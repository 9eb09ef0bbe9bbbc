#include "core/math/crowd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom {

Crowd::Crowd(int column, int begin, int places, int columns)
    : m_column(column), m_begin(begin), m_places(places), m_columns(columns),
      m_side(std::max(1, static_cast<int>(std::sqrt(static_cast<double>(places))))),
      m_blocks((places + m_side - 1) / m_side), m_stale(static_cast<std::size_t>(m_blocks), 1),
      m_lowest(at(m_blocks + 1)), m_row(at(m_blocks + 1)) {}

void Crowd::changed(int place) {
    m_stale[static_cast<std::size_t>((place - m_begin) / m_side)] = 1;
}

void Crowd::refresh(const AssignmentCosts& costs, const std::vector<int>& assigned) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    bool any = false;
    for (int block = 0; block < m_blocks; ++block) {
        if (m_stale[static_cast<std::size_t>(block)] == 0)
            continue;
        any = true;
        m_stale[static_cast<std::size_t>(block)] = 0;
        double* lowest = m_lowest.data() + at(block + 1);
        double* rows = m_row.data() + at(block + 1);
        std::fill_n(lowest, m_columns, kInfinite);
        for (int place = block * m_side; place < std::min(m_places, (block + 1) * m_side); ++place) {
            const int row = assigned[static_cast<std::size_t>(m_begin) + static_cast<std::size_t>(place)];
            const float* values = costs.valuesOf(row);
            const auto here = static_cast<double>(values[m_column]);
            const auto number = static_cast<double>(row);
            for (int j = 0; j < m_columns; ++j) {
                const double change = static_cast<double>(values[j]) - here;
                rows[j] = change < lowest[j] ? number : rows[j];
                lowest[j] = change < lowest[j] ? change : lowest[j];
            }
        }
    }
    if (!any)
        return;
    std::fill_n(m_lowest.data(), m_columns, kInfinite);
    for (int block = 1; block <= m_blocks; ++block) {
        const double* lowest = m_lowest.data() + at(block);
        const double* rows = m_row.data() + at(block);
        for (int j = 0; j < m_columns; ++j) {
            m_row[static_cast<std::size_t>(j)] = lowest[j] < m_lowest[static_cast<std::size_t>(j)]
                                                     ? rows[j]
                                                     : m_row[static_cast<std::size_t>(j)];
            m_lowest[static_cast<std::size_t>(j)] =
                std::min(m_lowest[static_cast<std::size_t>(j)], lowest[j]);
        }
    }
}

} // namespace texloom

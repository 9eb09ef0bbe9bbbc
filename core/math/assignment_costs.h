#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// A matrix of costs for assigning a column to each row: complete, or with only some columns of each row.
/// Costs are not negative.
struct AssignmentCosts {
    int rows = 0;
    int columns = 0;
    /// Row by row. A number with its sign bit set, −0 included, is only a lower bound: its magnitude bounds
    /// the cost from below. Rows with bounds hold all columns, in order.
    std::vector<float> costs;
    /// The columns that the costs of a row belong to, as many for every row; empty: all, in order.
    std::vector<std::int32_t> choices;
    int perRow = 0; ///< costs in a row
    /// Where there are bounds: writes the costs of a row at some columns. Called from several threads.
    std::function<void(int row, std::span<const int> columns, float* to)> cost;

    const float* valuesOf(int row) const {
        return costs.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(perRow);
    }
    float* valuesOf(int row) {
        return costs.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(perRow);
    }
    bool bounded() const { return static_cast<bool>(cost); }
    /// The cost at one place of a row; replaces a bound there.
    float known(int row, int place) {
        float& entry = valuesOf(row)[place];
        if (std::signbit(entry))
            cost(row, {&place, 1}, &entry);
        return entry;
    }
    int column(int row, int place) const {
        return choices.empty() ? place
                               : choices[static_cast<std::size_t>(row) * static_cast<std::size_t>(perRow) +
                                         static_cast<std::size_t>(place)];
    }
    /// The place of a column among those of a row, or −1.
    int place(int row, int column) const {
        if (choices.empty())
            return column;
        const auto begin = choices.begin() + static_cast<std::ptrdiff_t>(row) * perRow;
        const auto found = std::find(begin, begin + perRow, column);
        return found == begin + perRow ? -1 : static_cast<int>(found - begin);
    }
};

} // namespace texloom

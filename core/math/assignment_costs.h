#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// What it costs to give persons objects: for every person a row of costs, of all objects or of some. Costs
/// are not negative.
struct AssignmentCosts {
    int persons = 0;
    int objects = 0;
    /// Row by row. A number with a minus sign, which zero can have, too, is but a bound: the cost is not less
    /// than its magnitude. Rows with bounds hold all objects, in order.
    std::vector<float> costs;
    /// The objects that the costs of a row belong to, as many for every row; empty: all, in order.
    std::vector<std::int32_t> choices;
    int perRow = 0; ///< costs in a row
    /// Where there are bounds: writes what it costs to give a person each of some objects. Called by several
    /// threads at a time.
    std::function<void(int person, std::span<const int> objects, float* to)> cost;

    const float* row(int person) const {
        return costs.data() + static_cast<std::size_t>(person) * static_cast<std::size_t>(perRow);
    }
    float* row(int person) {
        return costs.data() + static_cast<std::size_t>(person) * static_cast<std::size_t>(perRow);
    }
    bool bounded() const { return static_cast<bool>(cost); }
    /// The cost at one place of a row of bounds, which is put there in the bound's place.
    float known(int person, int place) {
        float& entry = row(person)[place];
        if (std::signbit(entry))
            cost(person, {&place, 1}, &entry);
        return entry;
    }
    int object(int person, int place) const {
        return choices.empty() ? place
                               : choices[static_cast<std::size_t>(person) * static_cast<std::size_t>(perRow) +
                                         static_cast<std::size_t>(place)];
    }
    /// The place of an object in a person's row, or −1.
    int place(int person, int object) const {
        if (choices.empty())
            return object;
        const auto begin = choices.begin() + static_cast<std::ptrdiff_t>(person) * perRow;
        const auto found = std::find(begin, begin + perRow, object);
        return found == begin + perRow ? -1 : static_cast<int>(found - begin);
    }
};

} // namespace texloom

#pragma once

#include "core/math/assignment_costs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace texloom {

/// The best and the second best of a row of values.
template <class T> struct BestTwo {
    int place = -1;
    T best = std::numeric_limits<T>::infinity(), second = best;

    void add(int where, T value) {
        if (value < best) {
            second = best;
            best = value;
            place = where;
        } else {
            second = std::min(second, value);
        }
    }
    /// Merges the result of other places. @param rest their second best.
    void add(int where, T value, T rest) {
        if (value == best && where >= 0 && where < place)
            std::swap(where, place);
        add(where, value);
        second = std::min(second, rest);
    }
};

/// As many values as fit a SIMD vector of every machine: compilers split larger ones badly.
template <class T> struct Lanes;
template <> struct Lanes<float> {
    using Pack = float __attribute__((vector_size(16)));
    using Places = std::int32_t __attribute__((vector_size(16)));
    static constexpr int kCount = 4;
    static constexpr Places kFirst = {0, 1, 2, 3};

    static Pack costs(const float* from) { return Pack{from[0], from[1], from[2], from[3]}; }
};
template <> struct Lanes<double> {
    using Pack = double __attribute__((vector_size(16)));
    using Places = std::int64_t __attribute__((vector_size(16)));
    static constexpr int kCount = 2;
    static constexpr Places kFirst = {0, 1};

    static Pack costs(const float* from) {
        return Pack{static_cast<double>(from[0]), static_cast<double>(from[1])};
    }
};

template <class Pack, class T> Pack load(const T* from) {
    Pack values;
    __builtin_memcpy(&values, from, sizeof values);
    return values;
}

/// The two best sums of costs and prices.
template <class T> BestTwo<T> bestTwo(const float* costs, const T* prices, int count) {
    using Lane = Lanes<T>;
    using Pack = typename Lane::Pack;
    using Places = typename Lane::Places;
    Pack best = Pack{} + std::numeric_limits<T>::infinity(), second = best;
    Places where = Places{} - 1, now = Lane::kFirst;
    int i = 0;
    for (; i + Lane::kCount <= count; i += Lane::kCount, now += Lane::kCount) {
        const Pack value = Lane::costs(costs + i) + load<Pack>(prices + i);
        const Places better = value < best;
        const Pack loser = better ? best : value;
        second = loser < second ? loser : second;
        best = better ? value : best;
        where = better ? now : where;
    }
    BestTwo<T> result;
    for (int lane = 0; lane < Lane::kCount; ++lane)
        result.add(static_cast<int>(where[lane]), best[lane], second[lane]);
    for (; i < count; ++i)
        result.add(i, static_cast<T>(costs[i]) + prices[i]);
    return result;
}

/// A column whose cost and price sum to at most `slack` more than the best of the row, with that sum, and a
/// lower bound of all other sums. Bounds that may hide better columns are replaced by costs.
BestTwo<float> bestTwo(AssignmentCosts& costs, int row, const float* prices, float slack);

/// Whether any cost of the row and the column's price sum to less than `limit`.
bool anyBelow(AssignmentCosts& costs, int row, const float* prices, float limit);

} // namespace texloom

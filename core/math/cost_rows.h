#pragma once

#include "core/math/assignment.h"

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
    /// Joins what other places gave. @param rest their second best.
    void add(int where, T value, T rest) {
        if (value == best && where >= 0 && where < place)
            std::swap(where, place);
        add(where, value);
        second = std::min(second, rest);
    }
};

/// As many values as fit a vector of every machine: larger ones are taken apart badly.
template <class T> struct Lanes;
template <> struct Lanes<float> {
    using Values = float __attribute__((vector_size(16)));
    using Places = std::int32_t __attribute__((vector_size(16)));
    static constexpr int kCount = 4;
    static constexpr Places kFirst = {0, 1, 2, 3};

    static Values costs(const float* from) { return Values{from[0], from[1], from[2], from[3]}; }
};
template <> struct Lanes<double> {
    using Values = double __attribute__((vector_size(16)));
    using Places = std::int64_t __attribute__((vector_size(16)));
    static constexpr int kCount = 2;
    static constexpr Places kFirst = {0, 1};

    static Values costs(const float* from) {
        return Values{static_cast<double>(from[0]), static_cast<double>(from[1])};
    }
};

template <class Values, class T> Values load(const T* from) {
    Values values;
    __builtin_memcpy(&values, from, sizeof values);
    return values;
}

/// Costs, or bounds of them.
inline Lanes<float>::Values magnitudes(const float* costs) {
    Lanes<float>::Places bits;
    __builtin_memcpy(&bits, costs, sizeof bits);
    bits &= Lanes<float>::Places{} + std::numeric_limits<std::int32_t>::max();
    Lanes<float>::Values values;
    __builtin_memcpy(&values, &bits, sizeof values);
    return values;
}

/// The two best sums of costs and prices.
template <class T> BestTwo<T> bestTwo(const float* costs, const T* prices, int count) {
    using Lane = Lanes<T>;
    using Values = typename Lane::Values;
    using Places = typename Lane::Places;
    Values best = Values{} + std::numeric_limits<T>::infinity(), second = best;
    Places where = Places{} - 1, now = Lane::kFirst;
    int i = 0;
    for (; i + Lane::kCount <= count; i += Lane::kCount, now += Lane::kCount) {
        const Values value = Lane::costs(costs + i) + load<Values>(prices + i);
        const Places better = value < best;
        const Values loser = better ? best : value;
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

/// Calls `visit` for the places, in order, whose cost, or bound of it, and price sum to less than limit()
/// then.
template <class Limit, class Visit>
void visitBelow(const float* costs, const float* prices, int count, const Limit& limit, const Visit& visit) {
    using Lane = Lanes<float>;
    constexpr int kVectors = 4, kBlock = kVectors * Lane::kCount;
    const auto one = [&](int place) {
        if (std::abs(costs[place]) + prices[place] < limit())
            visit(place);
    };
    int i = 0;
    for (; i + kBlock <= count; i += kBlock) {
        const Lane::Values most = Lane::Values{} + limit();
        Lane::Places below = {};
        for (int v = i; v < i + kBlock; v += Lane::kCount)
            below |= magnitudes(costs + v) + load<Lane::Values>(prices + v) < most;
        std::int64_t halves[2];
        __builtin_memcpy(halves, &below, sizeof halves);
        if ((halves[0] | halves[1]) != 0)
            for (int place = i; place < i + kBlock; ++place)
                one(place);
    }
    for (; i < count; ++i)
        one(i);
}

/// The places of the two lowest sums of costs, or bounds of them, and prices; −1 for none.
inline std::pair<int, int> lowestTwo(const float* costs, const float* prices, int count) {
    float best = std::numeric_limits<float>::infinity(), second = best;
    int bestPlace = -1, secondPlace = -1;
    visitBelow(
        costs, prices, count, [&] { return second; },
        [&](int place) {
            const float value = std::abs(costs[place]) + prices[place];
            if (value < best) {
                second = std::exchange(best, value);
                secondPlace = std::exchange(bestPlace, place);
            } else {
                second = value;
                secondPlace = place;
            }
        });
    return {bestPlace, secondPlace};
}

/// An object whose cost and price sum to at most `slack` more than the best of one person's, with that sum,
/// and what no other sum is less than. Bounds that may hide better ones give way to costs.
inline BestTwo<float> bestTwo(AssignmentCosts& costs, int person, const float* prices, float slack) {
    const float* row = costs.row(person);
    if (!costs.bounded())
        return bestTwo(row, prices, costs.perRow);
    const auto value = [&](int place) {
        return place < 0 ? std::numeric_limits<float>::infinity() : std::abs(row[place]) + prices[place];
    };
    const auto [first, next] = lowestTwo(row, prices, costs.perRow);
    BestTwo<float> two;
    const auto add = [&](int place) { // of equal ones the first is the best, in whatever order they come
        two.add(place, costs.known(person, place) + prices[place], std::numeric_limits<float>::infinity());
    };
    if (first >= 0)
        add(first);
    if (two.best > value(next) + slack) {
        visitBelow(
            row, prices, costs.perRow, [&] { return two.best - slack; }, add);
        const auto [lowest, second] = lowestTwo(row, prices, costs.perRow);
        two.second = value(lowest == two.place ? second : lowest);
    } else {
        two.second = value(next);
    }
    return two;
}

/// Whether any of one person's costs and its price sum to less than `limit`.
inline bool anyBelow(AssignmentCosts& costs, int person, const float* prices, float limit) {
    bool found = false;
    visitBelow(
        costs.row(person), prices, costs.perRow,
        [&] { return found ? -std::numeric_limits<float>::infinity() : limit; },
        [&](int place) { found = costs.known(person, place) + prices[place] < limit; });
    return found;
}

} // namespace texloom

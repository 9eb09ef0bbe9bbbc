#include "core/math/cost_rows.h"

#include <array>

namespace texloom {

namespace {

constexpr float kNoCost = std::numeric_limits<float>::infinity();
/// The maximum number of costs requested at a time.
constexpr int kMost = 16;

using Lane = Lanes<float>;
/// Places of a row, kApart from each other, of which the lowest sum is kept.
struct Cell {
    static constexpr int kPlaces = 16, kApart = Lane::kCount, kSpan = kPlaces * kApart;
    int first;

    explicit Cell(int index) : first(index / kApart * kSpan + index % kApart) {}
    static int of(int place) { return place / kSpan * kApart + place % kApart; }
    static int countFor(int places) { return (places + kSpan - 1) / kSpan * kApart; }
};

/// Costs, or bounds of them.
Lane::Pack magnitudes(const float* costs) {
    Lane::Places bits;
    __builtin_memcpy(&bits, costs, sizeof bits);
    bits &= Lane::Places{} + std::numeric_limits<std::int32_t>::max();
    Lane::Pack values;
    __builtin_memcpy(&values, &bits, sizeof values);
    return values;
}

/// The lowest sums of costs, or bounds of them, and prices in each of the cells of `count` places, a multiple
/// of a span.
void lowestOfCells(const float* costs, const float* prices, int count, float* to) {
    for (int begin = 0; begin < count; begin += Cell::kSpan, to += Cell::kApart) {
        Lane::Pack lowest = Lane::Pack{} + kNoCost;
        for (int i = begin; i < begin + Cell::kSpan; i += Cell::kApart) {
            const Lane::Pack here = magnitudes(costs + i) + load<Lane::Pack>(prices + i);
            lowest = here < lowest ? here : lowest;
        }
        __builtin_memcpy(to, &lowest, sizeof lowest);
    }
}

/// The sums of one row's costs and the prices, where bounds are replaced by costs, several at a time.
class Row {
public:
    Row(AssignmentCosts& costs, int row, const float* prices)
        : m_costs(costs), m_values(costs.valuesOf(row)), m_row(row), m_prices(prices),
          m_lowest(static_cast<std::size_t>(Cell::countFor(costs.perRow))) {
        const int whole = costs.perRow / Cell::kSpan * Cell::kSpan;
        lowestOfCells(m_values, m_prices, whole, m_lowest.data());
        for (int cell = Cell::countFor(whole); cell < cells(); ++cell)
            refresh(cell);
    }

    /// The places of the two lowest sums; −1 for none.
    std::pair<int, int> lowestTwo() const {
        std::pair<int, int> two{-1, -1};
        float best = kNoCost, second = kNoCost;
        for (int cell = 0; cell < cells(); ++cell)
            if (lowest(cell) < second)
                forEach(cell, [&](int place) {
                    if (const float here = value(place); here < best) {
                        second = std::exchange(best, here);
                        two = {place, two.first};
                    } else if (here < second) {
                        second = here;
                        two.second = place;
                    }
                });
        return two;
    }
    float value(int place) const { return place < 0 ? kNoCost : std::abs(m_values[place]) + m_prices[place]; }
    /// Requests the lowest cost of each of several parts of the row, if its sum is below `limit`: this soon
    /// finds the best.
    void askHere(float limit) {
        constexpr int kParts = 16;
        for (int part = 0; part < kParts; ++part) {
            float best = limit;
            int where = -1;
            for (int cell = cells() * part / kParts; cell < cells() * (part + 1) / kParts; ++cell)
                if (lowest(cell) < best) {
                    best = lowest(cell);
                    where = cell;
                }
            bool asked = where < 0;
            if (!asked)
                forEach(where, [&](int place) {
                    if (!asked && value(place) <= best) {
                        asked = true;
                        ask(place);
                    }
                });
        }
        answer();
    }
    /// Requests every place whose sum is below limit() at that moment.
    template <class Limit> void askBelow(const Limit& limit) {
        for (int cell = 0; cell < cells(); ++cell)
            if (lowest(cell) < limit())
                forEach(cell, [&](int place) {
                    if (value(place) < limit())
                        ask(place);
                });
        answer();
    }
    void ask(int place) {
        if (!std::signbit(m_values[place]))
            return add(place);
        m_asked[static_cast<std::size_t>(m_count++)] = place;
        if (m_count == kMost)
            answer();
    }
    void answer() {
        std::array<float, kMost> values;
        if (m_count > 0)
            m_costs.cost(m_row, {m_asked.data(), static_cast<std::size_t>(m_count)}, values.data());
        for (int i = 0; i < m_count; ++i) {
            const int place = m_asked[static_cast<std::size_t>(i)];
            m_values[place] = values[static_cast<std::size_t>(i)];
            refresh(Cell::of(place));
            add(place);
        }
        m_count = 0;
    }
    /// The best of those requested.
    const BestTwo<float>& best() const { return m_best; }

private:
    int cells() const { return static_cast<int>(m_lowest.size()); }
    float lowest(int cell) const { return m_lowest[static_cast<std::size_t>(cell)]; }
    template <class Visit> void forEach(int cell, const Visit& visit) const {
        const int first = Cell(cell).first, end = std::min(m_costs.perRow, first + Cell::kSpan);
        for (int place = first; place < end; place += Cell::kApart)
            visit(place);
    }
    void refresh(int cell) {
        float lowest = kNoCost;
        forEach(cell, [&](int place) { lowest = std::min(lowest, value(place)); });
        m_lowest[static_cast<std::size_t>(cell)] = lowest;
    }
    void add(int place) { // of equal ones the first is the best, whatever their order
        m_best.add(place, value(place), kNoCost);
    }

    AssignmentCosts& m_costs;
    float* m_values;
    int m_row;
    const float* m_prices;
    std::vector<float> m_lowest; ///< of each cell
    std::array<int, kMost> m_asked{};
    int m_count = 0;
    BestTwo<float> m_best;
};

} // namespace

BestTwo<float> bestTwo(AssignmentCosts& costs, int row, const float* prices, float slack) {
    if (!costs.bounded())
        return bestTwo(costs.valuesOf(row), prices, costs.perRow);
    Row sums(costs, row, prices);
    const auto [first, next] = sums.lowestTwo();
    if (first >= 0)
        sums.ask(first);
    sums.answer();
    BestTwo<float> two = sums.best();
    two.second = sums.value(next);
    if (two.best > two.second + slack) {
        sums.askHere(two.best - slack);
        sums.askBelow([&] { return sums.best().best - slack; });
        two = sums.best();
        const auto [lowest, second] = sums.lowestTwo();
        two.second = sums.value(lowest == two.place ? second : lowest);
    }
    return two;
}

bool anyBelow(AssignmentCosts& costs, int row, const float* prices, float limit) {
    Row sums(costs, row, prices);
    const auto found = [&] { return sums.best().best < limit; };
    sums.askBelow([&] { return found() ? -kNoCost : limit; });
    return found();
}

} // namespace texloom

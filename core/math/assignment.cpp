#include "core/math/assignment.h"

#include "core/base/at.h"
#include "core/math/cost_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace texloom {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// ε falls by this factor from one auction to the next.
constexpr double kScaling = 6;
/// The first ε, the one that yields the first prices for the exact solution, and the one of a relaxed
/// assignment for which none is given, as shares of the mean cost.
constexpr double kFirst = 0.1, kRough = 5e-3, kLast = 2e-4;
/// Share of ε by which a column may be worse than one whose cost is not known yet.
constexpr double kUnseen = 0.2;
/// Rounds in which each row without a column may displace another.
constexpr int kPushes = 12;
/// Bids made at a time, before prices rise: more would outbid one another.
constexpr int kBids = 256;
/// Fewer bids than this are not worth waking threads.
constexpr int kWorthwhile = 48;
constexpr int kChunk = 8;

/// Shortest paths of changes from one row to all columns: Dijkstra's algorithm on the full graph.
class Paths {
public:
    explicit Paths(const std::vector<double>& prices)
        : m_prices(prices), m_open(prices.size(), kInfinite), m_from(prices.size(), -1),
          m_closed(prices.size(), 0) {}

    /// Tries the paths through `row` to all columns not closed yet: `base` plus cost and price.
    /// @return the column that is nearest then.
    int relax(const float* costs, int row, double base) {
        const auto taker = static_cast<double>(row);
        return relaxed([&](int column) { return Lane::costs(costs + column); },
                       [&](int column) { return static_cast<double>(costs[column]); },
                       [&](int) { return Pack{} + taker; }, [&](int) { return taker; }, base);
    }
    /// The same through the best row of a crowd for each column.
    int relax(const Crowd& crowd, double base) {
        const double *costs = crowd.changes(), *rows = crowd.rows();
        return relaxed([&](int column) { return load<Pack>(costs + column); },
                       [&](int column) { return costs[column]; },
                       [&](int column) { return load<Pack>(rows + column); },
                       [&](int column) { return rows[column]; }, base);
    }
    /// Closes a column: no shorter path to it will be found.
    double close(int column) {
        m_closed[at(column)] = m_open[at(column)];
        m_open[at(column)] = kInfinite;
        m_prices[at(column)] = kInfinite;
        return m_closed[at(column)];
    }
    double length(int column) const { return m_closed[at(column)]; }
    int from(int column) const { return static_cast<int>(m_from[at(column)]); }

private:
    using Lane = Lanes<double>;
    using Pack = typename Lane::Pack;

    /// @param packed, taking costs and rows of as many columns as a vector holds. @param cost, row of one.
    template <class Packed, class Cost, class Taking, class Row>
    int relaxed(const Packed& packed, const Cost& cost, const Taking& taking, const Row& row, double base) {
        const int count = static_cast<int>(m_prices.size());
        Pack best = Pack{} + kInfinite;
        Lane::Places where = Lane::Places{} - 1, now = Lane::kFirst;
        int column = 0;
        for (; column + Lane::kCount <= count; column += Lane::kCount, now += Lane::kCount) {
            Pack open = load<Pack>(m_open.data() + column);
            Pack from = load<Pack>(m_from.data() + column);
            const Pack through = packed(column) + load<Pack>(m_prices.data() + column) + base;
            const Lane::Places better = through < open;
            open = better ? through : open;
            from = better ? taking(column) : from;
            __builtin_memcpy(m_open.data() + column, &open, sizeof open);
            __builtin_memcpy(m_from.data() + column, &from, sizeof from);
            const Lane::Places nearer = open < best;
            best = nearer ? open : best;
            where = nearer ? now : where;
        }
        BestTwo<double> nearest;
        for (int lane = 0; lane < Lane::kCount; ++lane)
            nearest.add(static_cast<int>(where[lane]), best[lane], best[lane]);
        for (; column < count; ++column) {
            const double through = cost(column) + m_prices[at(column)] + base;
            if (through < m_open[at(column)]) {
                m_open[at(column)] = through;
                m_from[at(column)] = row(column);
            }
            nearest.add(column, m_open[at(column)]);
        }
        return nearest.place;
    }

    std::vector<double> m_prices; ///< infinite for what is closed
    std::vector<double> m_open;   ///< lengths; infinite for what is closed
    std::vector<double> m_from;   ///< the row that would take it; of the same type as the rest, for SIMD
    std::vector<double> m_closed; ///< lengths
};

double meanCost(const AssignmentCosts& costs) {
    double sum = 0;
    std::int64_t count = 0;
    const int step = 1 + costs.rows / 512;
    for (int row = 0; row < costs.rows; row += step)
        for (int place = 0; place < costs.perRow; place += 7, ++count)
            sum += static_cast<double>(std::abs(costs.valuesOf(row)[place]));
    return sum / static_cast<double>(std::max<std::int64_t>(1, count));
}

} // namespace

struct Assigner::Offers : BestTwo<float> {};

Assigner::Assigner(std::vector<int> places) : m_places(std::move(places)) {
    m_begin.push_back(0);
    for (const int count : m_places)
        m_begin.push_back(m_begin.back() + count);
    m_placePrice.assign(at(m_begin.back()), 0);
    m_assigned.assign(at(m_begin.back()), -1);
    m_price.resize(m_places.size());
    m_scanned.resize(m_places.size());
    reset(0);
}

void Assigner::reset(double price) {
    std::fill(m_placePrice.begin(), m_placePrice.end(), price);
    for (std::size_t column = 0; column < m_places.size(); ++column)
        refreshPrice(static_cast<int>(column));
}

/// Gives free places the lowest price, and keeps the prices of the others within bounds.
void Assigner::lowerFree(double lowest, double highest) {
    std::vector<std::pair<double, int>> places;
    for (std::size_t column = 0; column < m_places.size(); ++column) {
        places.clear();
        for (int place = m_begin[column]; place < m_begin[column + 1]; ++place) {
            const int assigned = m_assigned[at(place)];
            places.emplace_back(assigned < 0 ? lowest : std::clamp(m_placePrice[at(place)], lowest, highest),
                                assigned);
        }
        std::sort(places.begin(), places.end());
        for (std::size_t i = 0; i < places.size(); ++i)
            std::tie(m_placePrice[at(m_begin[column]) + i], m_assigned[at(m_begin[column]) + i]) = places[i];
        refreshPrice(static_cast<int>(column));
    }
}

/// The places of a column are a heap by price: the lowest first.
void Assigner::refreshPrice(int column) {
    m_price[at(column)] = m_places[at(column)] > 0 ? m_placePrice[at(m_begin[at(column)])] : kInfinite;
    m_scanned[at(column)] = static_cast<float>(m_price[at(column)]);
}

/// Moves the first place down the heap after its price rose.
void Assigner::sink(int column) {
    const int begin = m_begin[at(column)], count = m_places[at(column)];
    for (int parent = 0, child = 1; child < count; parent = child, child = 2 * parent + 1) {
        if (child + 1 < count && m_placePrice[at(begin + child + 1)] < m_placePrice[at(begin + child)])
            ++child;
        if (m_placePrice[at(begin + parent)] <= m_placePrice[at(begin + child)])
            break;
        std::swap(m_placePrice[at(begin + parent)], m_placePrice[at(begin + child)]);
        std::swap(m_assigned[at(begin + parent)], m_assigned[at(begin + child)]);
    }
    refreshPrice(column);
}

std::vector<int> Assigner::assign(AssignmentCosts& costs, const AssignmentOptions& options,
                                  JobContext& context) {
    const double mean = std::max(meanCost(costs), 1e-30);
    const bool relaxed = std::isfinite(options.relaxation);
    const bool exact = options.epsilon <= 0 && !relaxed;
    const double last = options.epsilon > 0 ? options.epsilon : (exact ? kRough : kLast) * mean;
    const bool stay = m_warm && (!relaxed || options.carryOn) && at(costs.rows) == m_column.size();
    if (relaxed && stay)
        lowerFree(-options.relaxation, options.relaxation);
    else if (relaxed)
        reset(-options.relaxation); // a column that no row wants must stay at the lowest price
    if (!m_warm && !relaxed)
        for (double epsilon = kFirst * mean; epsilon > 2 * last; epsilon /= kScaling)
            auction(costs, epsilon, kInfinite, false, context);
    if (!exact || !m_warm)
        auction(costs, last, relaxed ? options.relaxation : kInfinite, stay, context);
    m_warm = true;
    if (exact) {
        if (costs.bounded())
            context.parallel(0, costs.rows, [&](int row) {
                for (int place = 0; place < costs.perRow; ++place)
                    costs.known(row, place);
            });
        solveExactly(costs, context);
    }
    return m_column;
}

/// Releases all columns. @return every row.
std::vector<int> Assigner::releaseAll(int rows) {
    std::fill(m_assigned.begin(), m_assigned.end(), -1);
    m_column.assign(at(rows), -1);
    std::vector<int> all(at(rows));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// Releases the columns of rows for which, at these prices, another would be better by more than ε.
/// @return the rows without a column.
std::vector<int> Assigner::releaseWorse(AssignmentCosts& costs, double epsilon, JobContext& context) {
    std::vector<std::uint8_t> leaves(at(costs.rows), 0), placed(at(costs.rows), 0);
    for (const int row : m_assigned)
        if (row >= 0)
            placed[at(row)] = 1;
    context.parallel(0, (costs.rows + kChunk - 1) / kChunk, [&](int chunk) {
        for (int row = chunk * kChunk; row < std::min(costs.rows, (chunk + 1) * kChunk); ++row) {
            const int place = costs.place(row, m_column[at(row)]);
            const double has =
                place < 0 || placed[at(row)] == 0
                    ? kInfinite
                    : static_cast<double>(costs.known(row, place)) + m_price[at(m_column[at(row)])];
            leaves[at(row)] = offers(costs, row, has - epsilon) ? 1 : 0;
        }
    });
    for (int& assigned : m_assigned)
        if (assigned >= 0 && leaves[at(assigned)] != 0)
            assigned = -1;
    std::vector<int> left;
    for (int row = 0; row < costs.rows; ++row)
        if (leaves[at(row)] != 0) {
            m_column[at(row)] = -1;
            left.push_back(row);
        }
    return left;
}

/// Lets rows bid until every row has a column: at first all rows, or with `stay` those whose column is no
/// longer good enough. Starts from the present prices.
void Assigner::auction(AssignmentCosts& costs, double epsilon, double ceiling, bool stay,
                       JobContext& context) {
    if (std::isfinite(ceiling))
        for (std::size_t column = 0; column < m_places.size(); ++column)
            if (m_places[column] == 0) {
                m_price[column] = ceiling;
                m_scanned[column] = static_cast<float>(ceiling);
            }
    std::vector<int> bidders = stay ? releaseWorse(costs, epsilon, context) : releaseAll(costs.rows), waiting;
    while (!bidders.empty()) {
        waiting.clear();
        for (std::size_t first = 0; first < bidders.size(); first += kBids)
            bid(costs,
                std::span(bidders).subspan(first, std::min<std::size_t>(kBids, bidders.size() - first)),
                epsilon, ceiling, waiting, context);
        bidders.swap(waiting);
    }
}

/// Bids for some rows at the same prices, then assigns. @param waiting gets the rows left without a column.
void Assigner::bid(AssignmentCosts& costs, std::span<const int> bidders, double epsilon, double ceiling,
                   std::vector<int>& waiting, JobContext& context) {
    context.check();
    const int count = static_cast<int>(bidders.size()), chunks = (count + kChunk - 1) / kChunk;
    std::vector<Bid> bids(bidders.size());
    const auto make = [&](int chunk) {
        for (int i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i)
            bids[at(i)] = bidOf(costs, bidders[at(i)], epsilon, ceiling);
    };
    if (count >= kWorthwhile)
        context.parallel(0, chunks, make);
    else
        for (int chunk = 0; chunk < chunks; ++chunk)
            make(chunk);
    for (int i = 0; i < count; ++i)
        take(bidders[at(i)], bids[at(i)], ceiling, waiting);
}

Assigner::Offers Assigner::offersTo(AssignmentCosts& costs, int row, double slack) const {
    if (costs.choices.empty())
        return {bestTwo(costs, row, m_scanned.data(), static_cast<float>(slack))};
    Offers two;
    for (int place = 0; place < costs.perRow; ++place)
        two.add(place, costs.valuesOf(row)[place] + m_scanned[at(costs.column(row, place))]);
    return two;
}

/// Whether any column costs a row less than `limit`, its price included.
bool Assigner::offers(AssignmentCosts& costs, int row, double limit) const {
    if (costs.choices.empty())
        return anyBelow(costs, row, m_scanned.data(), static_cast<float>(limit));
    return static_cast<double>(offersTo(costs, row, 0).best) < limit;
}

/// The best column for a row, and the price at which the second best would be as good, plus ε.
Assigner::Bid Assigner::bidOf(AssignmentCosts& costs, int row, double epsilon, double ceiling) const {
    const float* values = costs.valuesOf(row);
    // Part of ε is allowed for columns that are only possibly better, so that fewer need be examined.
    const double slack = costs.bounded() ? kUnseen * epsilon : 0;
    const Offers two = offersTo(costs, row, slack);
    const int column = costs.column(row, two.place);
    const auto cost = static_cast<double>(values[two.place]);
    // The column's other places are as good: whoever wants them bids against other columns alone (the auction
    // for similar objects, Bertsekas & Castanon 1989), or rows would outbid each other by ε and ε.
    const auto another = static_cast<double>(two.second);
    // Without a second, any price will do.
    const double limit = std::isfinite(another) ? another - cost : m_price[at(column)];
    return {column, std::min(ceiling, std::max(limit, m_price[at(column)]) + epsilon - slack)};
}

void Assigner::take(int row, const Bid& bid, double ceiling, std::vector<int>& waiting) {
    // At this price any number of rows may have it, of those that would pay as much.
    if (m_price[at(bid.column)] >= ceiling && bid.price >= ceiling) {
        m_column[at(row)] = bid.column;
        return;
    }
    const int lowest = m_begin[at(bid.column)];
    if (bid.price <= m_placePrice[at(lowest)]) {
        waiting.push_back(row);
        return;
    }
    if (m_assigned[at(lowest)] >= 0) {
        m_column[at(m_assigned[at(lowest)])] = -1;
        waiting.push_back(m_assigned[at(lowest)]);
    }
    m_assigned[at(lowest)] = row;
    m_placePrice[at(lowest)] = bid.price;
    m_column[at(row)] = bid.column;
    sink(bid.column);
}

void Assigner::release(int row) {
    const int column = m_column[at(row)];
    for (int place = m_begin[at(column)]; place < m_begin[at(column) + 1]; ++place)
        if (m_assigned[at(place)] == row)
            m_assigned[at(place)] = -1;
    m_column[at(row)] = -1;
}

/// Finds prices as far as bids without ε lead (augmenting row reduction of Jonker & Volgenant), then shortest
/// augmenting paths for the rest. Throughout, every row with a column has its best one.
void Assigner::solveExactly(const AssignmentCosts& costs, JobContext& context) {
    std::fill(m_assigned.begin(), m_assigned.end(), -1);
    m_column.assign(at(costs.rows), -1);
    std::vector<int> waiting;
    for (int row = costs.rows - 1; row >= 0; --row)
        waiting.push_back(row);
    for (int round = 0; round < kPushes && !waiting.empty(); ++round)
        waiting = push(costs, std::move(waiting), context);
    std::sort(waiting.begin(), waiting.end());
    for (const int row : waiting)
        augment(costs, row, context);
    m_crowds.clear();
    for (std::size_t column = 0; column < m_places.size(); ++column) {
        std::fill(m_placePrice.begin() + m_begin[column], m_placePrice.begin() + m_begin[column + 1],
                  m_price[column]);
        refreshPrice(static_cast<int>(column));
    }
}

/// Each row takes the column that is best for it, at the price at which the second best would be as good.
/// @param waiting taken from the end. @return the rows left without.
std::vector<int> Assigner::push(const AssignmentCosts& costs, std::vector<int> waiting, JobContext& context) {
    std::vector<int> left;
    std::size_t steps = 4 * waiting.size();
    while (!waiting.empty()) {
        context.check();
        const int row = waiting.back();
        waiting.pop_back();
        const BestTwo<double> two = bestTwo(costs.valuesOf(row), m_price.data(), costs.columns);
        const int column = two.place;
        const int free = freePlace(column);
        const int place = free >= 0 ? free : m_begin[at(column)];
        if (free < 0 && (m_places[at(column)] > 1 || !(two.second > two.best) || steps == 0)) {
            left.push_back(row);
            continue;
        }
        if (free < 0) {
            const int before = m_assigned[at(place)];
            m_column[at(before)] = -1;
            waiting.push_back(before);
            --steps;
        }
        // The price of a column with one place may rise without a loss: only its own row pays it.
        if (m_places[at(column)] == 1 && std::isfinite(two.second))
            m_price[at(column)] += two.second - two.best;
        m_assigned[at(place)] = row;
        m_column[at(row)] = column;
    }
    std::reverse(left.begin(), left.end());
    return left;
}

int Assigner::freePlace(int column) const {
    for (int place = m_begin[at(column)]; place < m_begin[at(column) + 1]; ++place)
        if (m_assigned[at(place)] < 0)
            return place;
    return -1;
}

/// The rows of a column with many places, all of them taken.
const Crowd& Assigner::crowdOf(int column, const AssignmentCosts& costs) {
    const auto found =
        m_crowds.try_emplace(column, column, m_begin[at(column)], m_places[at(column)], costs.columns).first;
    found->second.refresh(costs, m_assigned);
    return found->second;
}

/// Finds a place for one row along the shortest path of changes, and moves the prices so that every row still
/// has its best column.
void Assigner::augment(const AssignmentCosts& costs, int row, JobContext& context) {
    Paths paths(m_price);
    std::vector<int> scanned;
    int nearest = paths.relax(costs.valuesOf(row), row, 0);
    int end = -1;
    while (end < 0) {
        context.check();
        const int column = nearest;
        const double length = paths.close(column);
        scanned.push_back(column);
        if (freePlace(column) >= 0)
            end = column;
        if (end < 0 && m_places[at(column)] >= Crowd::kLeast) {
            nearest = paths.relax(crowdOf(column, costs), length - m_price[at(column)]);
            continue;
        }
        for (int place = m_begin[at(column)]; place < m_begin[at(column) + 1] && end < 0; ++place) {
            const int assigned = m_assigned[at(place)];
            const double paid = static_cast<double>(costs.valuesOf(assigned)[column]) + m_price[at(column)];
            nearest = paths.relax(costs.valuesOf(assigned), assigned, length - paid);
        }
    }
    for (const int column : scanned)
        m_price[at(column)] += paths.length(end) - paths.length(column);
    for (int column = end, moved = -1; moved != row;) {
        moved = paths.from(column);
        const int before = m_column[at(moved)];
        if (before >= 0)
            release(moved);
        const int place = freePlace(column);
        m_assigned[at(place)] = moved;
        m_column[at(moved)] = column;
        if (const auto crowd = m_crowds.find(column); crowd != m_crowds.end())
            crowd->second.changed(place);
        column = before;
    }
}

} // namespace texloom

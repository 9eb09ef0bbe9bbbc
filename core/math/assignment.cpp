#include "core/math/assignment.h"

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
/// The first ε, the one that gives the exact solution its first prices, and the one of a relaxed assignment
/// without, as shares of the mean cost.
constexpr double kFirst = 0.1, kRough = 5e-3, kLast = 2e-4;
/// Share of ε by which an object may be worse than one whose cost is not known yet.
constexpr double kUnseen = 0.2;
/// Rounds in which everybody without an object may push out another.
constexpr int kPushes = 12;
/// Bids made at a time, before prices rise: more would outbid one another.
constexpr int kBids = 256;
/// Fewer bids than this are not worth waking threads.
constexpr int kWorthwhile = 48;
constexpr int kChunk = 8;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Shortest paths of changes from one person to all objects: Dijkstra's algorithm on the full graph.
class Paths {
public:
    explicit Paths(const std::vector<double>& prices)
        : m_prices(prices), m_open(prices.size(), kInfinite), m_from(prices.size(), -1),
          m_closed(prices.size(), 0) {}

    /// Tries the ways over `person` to everything not closed yet: `base` and the cost with the price.
    /// @return the object that is nearest then.
    int relax(const float* costs, int person, double base) {
        using Lane = Lanes<double>;
        using Values = Lane::Values;
        const auto who = static_cast<double>(person);
        const int count = static_cast<int>(m_prices.size());
        Values best = Values{} + kInfinite;
        Lane::Places where = Lane::Places{} - 1, now = Lane::kFirst;
        int object = 0;
        for (; object + Lane::kCount <= count; object += Lane::kCount, now += Lane::kCount) {
            Values open = load<Values>(m_open.data() + object);
            Values from = load<Values>(m_from.data() + object);
            const Values through =
                Lane::costs(costs + object) + load<Values>(m_prices.data() + object) + base;
            const Lane::Places better = through < open;
            open = better ? through : open;
            from = better ? Values{} + who : from;
            __builtin_memcpy(m_open.data() + object, &open, sizeof open);
            __builtin_memcpy(m_from.data() + object, &from, sizeof from);
            const Lane::Places nearer = open < best;
            best = nearer ? open : best;
            where = nearer ? now : where;
        }
        BestTwo<double> nearest;
        for (int lane = 0; lane < Lane::kCount; ++lane)
            nearest.add(static_cast<int>(where[lane]), best[lane], best[lane]);
        for (; object < count; ++object) {
            const double through = static_cast<double>(costs[object]) + m_prices[at(object)] + base;
            if (through < m_open[at(object)]) {
                m_open[at(object)] = through;
                m_from[at(object)] = who;
            }
            nearest.add(object, m_open[at(object)]);
        }
        return nearest.place;
    }
    /// No shorter way to this object will be found.
    double close(int object) {
        m_closed[at(object)] = m_open[at(object)];
        m_open[at(object)] = kInfinite;
        m_prices[at(object)] = kInfinite;
        return m_closed[at(object)];
    }
    double length(int object) const { return m_closed[at(object)]; }
    int from(int object) const { return static_cast<int>(m_from[at(object)]); }

private:
    std::vector<double> m_prices; ///< infinite for what is closed
    std::vector<double> m_open;   ///< lengths; infinite for what is closed
    std::vector<double> m_from;   ///< the person who would come; of one type with the rest, for vectors
    std::vector<double> m_closed; ///< lengths
};

double meanCost(const AssignmentCosts& costs) {
    double sum = 0;
    std::int64_t count = 0;
    const int step = 1 + costs.persons / 512;
    for (int person = 0; person < costs.persons; person += step)
        for (int place = 0; place < costs.perRow; place += 7, ++count)
            sum += static_cast<double>(std::abs(costs.row(person)[place]));
    return sum / static_cast<double>(std::max<std::int64_t>(1, count));
}

} // namespace

struct Assigner::Offers : BestTwo<float> {};

Assigner::Assigner(std::vector<int> places) : m_places(std::move(places)) {
    m_begin.push_back(0);
    for (const int count : m_places)
        m_begin.push_back(m_begin.back() + count);
    m_placePrice.assign(at(m_begin.back()), 0);
    m_holder.assign(at(m_begin.back()), -1);
    m_price.resize(m_places.size());
    m_second.resize(m_places.size());
    m_scanned.resize(m_places.size());
    reset(0);
}

void Assigner::reset(double price) {
    std::fill(m_placePrice.begin(), m_placePrice.end(), price);
    for (std::size_t object = 0; object < m_places.size(); ++object)
        refreshPrice(static_cast<int>(object));
}

/// Gives places that nobody has the lowest price, and keeps the others' within bounds.
void Assigner::lowerFree(double lowest, double highest) {
    std::vector<std::pair<double, int>> places;
    for (std::size_t object = 0; object < m_places.size(); ++object) {
        places.clear();
        for (int place = m_begin[object]; place < m_begin[object + 1]; ++place) {
            const int holder = m_holder[at(place)];
            places.emplace_back(holder < 0 ? lowest : std::clamp(m_placePrice[at(place)], lowest, highest),
                                holder);
        }
        std::sort(places.begin(), places.end());
        for (std::size_t i = 0; i < places.size(); ++i)
            std::tie(m_placePrice[at(m_begin[object]) + i], m_holder[at(m_begin[object]) + i]) = places[i];
        refreshPrice(static_cast<int>(object));
    }
}

/// The places of an object are a heap by price: the lowest first, and the second lowest right below it.
void Assigner::refreshPrice(int object) {
    const int begin = m_begin[at(object)], count = m_places[at(object)];
    m_price[at(object)] = count > 0 ? m_placePrice[at(begin)] : kInfinite;
    m_second[at(object)] = kInfinite;
    for (int child = 1; child < std::min(count, 3); ++child)
        m_second[at(object)] = std::min(m_second[at(object)], m_placePrice[at(begin + child)]);
    m_scanned[at(object)] = static_cast<float>(m_price[at(object)]);
}

/// Moves the first place down the heap after its price rose.
void Assigner::sink(int object) {
    const int begin = m_begin[at(object)], count = m_places[at(object)];
    for (int parent = 0, child = 1; child < count; parent = child, child = 2 * parent + 1) {
        if (child + 1 < count && m_placePrice[at(begin + child + 1)] < m_placePrice[at(begin + child)])
            ++child;
        if (m_placePrice[at(begin + parent)] <= m_placePrice[at(begin + child)])
            break;
        std::swap(m_placePrice[at(begin + parent)], m_placePrice[at(begin + child)]);
        std::swap(m_holder[at(begin + parent)], m_holder[at(begin + child)]);
    }
    refreshPrice(object);
}

std::vector<int> Assigner::assign(AssignmentCosts& costs, const AssignmentOptions& options,
                                  JobContext& context) {
    const double mean = std::max(meanCost(costs), 1e-30);
    const bool relaxed = std::isfinite(options.relaxation);
    const bool exact = options.epsilon <= 0 && !relaxed;
    const double last = options.epsilon > 0 ? options.epsilon : (exact ? kRough : kLast) * mean;
    const bool stay = m_warm && (!relaxed || options.carryOn) && at(costs.persons) == m_object.size();
    if (relaxed && stay)
        lowerFree(-options.relaxation, options.relaxation);
    else if (relaxed)
        reset(-options.relaxation); // an object that nobody wants must stay at the lowest price
    if (!m_warm && !relaxed)
        for (double epsilon = kFirst * mean; epsilon > 2 * last; epsilon /= kScaling)
            auction(costs, epsilon, kInfinite, false, context);
    if (!exact || !m_warm)
        auction(costs, last, relaxed ? options.relaxation : kInfinite, stay, context);
    m_warm = true;
    if (exact) {
        if (costs.bounded())
            context.parallel(0, costs.persons, [&](int person) {
                for (int place = 0; place < costs.perRow; ++place)
                    costs.known(person, place);
            });
        solveExactly(costs, context);
    }
    return m_object;
}

/// Takes their objects from all.
std::vector<int> Assigner::everybody(int persons) {
    std::fill(m_holder.begin(), m_holder.end(), -1);
    m_object.assign(at(persons), -1);
    std::vector<int> all(at(persons));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// Takes the objects from those for whom, at these prices, another would be better by more than ε.
/// @return everybody without an object.
std::vector<int> Assigner::discontented(AssignmentCosts& costs, double epsilon, JobContext& context) {
    std::vector<double> paid(at(costs.persons), kInfinite);
    for (std::size_t object = 0; object < m_places.size(); ++object)
        for (int place = m_begin[object]; place < m_begin[object + 1]; ++place)
            if (m_holder[at(place)] >= 0)
                paid[at(m_holder[at(place)])] = m_placePrice[at(place)];
    std::vector<std::uint8_t> leaves(at(costs.persons), 0);
    context.parallel(0, (costs.persons + kChunk - 1) / kChunk, [&](int chunk) {
        for (int person = chunk * kChunk; person < std::min(costs.persons, (chunk + 1) * kChunk); ++person) {
            const int place = costs.place(person, m_object[at(person)]);
            const double has =
                place < 0 ? kInfinite : static_cast<double>(costs.known(person, place)) + paid[at(person)];
            leaves[at(person)] = offers(costs, person, has - epsilon) ? 1 : 0;
        }
    });
    for (int& holder : m_holder)
        if (holder >= 0 && leaves[at(holder)] != 0)
            holder = -1;
    std::vector<int> left;
    for (int person = 0; person < costs.persons; ++person)
        if (leaves[at(person)] != 0) {
            m_object[at(person)] = -1;
            left.push_back(person);
        }
    return left;
}

/// Bids are made until everybody has an object: at first by all, or with `stay` by those whose object no
/// longer suits them. Prices begin as they are.
void Assigner::auction(AssignmentCosts& costs, double epsilon, double ceiling, bool stay,
                       JobContext& context) {
    if (std::isfinite(ceiling))
        for (std::size_t object = 0; object < m_places.size(); ++object)
            if (m_places[object] == 0) {
                m_price[object] = ceiling;
                m_scanned[object] = static_cast<float>(ceiling);
            }
    std::vector<int> bidders = stay ? discontented(costs, epsilon, context) : everybody(costs.persons),
                     waiting;
    while (!bidders.empty()) {
        waiting.clear();
        for (std::size_t first = 0; first < bidders.size(); first += kBids)
            bid(costs,
                std::span(bidders).subspan(first, std::min<std::size_t>(kBids, bidders.size() - first)),
                epsilon, ceiling, waiting, context);
        bidders.swap(waiting);
    }
}

/// Some persons bid at the same prices, then objects are given away. @param waiting gets those left without.
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

Assigner::Offers Assigner::offersTo(AssignmentCosts& costs, int person, double slack) const {
    if (costs.choices.empty())
        return {bestTwo(costs, person, m_scanned.data(), static_cast<float>(slack))};
    Offers two;
    for (int place = 0; place < costs.perRow; ++place)
        two.add(place, costs.row(person)[place] + m_scanned[at(costs.object(person, place))]);
    return two;
}

/// Whether an object costs a person less than `limit`, its price included.
bool Assigner::offers(AssignmentCosts& costs, int person, double limit) const {
    if (costs.choices.empty())
        return anyBelow(costs, person, m_scanned.data(), static_cast<float>(limit));
    return static_cast<double>(offersTo(costs, person, 0).best) < limit;
}

/// The best object for a person, and the price at which the second best would be as good, and ε more.
Assigner::Bid Assigner::bidOf(AssignmentCosts& costs, int person, double epsilon, double ceiling) const {
    const float* row = costs.row(person);
    // Part of ε goes into objects that only may be better, so that fewer need be looked at.
    const double slack = costs.bounded() ? kUnseen * epsilon : 0;
    const Offers two = offersTo(costs, person, slack);
    const int object = costs.object(person, two.place);
    const auto cost = static_cast<double>(row[two.place]);
    const double another = std::min(static_cast<double>(two.second), cost + m_second[at(object)]);
    // With nothing else to turn to, any price will do.
    const double limit = std::isfinite(another) ? another - cost : m_price[at(object)];
    return {object, std::min(ceiling, std::max(limit, m_price[at(object)]) + epsilon - slack)};
}

void Assigner::take(int person, const Bid& bid, double ceiling, std::vector<int>& waiting) {
    if (m_price[at(bid.object)] >= ceiling) { // as many as like may have it at this price
        m_object[at(person)] = bid.object;
        return;
    }
    const int lowest = m_begin[at(bid.object)];
    if (bid.price <= m_placePrice[at(lowest)]) {
        waiting.push_back(person);
        return;
    }
    if (m_holder[at(lowest)] >= 0) {
        m_object[at(m_holder[at(lowest)])] = -1;
        waiting.push_back(m_holder[at(lowest)]);
    }
    m_holder[at(lowest)] = person;
    m_placePrice[at(lowest)] = bid.price;
    m_object[at(person)] = bid.object;
    sink(bid.object);
}

void Assigner::release(int person) {
    const int object = m_object[at(person)];
    for (int place = m_begin[at(object)]; place < m_begin[at(object) + 1]; ++place)
        if (m_holder[at(place)] == person)
            m_holder[at(place)] = -1;
    m_object[at(person)] = -1;
}

/// Prices at which nobody wants more than one object, as far as bids without ε lead (augmenting row reduction
/// of Jonker & Volgenant), then shortest augmenting paths for the rest. All the while everybody with an
/// object has the best.
void Assigner::solveExactly(const AssignmentCosts& costs, JobContext& context) {
    std::fill(m_holder.begin(), m_holder.end(), -1);
    m_object.assign(at(costs.persons), -1);
    std::vector<int> waiting;
    for (int person = costs.persons - 1; person >= 0; --person)
        waiting.push_back(person);
    for (int round = 0; round < kPushes && !waiting.empty(); ++round)
        waiting = push(costs, std::move(waiting), context);
    std::sort(waiting.begin(), waiting.end());
    for (const int person : waiting)
        augment(costs, person, context);
    for (std::size_t object = 0; object < m_places.size(); ++object) {
        std::fill(m_placePrice.begin() + m_begin[object], m_placePrice.begin() + m_begin[object + 1],
                  m_price[object]);
        refreshPrice(static_cast<int>(object));
    }
}

/// Everybody takes the object that is best for them, at the price at which the second best would be as good.
/// @param waiting taken from the end. @return those who are left without.
std::vector<int> Assigner::push(const AssignmentCosts& costs, std::vector<int> waiting, JobContext& context) {
    std::vector<int> left;
    std::size_t steps = 4 * waiting.size();
    while (!waiting.empty()) {
        context.check();
        const int person = waiting.back();
        waiting.pop_back();
        const BestTwo<double> two = bestTwo(costs.row(person), m_price.data(), costs.objects);
        const int object = two.place;
        const int free = freePlace(object);
        const int place = free >= 0 ? free : m_begin[at(object)];
        if (free < 0 && (m_places[at(object)] > 1 || !(two.second > two.best) || steps == 0)) {
            left.push_back(person);
            continue;
        }
        if (free < 0) {
            const int before = m_holder[at(place)];
            m_object[at(before)] = -1;
            waiting.push_back(before);
            --steps;
        }
        // A free object may cost more without a loss: only its holder pays.
        if (m_places[at(object)] == 1 && std::isfinite(two.second))
            m_price[at(object)] += two.second - two.best;
        m_holder[at(place)] = person;
        m_object[at(person)] = object;
    }
    std::reverse(left.begin(), left.end());
    return left;
}

int Assigner::freePlace(int object) const {
    for (int place = m_begin[at(object)]; place < m_begin[at(object) + 1]; ++place)
        if (m_holder[at(place)] < 0)
            return place;
    return -1;
}

/// Finds a place for one person along the shortest path of changes, and moves the prices so that everybody
/// still has the best.
void Assigner::augment(const AssignmentCosts& costs, int person, JobContext& context) {
    Paths paths(m_price);
    std::vector<int> scanned;
    int nearest = paths.relax(costs.row(person), person, 0);
    int end = -1;
    while (end < 0) {
        context.check();
        const int object = nearest;
        const double length = paths.close(object);
        scanned.push_back(object);
        if (freePlace(object) >= 0)
            end = object;
        for (int place = m_begin[at(object)]; place < m_begin[at(object) + 1] && end < 0; ++place) {
            const int holder = m_holder[at(place)];
            const double paid = static_cast<double>(costs.row(holder)[object]) + m_price[at(object)];
            nearest = paths.relax(costs.row(holder), holder, length - paid);
        }
    }
    for (const int object : scanned)
        m_price[at(object)] += paths.length(end) - paths.length(object);
    for (int object = end, who = -1; who != person;) {
        who = paths.from(object);
        const int before = m_object[at(who)];
        if (before >= 0)
            release(who);
        m_holder[at(freePlace(object))] = who;
        m_object[at(who)] = object;
        object = before;
    }
}

} // namespace texloom

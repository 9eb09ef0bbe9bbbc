#include "core/job/job.h"
#include "core/job/random.h"
#include "core/math/assignment.h"
#include "core/math/cost_rows.h"

#include <gtest/gtest.h>
#include <lemon/network_simplex.h>
#include <lemon/smart_graph.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <vector>

namespace texloom::test {

namespace {

/// Whole costs, so that the simplex method's are the same.
AssignmentCosts randomCosts(int rows, int columns, int largest, int number) {
    const Random random(11);
    AssignmentCosts costs{rows, columns, {}, {}, columns, {}};
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            costs.costs.push_back(static_cast<float>(
                random.below(static_cast<std::uint32_t>(largest), i, j, static_cast<std::uint32_t>(number))));
    return costs;
}

double costOf(const AssignmentCosts& costs, const std::vector<int>& columns) {
    double sum = 0;
    for (int i = 0; i < costs.rows; ++i)
        sum += static_cast<double>(costs.valuesOf(i)[columns[static_cast<std::size_t>(i)]]);
    return sum;
}

/// The smallest cost by LEMON's network simplex.
double smallestCost(const AssignmentCosts& costs, const std::vector<int>& places) {
    lemon::SmartDigraph graph;
    std::vector<lemon::SmartDigraph::Node> rows, columns;
    for (int i = 0; i < costs.rows; ++i)
        rows.push_back(graph.addNode());
    for (int j = 0; j < costs.columns; ++j)
        columns.push_back(graph.addNode());
    lemon::SmartDigraph::ArcMap<std::int64_t> cost(graph);
    lemon::SmartDigraph::NodeMap<std::int64_t> supply(graph, 0);
    for (int i = 0; i < costs.rows; ++i) {
        supply[rows[static_cast<std::size_t>(i)]] = 1;
        for (int j = 0; j < costs.columns; ++j)
            cost[graph.addArc(rows[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)])] =
                static_cast<std::int64_t>(costs.valuesOf(i)[j]);
    }
    for (int j = 0; j < costs.columns; ++j)
        supply[columns[static_cast<std::size_t>(j)]] = -places[static_cast<std::size_t>(j)];
    lemon::NetworkSimplex<lemon::SmartDigraph, std::int64_t> simplex(graph);
    simplex.costMap(cost).supplyMap(supply).run();
    return static_cast<double>(simplex.totalCost());
}

struct Solved {
    std::vector<int> first, again; ///< the second time with the prices of the first
};

Solved solved(AssignmentCosts costs, const std::vector<int>& places, const AssignmentOptions& options,
              int threads = 2) {
    Job<Solved> job({1, threads, false}, [&](JobContext& context) {
        Assigner assigner(places);
        Solved both;
        both.first = assigner.assign(costs, options, context);
        both.again = assigner.assign(costs, options, context);
        return both;
    });
    return std::get<Solved>(job.take());
}

std::vector<int> uses(const std::vector<int>& columns, int count) {
    std::vector<int> counts(static_cast<std::size_t>(count), 0);
    for (const int column : columns)
        ++counts[static_cast<std::size_t>(column)];
    return counts;
}

} // namespace

TEST(Assignment, exactCostIsThatOfTheNetworkSimplex) {
    int number = 0;
    for (const int size : {1, 2, 7, 60, 200, 500})
        for (const int largest : {5, 1000, 1000000}) {
            const AssignmentCosts costs = randomCosts(size, size, largest, number++);
            const std::vector<int> places(static_cast<std::size_t>(size), 1);
            const double smallest = smallestCost(costs, places);
            const Solved found = solved(costs, places, {});
            EXPECT_EQ(costOf(costs, found.first), smallest) << size << ", costs to " << largest;
            EXPECT_EQ(costOf(costs, found.again), smallest) << size << ", costs to " << largest;
            EXPECT_EQ(uses(found.first, size), places);
        }
}

TEST(Assignment, columnsWithSeveralPlacesAreFilledExactly) {
    const std::vector<int> places = {3, 0, 5, 1, 20, 7, 4};
    const AssignmentCosts costs = randomCosts(40, 7, 500, 77);
    const Solved found = solved(costs, places, {});
    EXPECT_EQ(uses(found.first, 7), places);
    EXPECT_EQ(costOf(costs, found.first), smallestCost(costs, places));
    EXPECT_EQ(costOf(costs, found.again), smallestCost(costs, places));
    EXPECT_EQ(uses(solved(costs, places, {10}).first, 7), places);
}

TEST(Assignment, aColumnOfHundredsOfPlacesIsFilledAsWellAsOthers) {
    std::vector<int> places(121, 5);
    places[40] = 700; // of rows that are looked at together
    places[7] = 0;
    const int rows = std::accumulate(places.begin(), places.end(), 0);
    AssignmentCosts costs = randomCosts(rows, 121, 1000, 78);
    for (int row = 0; row < rows; ++row) // most rows want it, and more than there is room for
        if (row % 6 != 0)
            costs.valuesOf(row)[40] = static_cast<float>(row % 3);
    const double smallest = smallestCost(costs, places);
    const Solved exact = solved(costs, places, {});
    EXPECT_EQ(uses(exact.first, 121), places);
    EXPECT_EQ(costOf(costs, exact.first), smallest);
    EXPECT_EQ(costOf(costs, exact.again), smallest);
    const Solved near = solved(costs, places, {0.5});
    EXPECT_EQ(uses(near.first, 121), places);
    EXPECT_LE(costOf(costs, near.first), smallest + rows * 0.5 + 0.1);
}

TEST(Assignment, auctionComesWithinEpsilonForEachRow) {
    for (const double epsilon : {0.5, 5.0, 50.0}) {
        const AssignmentCosts costs = randomCosts(150, 150, 1000, 5);
        const std::vector<int> places(150, 1);
        const double smallest = smallestCost(costs, places);
        const Solved found = solved(costs, places, {epsilon});
        EXPECT_LE(costOf(costs, found.first), smallest + 150 * epsilon + 0.01);
        EXPECT_LE(costOf(costs, found.again), smallest + 150 * epsilon + 0.01);
        EXPECT_EQ(uses(found.first, 150), places);
    }
}

/// Bounds of costs, of which a share of `nearness` are the costs themselves, and a count of those asked for.
AssignmentCosts boundsOf(const AssignmentCosts& costs, double nearness, std::atomic<int>& asked) {
    const Random random(12);
    AssignmentCosts bounds = costs;
    for (int i = 0; i < costs.rows; ++i)
        for (int j = 0; j < costs.columns; ++j)
            bounds.valuesOf(i)[j] *=
                -static_cast<float>(std::min(1.0, std::max(0.0, random.uniform(i, j, 1) + nearness)));
    bounds.cost = [&](int row, std::span<const int> columns, float* to) {
        asked += static_cast<int>(columns.size());
        for (const int column : columns)
            *to++ = costs.valuesOf(row)[column];
    };
    return bounds;
}

TEST(Assignment, theBestOfARowIsWithinTheSlackAndNoOtherBelowTheSecond) {
    const Random random(3);
    for (const int count : {1, 5, 63, 64, 65, 300, 3000}) {
        const AssignmentCosts costs = randomCosts(40, count, 1000, 5);
        std::vector<float> prices(static_cast<std::size_t>(count));
        for (int j = 0; j < count; ++j)
            prices[static_cast<std::size_t>(j)] = static_cast<float>(std::floor(600 * random.uniform(j, 0)));
        std::atomic<int> asked = 0;
        AssignmentCosts bounds = boundsOf(costs, 0, asked);
        for (int row = 0; row < 40; ++row) {
            const float slack = row % 2 == 0 ? 0.0F : 50.0F;
            const auto sum = [&](int j) {
                return costs.valuesOf(row)[j] + prices[static_cast<std::size_t>(j)];
            };
            const BestTwo<float> two = bestTwo(bounds, row, prices.data(), slack);
            EXPECT_EQ(two.best, sum(two.place));
            for (int j = 0; j < count; ++j) {
                EXPECT_LE(two.best, sum(j) + slack);
                EXPECT_TRUE(j == two.place || two.second <= sum(j));
            }
            float best = sum(0);
            for (int j = 1; j < count; ++j)
                best = std::min(best, sum(j));
            EXPECT_TRUE(anyBelow(bounds, row, prices.data(), best + 1));
            EXPECT_FALSE(anyBelow(bounds, row, prices.data(), best));
        }
    }
}

TEST(Assignment, boundsSpareMostCostsAndKeepThePromise) {
    constexpr int kCount = 300;
    const AssignmentCosts costs = randomCosts(kCount, kCount, 1000000, 7);
    std::atomic<int> asked = 0;
    AssignmentCosts bounds = boundsOf(costs, 0.4, asked);
    const std::vector<int> places(kCount, 1);
    const double smallest = smallestCost(costs, places);
    EXPECT_EQ(costOf(costs, solved(bounds, places, {}).first), smallest);
    asked = 0;
    const Solved near = solved(bounds, places, {2000});
    EXPECT_LT(asked, kCount * kCount / 3);
    EXPECT_LE(costOf(costs, near.first), smallest + kCount * 2000);
    EXPECT_LE(costOf(costs, near.again), smallest + kCount * 2000);
    EXPECT_EQ(uses(near.first, kCount), places);
    const auto total = [&](const AssignmentCosts& given) {
        const std::vector<int> columns = solved(given, places, {500, 30000}).first;
        double sum = costOf(costs, columns);
        for (const int count : uses(columns, kCount))
            sum += 30000 * std::abs(count - 1);
        return sum;
    };
    EXPECT_NEAR(total(bounds), total(costs), kCount * 500);
}

TEST(Assignment, threadsChangeNothing) {
    const AssignmentCosts costs = randomCosts(300, 300, 50, 6);
    const std::vector<int> places(300, 1);
    for (const double epsilon : {0.0, 2.0})
        EXPECT_EQ(solved(costs, places, {epsilon}, 1).again, solved(costs, places, {epsilon}, 7).again);
}

TEST(Assignment, relaxedGoesFromTheNearestToTheAssignment) {
    const AssignmentCosts costs = randomCosts(120, 120, 1000, 8);
    const std::vector<int> places(120, 1);
    double nearest = 0;
    for (int i = 0; i < 120; ++i)
        nearest += static_cast<double>(*std::min_element(costs.valuesOf(i), costs.valuesOf(i) + 120));
    const auto cost = [&](double rho) { return costOf(costs, solved(costs, places, {0.01, rho}).first); };
    EXPECT_NEAR(cost(0), nearest, 120 * 0.01);
    const Solved large = solved(costs, places, {0.01, 5000});
    EXPECT_EQ(uses(large.first, 120), places);
    EXPECT_NEAR(costOf(costs, large.first), smallestCost(costs, places), 120 * 0.01);
    EXPECT_GE(cost(100) + 1, cost(10));
    EXPECT_GT(cost(100), nearest);
}

TEST(Assignment, relaxedIsTheBestTradeOfCostsAndUses) {
    // Small enough to try everything.
    const AssignmentCosts costs = randomCosts(5, 4, 40, 9);
    const std::vector<int> places = {1, 2, 0, 2};
    for (const double rho : {0.0, 3.0, 8.0, 30.0}) {
        const auto total = [&](const std::vector<int>& columns) {
            double sum = costOf(costs, columns);
            const std::vector<int> counts = uses(columns, 4);
            for (std::size_t j = 0; j < 4; ++j)
                sum += rho * std::abs(counts[j] - places[j]);
            return sum;
        };
        double best = HUGE_VAL;
        for (int code = 0; code < 1024; ++code)
            best = std::min(best, total({code % 4, code / 4 % 4, code / 16 % 4, code / 64 % 4, code / 256}));
        EXPECT_NEAR(total(solved(costs, places, {0.001, rho}).first), best, 5 * 0.001) << "rho " << rho;
    }
}

} // namespace texloom::test

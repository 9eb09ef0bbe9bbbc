#include "core/job/random.h"
#include "core/match/seam_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace texloom::test {
namespace {

constexpr float kDelta = 0.01F;

SeamOverlap randomOverlap(int along, int across, int channels, std::uint64_t seed) {
    const Random random(seed);
    SeamOverlap overlap(along, across, channels);
    for (std::size_t i = 0; i < overlap.first.size(); ++i) {
        overlap.first[i] = static_cast<float>(random.uniform(static_cast<int>(i), 0));
        overlap.second[i] = static_cast<float>(random.uniform(static_cast<int>(i), 1));
    }
    return overlap;
}

/// The least cost of all paths there are.
double leastCost(const SeamOverlap& overlap, bool closes, int middle) {
    std::vector<int> path(static_cast<std::size_t>(overlap.along), 1);
    double least = std::numeric_limits<double>::infinity();
    const std::function<void(std::size_t)> choose = [&](std::size_t step) {
        if (step == path.size()) {
            least = std::min(least, seamCost(overlap, kDelta, closes, path));
            return;
        }
        for (int x = 1; x < overlap.across; ++x) {
            if (middle > 0 && static_cast<int>(step) == overlap.along / 2 && x != middle)
                continue;
            path[step] = x;
            choose(step + 1);
        }
    };
    choose(0);
    return least;
}

/// Equation 8 as it is written: the sum over all neighbours of which one is left of the path and one right.
double partedPairs(const SeamOverlap& overlap, bool closes, const std::vector<int>& path) {
    const auto squared = [&](const std::vector<float>& a, int y, int x, const std::vector<float>& b, int v,
                             int u) {
        double sum = 0;
        for (std::size_t c = 0; c < static_cast<std::size_t>(overlap.channels); ++c) {
            const double apart = static_cast<double>(a[overlap.at(y, x) + c] - b[overlap.at(v, u) + c]);
            sum += apart * apart;
        }
        return sum;
    };
    const auto pair = [&](int y, int x, int v, int u) {
        const bool right = x >= path[static_cast<std::size_t>(y)];
        if (right == (u >= path[static_cast<std::size_t>(v)]))
            return 0.0;
        return (squared(overlap.first, y, x, overlap.second, y, x) +
                squared(overlap.first, v, u, overlap.second, v, u)) /
               (squared(overlap.first, y, x, overlap.first, v, u) +
                squared(overlap.second, y, x, overlap.second, v, u) + static_cast<double>(kDelta));
    };
    double sum = 0;
    for (int y = 0; y < overlap.along; ++y)
        for (int x = 0; x < overlap.across; ++x) {
            if (x + 1 < overlap.across)
                sum += pair(y, x, y, x + 1);
            if (y + 1 < overlap.along || closes)
                sum += pair(y, x, (y + 1) % overlap.along, x);
        }
    return sum;
}

TEST(SeamPath, costsWhatEquation8Says) {
    for (const bool closes : {false, true}) {
        const SeamOverlap overlap = randomOverlap(7, 5, 3, 4);
        const std::vector<int> path = {1, 4, 2, 2, 3, 1, 4};
        EXPECT_NEAR(seamCost(overlap, kDelta, closes, path), partedPairs(overlap, closes, path), 1e-3);
    }
}

TEST(SeamPath, noOtherPathCostsLess) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const SeamOverlap overlap = randomOverlap(6, 4, 2, seed);
        const std::vector<int> path = seamPath(overlap, kDelta, false);
        EXPECT_NEAR(seamCost(overlap, kDelta, false, path), leastCost(overlap, false, 0), 1e-4);
        const std::vector<int> closed = seamPath(overlap, kDelta, true);
        EXPECT_NEAR(seamCost(overlap, kDelta, true, closed), leastCost(overlap, true, closed[3]), 1e-4)
            << "of those that close and go through the same pixel half-way";
    }
}

TEST(SeamPath, flatPiecesHaveAFiniteCost) {
    const SeamOverlap flat(5, 4, 1);
    EXPECT_EQ(seamCost(flat, kDelta, true, seamPath(flat, kDelta, true)), 0);
    SeamOverlap apart(5, 4, 1);
    apart.second.assign(apart.second.size(), 1.0F);
    EXPECT_TRUE(std::isfinite(seamCost(apart, kDelta, false, seamPath(apart, kDelta, false))));
}

TEST(SeamPath, narrowOverlapsHaveOneWay) {
    for (const int across : {1, 2})
        EXPECT_EQ(seamPath(randomOverlap(4, across, 1, 2), kDelta, true), std::vector<int>(4, 1));
}

} // namespace
} // namespace texloom::test

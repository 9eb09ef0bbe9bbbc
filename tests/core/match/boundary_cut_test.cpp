#include "core/match/boundary_cut.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace texloom::test {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// e as the side sees it: along the side from the top or left, across inwards.
using SideError = std::function<double(int along, int across)>;

/// The cheapest of all paths from (first, start) to (last, end), each tried; a negative start or end is free.
double cheapestPath(const SideError& error, int width, int first, int last, int start, int end) {
    const std::function<double(int, int)> rest = [&](int along, int across) -> double {
        if (across < 0 || across >= width)
            return kNever;
        const double own = error(along, across);
        if (along == last)
            return end < 0 || end == across ? own : kNever;
        return own +
               std::min({rest(along + 1, across - 1), rest(along + 1, across), rest(along + 1, across + 1)});
    };
    double best = kNever;
    for (int across = 0; across < width; ++across)
        if (start < 0 || start == across)
            best = std::min(best, rest(first, across));
    return best;
}

/// The cost of the best cut by trying every path of every side for every choice of corners.
double exhaustiveCost(const Image& e, const Overlap& o) {
    const int n = e.width();
    const auto at = [&](int x, int y) { return static_cast<double>(e(x, y, 0)); };
    const SideError left = [&](int along, int across) { return at(across, along); };
    const SideError top = [&](int along, int across) { return at(along, across); };
    const SideError right = [&](int along, int across) { return at(n - 1 - across, along); };
    const SideError bottom = [&](int along, int across) { return at(along, n - 1 - across); };
    const auto choices = [](int a, int b) { return std::min(a, b); };
    const auto side = [&](const SideError& error, int width, int start, int end) {
        if (width == 0)
            return 0.0;
        return cheapestPath(error, width, std::max(0, start), n - 1 - std::max(0, end), start, end);
    };
    double best = kNever;
    const int tls = choices(o.left, o.top), trs = choices(o.top, o.right), brs = choices(o.right, o.bottom),
              bls = choices(o.bottom, o.left);
    for (int tl = tls ? 0 : -1; tl < tls; ++tl)
        for (int tr = trs ? 0 : -1; tr < trs; ++tr)
            for (int br = brs ? 0 : -1; br < brs; ++br)
                for (int bl = bls ? 0 : -1; bl < bls; ++bl) {
                    double cost = side(left, o.left, tl, bl) + side(top, o.top, tl, tr) +
                                  side(right, o.right, tr, br) + side(bottom, o.bottom, bl, br);
                    cost -= tl >= 0 ? at(tl, tl) : 0;
                    cost -= tr >= 0 ? at(n - 1 - tr, tr) : 0;
                    cost -= br >= 0 ? at(n - 1 - br, n - 1 - br) : 0;
                    cost -= bl >= 0 ? at(bl, n - 1 - bl) : 0;
                    best = std::min(best, cost);
                }
    return best;
}

TEST(BoundaryCut, costsWhatTheBestOfAllPathsCosts) {
    for (int shape = 0; shape < 16; ++shape)
        for (std::uint64_t seed = 1; seed < 6; ++seed) {
            const Image error = noise({8, 8}, 1, seed);
            const Overlap overlap{shape & 1 ? 3 : 0, shape & 2 ? 2 : 0, shape & 4 ? 2 : 0, shape & 8 ? 3 : 0};
            EXPECT_NEAR(minimumErrorCut(error.view().plane(0), overlap).cost, exhaustiveCost(error, overlap),
                        1e-9)
                << "shape " << shape << ", seed " << seed;
        }
}

/// Sum of the errors along the new pixels that border on the kept ones of a single side.
TEST(BoundaryCut, keepsExactlyWhatLiesBeyondACutOfThatCost) {
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        const Image error = noise({12, 12}, 1, seed);
        const BoundaryCut vertical = minimumErrorCut(error.view().plane(0), {5, 0, 0, 0});
        const BoundaryCut horizontal = minimumErrorCut(error.view().plane(0), {0, 0, 0, 5});
        double verticalCost = 0, horizontalCost = 0;
        int previous = -1;
        for (int i = 0; i < 12; ++i) {
            int kept = 0, keptBelow = 0;
            while (kept < 12 && vertical.keeps(kept, i))
                ++kept;
            while (keptBelow < 12 && horizontal.keeps(i, 11 - keptBelow))
                ++keptBelow;
            ASSERT_LT(kept, 5);
            ASSERT_LT(keptBelow, 5);
            verticalCost += static_cast<double>(error(kept, i, 0));
            horizontalCost += static_cast<double>(error(i, 11 - keptBelow, 0));
            EXPECT_TRUE(previous < 0 || std::abs(kept - previous) <= 1);
            previous = kept;
        }
        EXPECT_NEAR(verticalCost, vertical.cost, 1e-9);
        EXPECT_NEAR(horizontalCost, horizontal.cost, 1e-9);
    }
}

TEST(BoundaryCut, lShapedCutCountsTheCornerOnce) {
    // Errors of 1 everywhere but along one L whose corner is (1, 1): that L must be the cut.
    Image error = constant({10, 10}, 1, 1);
    for (int i = 1; i < 10; ++i)
        error(1, i, 0) = error(i, 1, 0) = 0.125F;
    const BoundaryCut cut = minimumErrorCut(error.view().plane(0), {4, 4, 0, 0});
    EXPECT_NEAR(cut.cost, 17 * 0.125, 1e-9);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
            EXPECT_EQ(cut.keeps(x, y), x < 1 || y < 1) << x << "," << y;
}

TEST(BoundaryCut, keepsNothingOutsideTheOverlap) {
    for (int shape = 0; shape < 16; ++shape) {
        const Overlap overlap{shape & 1 ? 4 : 0, shape & 2 ? 3 : 0, shape & 4 ? 3 : 0, shape & 8 ? 4 : 0};
        const BoundaryCut cut = minimumErrorCut(noise({10, 10}, 1).view().plane(0), overlap);
        for (int y = 0; y < 10; ++y)
            for (int x = 0; x < 10; ++x) {
                EXPECT_TRUE(!cut.keeps(x, y) || overlap.contains(x, y, 10));
            }
    }
}

} // namespace
} // namespace texloom::test

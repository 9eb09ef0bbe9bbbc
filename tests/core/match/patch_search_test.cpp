#include "core/match/patch_search.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

constexpr int kPatch = 6;

double distance(const Image& exemplar, int x, int y, const Image& known) {
    double sum = 0;
    for (int c = 0; c < known.channels(); ++c)
        for (int v = 0; v < kPatch; ++v)
            for (int u = 0; u < kPatch; ++u)
                sum += std::pow(exemplar(x + u, y + v, c) - known(u, v, c), 2);
    return sum;
}

/// Two searches over exemplars of one size, of other channels, and what both of them look for.
struct Pair {
    Image colours = blobs({40, 30}, 3), heights = noise({40, 30}, 1);
    Image colour{colours.view().crop(5, 8, {kPatch, kPatch})},
        height{heights.view().crop(21, 3, {kPatch, kPatch})};
    Footprint whole = Footprint::filled({kPatch, kPatch});
    PatchSearch first{{{colours, {}}}, kPatch, [] {}};
    PatchSearch second{{{heights, {}}}, kPatch, [] {}};

    PatchSearch::Scratch added(double weight) {
        first.prepare(whole);
        second.prepare(whole);
        PatchSearch::Scratch sum = first.scratch(), other = second.scratch();
        first.compute(colour, whole, sum, [] {});
        second.compute(height, whole, other, [] {});
        first.add(other, weight, sum);
        return sum;
    }
};

TEST(PatchSearch, addedDistancesLeaveTheNearestOfTheSum) {
    Pair pair;
    for (const double weight : {0.1, 1.0, 5.0}) {
        double least = HUGE_VAL;
        for (int y = 0; y + kPatch <= pair.colours.height(); ++y)
            for (int x = 0; x + kPatch <= pair.colours.width(); ++x)
                least = std::min(least, weight * distance(pair.colours, x, y, pair.colour) +
                                            distance(pair.heights, x, y, pair.height));
        const std::vector<PatchPosition> found = pair.first.within(0, pair.added(weight));
        ASSERT_EQ(found.size(), 1U) << weight;
        EXPECT_NEAR(weight * distance(pair.colours, found[0].x, found[0].y, pair.colour) +
                        distance(pair.heights, found[0].x, found[0].y, pair.height),
                    least, 1e-4 * least);
    }
}

TEST(PatchSearch, raisedPatchesAreFartherByTheAmount) {
    Pair pair;
    const PatchSearch::Scratch before = pair.added(1);
    PatchSearch::Scratch after = pair.added(1);
    const Image by = noise({35, 25}, 1);
    pair.first.raise({by}, 3, after);
    const PatchDistances reader(pair.colours, {}, channelMeans(pair.colours.view()), kPatch);
    for (int y = 0; y < 25; ++y)
        for (int x = 0; x < 35; ++x)
            EXPECT_NEAR(reader.distanceRow(after[0], y)[x],
                        reader.distanceRow(before[0], y)[x] + 3 * by(x, y, 0), 1e-4);
}

TEST(PatchSearch, discouragedPatchesAreFartherByTheShareOfTheirPixels) {
    Pair pair;
    const PatchSearch::Scratch before = pair.added(1);
    PatchSearch::Scratch after = pair.added(1);
    // Near a corner, so that squares reach over the borders of what there is.
    pair.first.discourage({0, 3, 22}, 2, after);
    const PatchDistances reader(pair.colours, {}, channelMeans(pair.colours.view()), kPatch);
    float least = HUGE_VALF;
    for (int y = 0; y + kPatch <= pair.colours.height(); ++y)
        for (int x = 0; x + kPatch <= pair.colours.width(); ++x) {
            const int shared = std::max(0, kPatch - std::abs(x - 3)) * std::max(0, kPatch - std::abs(y - 22));
            const float now = reader.distanceRow(after[0], y)[x];
            EXPECT_NEAR(now, reader.distanceRow(before[0], y)[x] * (1 + 2.0 * shared / (kPatch * kPatch)),
                        1e-4 * now);
            EXPECT_GE(now, after[0].rowMinima[static_cast<std::size_t>(y)]);
            least = std::min(least, now);
        }
    const std::vector<PatchPosition> nearest = pair.first.within(0, after);
    ASSERT_FALSE(nearest.empty());
    for (const PatchPosition& position : nearest)
        EXPECT_EQ(reader.distanceRow(after[0], position.y)[position.x], least);
}

} // namespace
} // namespace texloom::test

#include "core/match/neighbourhood_tree.h"
#include "tests/core/match/interleaved_image.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace texloom::test {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

std::vector<NeighbourhoodSource> only(const Interleaved& pixels, const PlaneView& mask = {}) {
    NeighbourhoodSource source;
    source.pictures.push_back(&pixels);
    source.mask = mask;
    return {source};
}

TEST(PixelRuns, halvesAndCentreMakeTheSquare) {
    for (const int side : {1, 3, 9}) {
        EXPECT_EQ(pixelCount(causalRuns(side)), (side * side - 1) / 2);
        EXPECT_EQ(pixelCount(followingRuns(side)), (side * side - 1) / 2);
        EXPECT_EQ(pixelCount(aroundRuns(side)), side * side - 1);
        EXPECT_EQ(pixelCount(squareRuns(side)), side * side);
    }
    EXPECT_EQ(pixelCount(clippedRuns(squareRuns(5), 0, 1, {10, 10}, {})), 3 * 4);
    EXPECT_EQ(pixelCount(clippedRuns(squareRuns(5), 0, 1, {10, 10}, {true, false})), 5 * 4);
}

TEST(Neighbourhood, distanceIsTheSumOfWeighedSquaredDifferences) {
    for (const int channels : {1, 2, 3, 5}) {
        const Image fine = noise({20, 18}, channels, 1), coarse = noise({10, 9}, channels, 2);
        const Image other = noise({20, 18}, channels, 3), otherCoarse = noise({10, 9}, channels, 4);
        const Interleaved a = interleaved(fine), b = interleaved(coarse), c = interleaved(other),
                          d = interleaved(otherCoarse);
        std::vector<float> weights(12);
        for (std::size_t i = 0; i < weights.size(); ++i)
            weights[i] = 0.5F + static_cast<float>(i);
        const Neighbourhood neighbourhood({{causalRuns(5), false, weights}, {squareRuns(3), true, {}}},
                                          {a.pixel, b.pixel});
        const Interleaved* const from[] = {&c, &d};
        const Interleaved* const in[] = {&a, &b};
        std::vector<float> wanted(static_cast<std::size_t>(neighbourhood.length()));
        neighbourhood.gather(from, 1, 0, wanted.data());
        for (int y = 2; y < 16; ++y)
            for (int x = 2; x < 18; ++x) {
                double expected = 0;
                std::size_t at = 0;
                for (int dy = -2; dy <= 0; ++dy)
                    for (int dx = -2; dx <= (dy < 0 ? 2 : -1); ++dx, ++at)
                        for (int k = 0; k < channels; ++k)
                            expected +=
                                static_cast<double>(weights[at]) *
                                std::pow(static_cast<double>(other((21 + dx) % 20, (18 + dy) % 18, k)) -
                                             static_cast<double>(fine(x + dx, y + dy, k)),
                                         2);
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        for (int k = 0; k < channels; ++k)
                            expected +=
                                std::pow(static_cast<double>(otherCoarse((10 + dx) % 10, (9 + dy) % 9, k)) -
                                             static_cast<double>(coarse(x / 2 + dx, y / 2 + dy, k)),
                                         2);
                ASSERT_TRUE(neighbourhood.within(in, x, y));
                EXPECT_NEAR(static_cast<double>(neighbourhood.distance(wanted.data(), in, x, y, kFar)),
                            expected, 1e-5 * expected);
            }
        EXPECT_FALSE(neighbourhood.within(in, 1, 5));
        EXPECT_FALSE(neighbourhood.within(in, 18, 5));
        EXPECT_FALSE(neighbourhood.within(in, 5, 1));
        // The coarser scale's square reaches further down.
        EXPECT_TRUE(neighbourhood.within(in, 5, 15));
        EXPECT_FALSE(neighbourhood.within(in, 5, 16));
    }
}

TEST(Neighbourhood, goesOnRoundBordersOrIntoTheMargin) {
    const Image image = noise({9, 7}, 2, 3), wide = noise({15, 13}, 2, 4);
    const Interleaved pixels = interleaved(image), widePixels = interleaved(wide);
    const Interleaved* const from[] = {&pixels, &widePixels};
    const Neighbourhood neighbourhood({{squareRuns(5), false, {}}, {squareRuns(3), false, {}, 3}},
                                      {pixels.pixel, widePixels.pixel});
    std::vector<float> found(static_cast<std::size_t>(neighbourhood.length()));
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x) {
            neighbourhood.gather(from, x, y, found.data());
            EXPECT_EQ(neighbourhood.within(from, x, y), x >= 2 && x < 7 && y >= 2 && y < 5);
            std::size_t at = 0;
            for (int v = y - 2; v <= y + 2; ++v)
                for (int u = x - 2; u <= x + 2; ++u)
                    for (int c = 0; c < 2; ++c, ++at)
                        ASSERT_EQ(found[at], image((u + 9) % 9, (v + 7) % 7, c)) << x << ", " << y;
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u)
                    for (int c = 0; c < 2; ++c, ++at)
                        ASSERT_EQ(found[at], wide(u + 3, v + 3, c)) << x << ", " << y;
        }
}

TEST(NeighbourhoodSet, showsNothingThatTheMaskHides) {
    const Image image = noise({20, 20}, 1);
    const Interleaved pixels = interleaved(image);
    Image mask = constant({20, 20}, 1, 1);
    mask(10, 10, 0) = 0;
    const NeighbourhoodSet set(Neighbourhood({{causalRuns(5), false, {}}}, {1}),
                               only(pixels, mask.view().plane(0)), [] {});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) {
            const bool lies = x >= 2 && x < 18 && y >= 2;
            const int dx = 10 - x, dy = 10 - y;
            const bool hidden = std::abs(dx) <= 2 && dy <= 0 && dy >= -2 && (dy < 0 || dx <= 0);
            EXPECT_EQ(set.has(x, y, 0), lies && !hidden) << x << "," << y;
        }
    EXPECT_FALSE(set.has(-1, 5, 0));
    EXPECT_FALSE(set.has(20, 5, 0));
}

TEST(NeighbourhoodSet, partsWithAMarginTakeNothingAway) {
    const Interleaved pixels = interleaved(noise({20, 20}, 1)), guide = interleaved(noise({24, 24}, 1));
    Image mask = constant({20, 20}, 1, 1);
    mask(10, 10, 0) = 0;
    std::vector<NeighbourhoodSource> sources = only(pixels, mask.view().plane(0));
    const NeighbourhoodSet plain(Neighbourhood({{causalRuns(5), false, {}}}, {1}), sources, [] {});
    sources.front().pictures.push_back(&guide);
    const NeighbourhoodSet guided(
        Neighbourhood({{causalRuns(5), false, {}}, {squareRuns(5), false, {}, 2}}, {1, 1}), sources, [] {});
    EXPECT_EQ(plain.sources(), guided.sources());
}

TEST(NeighbourhoodTree, findsWhatIsThereAndNearlyTheNearestElse) {
    const Image image = blobs({80, 70}, 3), other = blobs({80, 70}, 3, 9);
    const Interleaved pixels = interleaved(image), queries = interleaved(other);
    const NeighbourhoodSet set(Neighbourhood({{causalRuns(7), false, {}}}, {pixels.pixel}), only(pixels),
                               [] {});
    const NeighbourhoodTree tree(set, {}, [] {});
    std::vector<float> wanted(static_cast<std::size_t>(set.neighbourhood().length()));
    double exact = 0, found = 0;
    for (int y = 5; y < 60; y += 5)
        for (int x = 5; x < 70; x += 5) {
            const Interleaved* const own[] = {&pixels};
            set.neighbourhood().gather(own, x, y, wanted.data());
            EXPECT_EQ(set.distance(wanted.data(), tree.nearest(wanted.data(), 1), kFar), 0);
            const Interleaved* const strange[] = {&queries};
            set.neighbourhood().gather(strange, x, y, wanted.data());
            const Source nearest = set.nearest(wanted.data(), kFar, [] {});
            for (const Source& source : set.sources())
                ASSERT_GE(set.distance(wanted.data(), source, kFar),
                          set.distance(wanted.data(), nearest, kFar));
            exact += static_cast<double>(set.distance(wanted.data(), nearest, kFar));
            found += static_cast<double>(set.distance(wanted.data(), tree.nearest(wanted.data(), 4), kFar));
        }
    EXPECT_LT(found, 1.25 * exact);
}

TEST(NeighbourhoodTree, isTheSameInWhateverOrderItIsDivided) {
    const Interleaved pixels = interleaved(blobs({120, 110}, 3));
    const NeighbourhoodSet set(Neighbourhood({{causalRuns(7), false, {}}}, {pixels.pixel}), only(pixels),
                               [] {});
    const NeighbourhoodTree tree(set, {}, [] {});
    int most = 0;
    const NeighbourhoodTree backwards(
        set, {}, [] {},
        [&most](int count, const std::function<void(int)>& body) {
            most = std::max(most, count);
            for (int i = count - 1; i >= 0; --i)
                body(i);
        });
    EXPECT_GT(most, 2);
    const Interleaved queries = interleaved(blobs({120, 110}, 3, 9));
    std::vector<float> wanted(static_cast<std::size_t>(set.neighbourhood().length()));
    for (int y = 5; y < 105; y += 5)
        for (int x = 5; x < 115; x += 5) {
            const Interleaved* const from[] = {&queries};
            set.neighbourhood().gather(from, x, y, wanted.data());
            NeighbourhoodTree::Lookup one(tree, wanted.data()), other(backwards, wanted.data());
            for (int leaf = 0; leaf < 3; ++leaf)
                EXPECT_THAT(one.next(), testing::ElementsAreArray(other.next()));
        }
}

TEST(NeighbourhoodTree, leavesHoldEveryNeighbourhoodOnce) {
    const Interleaved flat(Size{12, 12}, 1);
    const NeighbourhoodSet set(Neighbourhood({{squareRuns(3), false, {}}}, {1}), only(flat), [] {});
    NeighbourhoodTree::Options options;
    options.leaf = 16;
    const NeighbourhoodTree tree(set, options, [] {});
    std::vector<float> wanted(9, 0.5F);
    NeighbourhoodTree::Lookup lookup(tree, wanted.data());
    std::vector<int> met(144, 0);
    for (auto leaf = lookup.next(); !leaf.empty(); leaf = lookup.next())
        for (const Source& source : leaf)
            ++met[static_cast<std::size_t>(source.y * 12 + source.x)];
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x)
            EXPECT_EQ(met[static_cast<std::size_t>(y * 12 + x)], set.has(x, y, 0) ? 1 : 0);
}

} // namespace
} // namespace texloom::test

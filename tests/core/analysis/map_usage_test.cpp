#include "core/analysis/map_usage.h"
#include "core/job/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texloom::test {

namespace {

/// Blocks of random pieces of an exemplar, some of them next to each other as they were.
PositionMap pieces(Size size, Size exemplar, int block) {
    const Random random(3);
    PositionMap map(size, {exemplar});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto which = random.below(3, x / block, y / block);
            map.at(x, y) = {static_cast<std::uint16_t>((x + 5 * static_cast<int>(which)) % exemplar.width),
                            static_cast<std::uint16_t>((y + 7 * static_cast<int>(which)) % exemplar.height),
                            0};
        }
    return map;
}

/// The largest region by flooding.
double floodedShare(const PositionMap& map) {
    const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * map.width() + x); };
    std::vector<bool> seen(static_cast<std::size_t>(map.size().area()), false);
    const auto offset = [&](int x, int y) { return std::pair{map.at(x, y).x - x, map.at(x, y).y - y}; };
    std::int64_t largest = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
            std::vector<std::pair<int, int>> open;
            std::int64_t count = 0;
            if (!seen[index(x, y)])
                open.emplace_back(x, y);
            seen[index(x, y)] = true;
            while (!open.empty()) {
                const auto [u, v] = open.back();
                open.pop_back();
                ++count;
                for (const auto& [a, b] : {std::pair{u + 1, v}, {u - 1, v}, {u, v + 1}, {u, v - 1}})
                    if (a >= 0 && b >= 0 && a < map.width() && b < map.height() && !seen[index(a, b)] &&
                        offset(a, b) == offset(u, v)) {
                        seen[index(a, b)] = true;
                        open.emplace_back(a, b);
                    }
            }
            largest = std::max(largest, count);
        }
    return static_cast<double>(largest) / static_cast<double>(map.size().area());
}

} // namespace

TEST(LargestVerbatimRegion, isWhatFloodingFinds) {
    for (const int block : {1, 3, 8})
        for (const Size size : {Size{60, 40}, Size{33, 71}, Size{1, 9}}) {
            const PositionMap map = pieces(size, {50, 45}, block);
            EXPECT_DOUBLE_EQ(largestVerbatimRegion(map), floodedShare(map)) << "blocks of " << block;
        }
}

TEST(LargestVerbatimRegion, ofACopyIsAll) {
    EXPECT_EQ(largestVerbatimRegion(PositionMap::identity({20, 30})), 1);
    EXPECT_EQ(largestVerbatimRegion(PositionMap({20, 30}, {{4, 4}})), 0) << "without any source";
}

TEST(Occurrence, ofACopyIsOneEverywhere) {
    const Image image = occurrence(PositionMap::identity({20, 30}), 0);
    EXPECT_EQ(valueRange(image).smallest, 1);
    EXPECT_EQ(valueRange(image).largest, 1);
    EXPECT_EQ(valueRange(occurrencePicture(image)).largest, 0.5F);
    EXPECT_NEAR(occurrenceEntropy({image}), 1, 0.01);
}

TEST(Occurrence, hasMeanOneOverAllExemplars) {
    PositionMap map = pieces({90, 80}, {31, 27}, 5);
    std::vector<Image> images = occurrencesOf(map);
    EXPECT_NEAR(channelMeans(images[0])[0], 1, 1e-5);
    PositionMap two({40, 40}, {{10, 10}, {30, 10}});
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            two.at(x, y) = {3, 4, static_cast<std::uint16_t>(x < 10 ? 1 : 0)};
    images = occurrencesOf(two);
    EXPECT_FLOAT_EQ(images[0](3, 4, 0), 0.75F * 400);
    EXPECT_FLOAT_EQ(images[1](3, 4, 0), 0.25F * 400);
    EXPECT_EQ(images[1](4, 4, 0), 0);
}

TEST(OccurrenceEntropy, isZeroForOneCellAndHalfForTheRootOfTheCells) {
    const auto used = [](int columns, int rows) {
        Image image({64, 64}, 1);
        for (int y = 0; y < 8 * rows; ++y)
            for (int x = 0; x < 8 * columns; ++x)
                image(x, y, 0) = 1;
        return occurrenceEntropy({image});
    };
    EXPECT_NEAR(used(1, 1), 0, 1e-12);
    EXPECT_NEAR(used(8, 1), 0.5, 1e-9);
    EXPECT_NEAR(used(8, 8), 1, 1e-9);
}

} // namespace texloom::test

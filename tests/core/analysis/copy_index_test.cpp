#include "core/analysis/copy_index.h"
#include "core/job/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace texloom::test {

namespace {

/// A map of pieces of `side` pixels, each copied from a place drawn at random from one of two exemplars.
PositionMap pieces(Size size, int side) {
    const std::vector<Size> exemplars = {{40, 30}, {50, 60}};
    const Random random(7);
    PositionMap map(size, exemplars);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int column = x / side, row = y / side;
            const auto below = [&](int count, std::uint32_t n) {
                return static_cast<int>(random.below(static_cast<std::uint32_t>(count), column, row, n));
            };
            const int exemplar = below(2, 0);
            const Size from = exemplars[static_cast<std::size_t>(exemplar)];
            const int left = below(from.width - side + 1, 1), top = below(from.height - side + 1, 2);
            map.at(x, y) = {static_cast<std::uint16_t>(left + x % side),
                            static_cast<std::uint16_t>(top + y % side), static_cast<std::uint16_t>(exemplar)};
        }
    return map;
}

std::vector<CopyIndex::Place> everyCopy(const PositionMap& map, const Source& source) {
    std::vector<CopyIndex::Place> places;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x)
            if (map.at(x, y) == source)
                places.push_back({x, y});
    return places;
}

} // namespace

TEST(CopyIndex, FindsEveryCopy) {
    PositionMap map = pieces({70, 50}, 10);
    map.at(3, 4) = {};
    const CopyIndex index(map);
    for (const Source source : {map.at(0, 0), map.at(69, 49), map.at(33, 21), Source{39, 29, 0}})
        EXPECT_EQ(index.copiesOf(source, 1000), everyCopy(map, source));
    EXPECT_TRUE(index.copiesOf({}, 1000).empty());
}

TEST(CopyIndex, OfALargeMapFindsTheCopiesOfPieces) {
    const PositionMap map = pieces({200, 160}, 20);
    const CopyIndex index(map, 200 * 160 / 9);
    int found = 0, asked = 0;
    for (int y = 8; y < 160; y += 20)
        for (int x = 8; x < 200; x += 20) {
            const auto all = everyCopy(map, map.at(x, y));
            const auto known = index.copiesOf(map.at(x, y), 1000);
            for (const CopyIndex::Place& place : all) {
                ++asked;
                found += std::find(known.begin(), known.end(), place) != known.end() ? 1 : 0;
            }
        }
    EXPECT_GT(asked, 80);
    EXPECT_EQ(found, asked);
}

TEST(CopyIndex, StopsAtTheMostWanted) {
    PositionMap all({8, 8}, {{1, 1}});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            all.at(x, y) = {0, 0, 0};
    EXPECT_EQ(CopyIndex(all).copiesOf({0, 0, 0}, 5).size(), 5U);
    EXPECT_EQ(CopyIndex(all).copiesOf({0, 0, 0}, 500).size(), 64U);
}

} // namespace texloom::test

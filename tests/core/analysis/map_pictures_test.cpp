#include "core/analysis/map_pictures.h"
#include "core/job/random.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

namespace texloom::test {

namespace {

std::tuple<float, float, float> colorAt(const Image& image, int x, int y) {
    return {image(x, y, 0), image(x, y, 1), image(x, y, 2)};
}

double difference(const Image& image, int x, int y, int otherX, int otherY) {
    double sum = 0;
    for (int c = 0; c < 3; ++c)
        sum += std::abs(static_cast<double>(image(x, y, c)) - static_cast<double>(image(otherX, otherY, c)));
    return sum;
}

} // namespace

TEST(PositionPicture, GivesEveryPixelAColourOfItsOwn) {
    std::set<std::tuple<float, float, float>> colors;
    const Image first = positionPicture({64, 48}, 0, 2);
    const Image second = positionPicture({64, 48}, 1, 2);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            colors.insert(colorAt(first, x, y));
            colors.insert(colorAt(second, x, y));
        }
    EXPECT_GT(colors.size(), 2U * 64 * 48 * 99 / 100);
}

TEST(PositionPicture, StaysBetweenBlackAndWhite) {
    const ValueRange range = valueRange(positionPicture({65, 33}));
    EXPECT_GE(range.smallest, 0);
    EXPECT_LE(range.largest, 1);
}

TEST(PositionPicture, NeighboursDifferLessThanFarPixels) {
    const Image picture = positionPicture({64, 64});
    double near = 0, far = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            near += difference(picture, x, y, x + 1, y);
            far += difference(picture, x, y, x + 31, y + 31);
        }
    EXPECT_GT(far, 5 * near);
}

TEST(SynthesisPicture, ShowsTheColourOfTheSource) {
    PositionMap map({2, 1}, {{8, 8}, {16, 4}});
    map.at(0, 0) = {3, 5, 0};
    map.at(1, 0) = {12, 2, 1};
    const Image picture = synthesisPicture(map);
    EXPECT_EQ(colorAt(picture, 0, 0), colorAt(positionPicture({8, 8}, 0, 2), 3, 5));
    EXPECT_EQ(colorAt(picture, 1, 0), colorAt(positionPicture({16, 4}, 1, 2), 12, 2));
}

TEST(SynthesisPicture, IsBlackWithoutASource) {
    EXPECT_TRUE(samePixels(synthesisPicture(PositionMap({5, 4}, {{8, 8}})), Image({5, 4}, 3)));
}

TEST(Innovation, OfACopyIsNought) {
    EXPECT_EQ(innovation(PositionMap::identity({30, 20})), 0);
}

TEST(Innovation, OfScatteredSourcesIsNearOne) {
    const Random random(2);
    PositionMap map({60, 60}, {{500, 500}});
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x)
            map.at(x, y) = {static_cast<std::uint16_t>(random.below(500, x, y, 0)),
                            static_cast<std::uint16_t>(random.below(500, x, y, 1)), 0};
    EXPECT_GT(innovation(map), 0.99);
}

TEST(Innovation, CountsTheBrokenPairs) {
    // Two halves moved apart: of 10 × 8 pixels, 8 of the 9 × 8 + 10 × 7 pairs are broken.
    PositionMap map = PositionMap::identity({10, 8});
    for (int y = 0; y < 8; ++y)
        for (int x = 5; x < 10; ++x)
            map.at(x, y).x = static_cast<std::uint16_t>(x - 3);
    EXPECT_DOUBLE_EQ(innovation(map), 8.0 / (9 * 8 + 10 * 7));
}

TEST(Innovation, SeesAChangeOfExemplar) {
    PositionMap map({10, 1}, {{10, 1}, {10, 1}});
    for (int x = 0; x < 10; ++x)
        map.at(x, 0) = {static_cast<std::uint16_t>(x), 0, static_cast<std::uint16_t>(x < 5 ? 0 : 1)};
    EXPECT_DOUBLE_EQ(innovation(map), 1.0 / 9);
}

TEST(Innovation, OfOnePixelIsNought) {
    EXPECT_EQ(innovation(PositionMap::identity({1, 1})), 0);
}

TEST(CopiedRegionsPicture, GivesPiecesOneColourAndBlackBorders) {
    PositionMap map({8, 3}, {{20, 20}});
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 8; ++x)
            map.at(x, y) = {static_cast<std::uint16_t>(x < 4 ? x + 5 : x), static_cast<std::uint16_t>(y), 0};
    const Image picture = copiedRegionsPicture(map);
    EXPECT_EQ(colorAt(picture, 0, 0), colorAt(picture, 3, 2));
    EXPECT_EQ(colorAt(picture, 5, 0), colorAt(picture, 7, 2));
    EXPECT_NE(colorAt(picture, 0, 0), colorAt(picture, 7, 2));
    EXPECT_EQ(colorAt(picture, 4, 1), std::tuple(0.0F, 0.0F, 0.0F));
    EXPECT_GT(std::get<0>(colorAt(picture, 0, 0)) + std::get<1>(colorAt(picture, 0, 0)) +
                  std::get<2>(colorAt(picture, 0, 0)),
              0.3F);
}

} // namespace texloom::test

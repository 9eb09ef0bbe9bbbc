#include "core/base/error.h"
#include "core/image/position_map.h"
#include "core/job/random.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace texloom::test {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

PositionMap randomMap(Size size, const std::vector<Size>& exemplars) {
    const Random random(5);
    PositionMap map(size, exemplars);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::uint32_t which = random.below(static_cast<std::uint32_t>(exemplars.size()), x, y, 0);
            const Size from = exemplars[which];
            map.at(x, y) = {
                static_cast<std::uint16_t>(random.below(static_cast<std::uint32_t>(from.width), x, y, 1)),
                static_cast<std::uint16_t>(random.below(static_cast<std::uint32_t>(from.height), x, y, 2)),
                static_cast<std::uint16_t>(which)};
        }
    return map;
}

} // namespace

TEST(PositionMap, IdentityGivesEveryBitBack) {
    Image image({37, 21}, 5);
    const std::array<float, 6> extremes = {65504.0F,
                                           -3.5F,
                                           -0.0F,
                                           std::numeric_limits<float>::denorm_min(),
                                           std::numeric_limits<float>::max(),
                                           std::nextafter(1.0F, 2.0F)};
    std::size_t next = 0;
    for (int c = 0; c < 5; ++c)
        for (int y = 0; y < 21; ++y)
            for (int x = 0; x < 37; ++x)
                image(x, y, c) = extremes[next++ % extremes.size()];
    const Image back = PositionMap::identity(image.size()).apply(image);
    for (int c = 0; c < 5; ++c)
        for (int y = 0; y < 21; ++y)
            for (int x = 0; x < 37; ++x)
                ASSERT_EQ(std::bit_cast<std::uint32_t>(back(x, y, c)),
                          std::bit_cast<std::uint32_t>(image(x, y, c)));
}

TEST(PositionMap, PicksFromEachExemplar) {
    const Image first = noise({13, 9}, 3, 1);
    const Image second = noise({7, 31}, 3, 2);
    const PositionMap map = randomMap({40, 25}, {first.size(), second.size()});
    const std::array<ImageView, 2> views = {first, second};
    const Image made = map.apply(views);
    for (int y = 0; y < 25; ++y)
        for (int x = 0; x < 40; ++x) {
            const Source source = map.at(x, y);
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(made(x, y, c), views[source.exemplar](source.x, source.y, c));
        }
}

TEST(PositionMap, LeavesPixelsWithoutASourceBlack) {
    const PositionMap map({6, 4}, {{5, 5}});
    EXPECT_TRUE(samePixels(map.apply(constant({5, 5}, 2, 9)), Image({6, 4}, 2)));
}

TEST(PositionMap, RefusesAnImageOfAnotherSize) {
    const PositionMap map = PositionMap::identity({8, 6});
    EXPECT_THAT(
        [&] {
            map.apply(Image({6, 8}, 1));
        },
        ThrowsMessage<Error>(AllOf(HasSubstr("6 × 8"), HasSubstr("8 × 6"))));
}

TEST(PositionMap, RefusesAnotherNumberOfImages) {
    const PositionMap map({4, 4}, {{8, 8}, {8, 8}});
    EXPECT_THAT([&] { map.apply(Image({8, 8}, 1)); }, ThrowsMessage<Error>(HasSubstr("2, not 1")));
}

TEST(PositionMap, RefusesToWorkWithoutImages) {
    EXPECT_THAT([] { PositionMap{}.apply(std::span<const ImageView>()); },
                ThrowsMessage<Error>(HasSubstr("none was given")));
}

TEST(PositionMap, RefusesImagesWithUnequalChannels) {
    const PositionMap map({4, 4}, {{8, 8}, {8, 8}});
    const Image one({8, 8}, 1), three({8, 8}, 3);
    const std::array<ImageView, 2> views = {one, three};
    EXPECT_THAT([&] { map.apply(views); },
                ThrowsMessage<Error>(AllOf(HasSubstr("1"), HasSubstr("3 channels"))));
}

TEST(PositionMap, ShrinksToTheTopLeft) {
    const PositionMap before = randomMap({23, 17}, {{50, 50}});
    PositionMap map = before;
    map.shrink({10, 12});
    EXPECT_EQ(map.size(), (Size{10, 12}));
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 10; ++x)
            ASSERT_EQ(map.at(x, y), before.at(x, y));
}

TEST(PositionMap, AppliesAsBeforeOnceShrunk) {
    const Image exemplar = noise({50, 50}, 3);
    PositionMap map = randomMap({23, 17}, {{50, 50}});
    const Image whole = map.apply(exemplar);
    map.shrink({10, 12});
    EXPECT_TRUE(samePixels(map.apply(exemplar), whole.view().crop(0, 0, {10, 12})));
}

} // namespace texloom::test

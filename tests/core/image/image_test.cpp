#include "core/base/error.h"
#include "core/image/image.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

namespace texloom::test {

TEST(Image, AlignsEveryRowTo64Bytes) {
    for (int width = 1; width <= 70; ++width) {
        const Image image({width, 5}, 3);
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < 5; ++y)
                EXPECT_EQ(reinterpret_cast<std::uintptr_t>(image.plane(c).row(y)) % 64, 0U) << width;
    }
}

TEST(Image, BeginsBlack) {
    EXPECT_TRUE(samePixels(Image({33, 7}, 2), constant({33, 7}, 2, 0)));
}

TEST(Image, KeepsEverySampleApart) {
    Image image({19, 11}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 19; ++x)
                image(x, y, c) = static_cast<float>(x + 100 * y + 10000 * c);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 19; ++x)
                EXPECT_EQ(image.view().plane(c)(x, y), static_cast<float>(x + 100 * y + 10000 * c));
}

TEST(Image, RefusesToHaveNoPixels) {
    EXPECT_THROW(Image({0, 5}, 1), Error);
    EXPECT_THROW(Image({5, -1}, 1), Error);
    EXPECT_THROW(Image({5, 5}, 0), Error);
}

TEST(Image, CopiesItsPixels) {
    const Image original = noise({20, 9}, 2);
    Image copy = original;
    EXPECT_TRUE(samePixels(copy, original));
    copy(3, 4, 1) += 1;
    EXPECT_FALSE(samePixels(copy, original));
}

TEST(Image, AssignsOverAnotherSize) {
    const Image original = noise({20, 9}, 2);
    Image target = noise({3, 3}, 1);
    target = original;
    EXPECT_TRUE(samePixels(target, original));
}

TEST(Image, MovesWithoutCopying) {
    Image original = noise({20, 9}, 2);
    const float* pixels = original.plane(0).data;
    const Image moved = std::move(original);
    EXPECT_EQ(moved.plane(0).data, pixels);
}

TEST(Image, CopiesAnEmptyOne) {
    const Image none;
    const Image copy(none); // NOLINT(performance-unnecessary-copy-initialization)
    EXPECT_TRUE(copy.empty());
}

TEST(ImageView, CropSeesTheRectangle) {
    const Image image = noise({23, 17}, 3);
    const ImageView part = image.view().crop(5, 6, {10, 8});
    EXPECT_EQ(part.size(), (Size{10, 8}));
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 10; ++x)
                EXPECT_EQ(part(x, y, c), image(x + 5, y + 6, c));
}

TEST(ImageView, BecomesAnImageOfItsOwn) {
    const Image image = noise({23, 17}, 3);
    const ImageView part = image.view().crop(5, 6, {10, 8});
    EXPECT_TRUE(samePixels(Image(part), part));
}

TEST(Image, ShrinksToTheTopLeft) {
    Image image = noise({23, 17}, 3);
    const Image before = image;
    image.shrink({10, 8});
    EXPECT_TRUE(samePixels(image, before.view().crop(0, 0, {10, 8})));
}

TEST(Image, NeverGrowsByShrinking) {
    Image image({10, 8}, 1);
    image.shrink({99, 4});
    EXPECT_EQ(image.size(), (Size{10, 4}));
}

TEST(SamePixels, SeesOneSample) {
    const Image image = noise({9, 9}, 3);
    for (const int c : {0, 1, 2}) {
        Image other = image;
        other(8, 8, c) += 1;
        EXPECT_FALSE(samePixels(image, other)) << c;
    }
}

TEST(SamePixels, SeesSizeAndChannels) {
    EXPECT_FALSE(samePixels(Image({4, 6}, 1), Image({6, 4}, 1)));
    EXPECT_FALSE(samePixels(Image({4, 6}, 1), Image({4, 6}, 2)));
}

TEST(SamePixels, LooksAtNothingBesideThePixels) {
    Image wide = noise({32, 8}, 1);
    Image cropped = wide;
    cropped(20, 3, 0) += 1;
    wide.shrink({16, 8});
    cropped.shrink({16, 8});
    EXPECT_TRUE(samePixels(wide, cropped));
}

TEST(ValueRange, SpansAllChannels) {
    Image image = constant({5, 4}, 3, 0.5F);
    image(4, 3, 2) = 7;
    image(0, 0, 1) = -2;
    EXPECT_EQ(valueRange(image).smallest, -2);
    EXPECT_EQ(valueRange(image).largest, 7);
}

TEST(ChannelMeans, AverageEachChannel) {
    Image image({4, 3}, 2);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) {
            image(x, y, 0) = static_cast<float>(x);
            image(x, y, 1) = 10;
        }
    EXPECT_EQ(channelMeans(image), (std::vector<double>{1.5, 10}));
}

} // namespace texloom::test

#include "core/analysis/texture_distance.h"
#include "core/job/job.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace texloom::test {

namespace {

TextureDistance distanceOf(const ImageView& result, const std::vector<ImageView>& exemplars,
                           int threads = 2) {
    Job<TextureDistance> job({0, threads, false}, [&](JobContext& context) {
        return textureDistance(result, exemplars, context);
    });
    return std::get<TextureDistance>(job.take());
}

Image scaled(const Image& image, float factor, float offset) {
    Image made(image);
    for (int c = 0; c < made.channels(); ++c)
        for (int y = 0; y < made.height(); ++y)
            for (int x = 0; x < made.width(); ++x)
                made(x, y, c) = factor * made(x, y, c) + offset;
    return made;
}

} // namespace

TEST(TextureDistance, ofAnImageToItselfIsZero) {
    for (const int channels : {1, 3, 6}) {
        const Image image = blobs({70, 60}, channels);
        const TextureDistance distance = distanceOf(image, {image});
        EXPECT_EQ(distance.color, 0);
        EXPECT_EQ(distance.components[0], 0);
        EXPECT_EQ(distance.components[1], 0);
        for (const double moved : distance.wasserstein)
            EXPECT_EQ(moved, 0);
    }
}

TEST(TextureDistance, isSmallForMoreOfTheSameAndLargeForAnother) {
    const Image image = blobs({160, 160}, 3);
    const ImageView left = image.view().crop(0, 0, {80, 160}), right = image.view().crop(80, 0, {80, 160});
    const TextureDistance same = distanceOf(left, {right});
    const Image flat = scaled(image, 0.2F, 0.4F), grain = noise({160, 160}, 3);
    for (const Image* other : {&flat, &grain}) {
        const TextureDistance apart = distanceOf(*other, {right});
        EXPECT_GT(apart.wasserstein[0], 2 * same.wasserstein[0]);
        EXPECT_GT(apart.wasserstein[2], 2 * same.wasserstein[2]);
        EXPECT_GT(apart.components[0], same.components[0]);
    }
    EXPECT_GT(distanceOf(flat, {right}).color, 2 * same.color);
}

TEST(TextureDistance, ofDisjointColoursIsOneAndGrowsWithTheShift) {
    const Image image = noise({100, 100}, 1);
    EXPECT_NEAR(distanceOf(scaled(image, 1, 5), {image}).color, 1, 0.02);
    // Every projection moves by the same for twice the shift.
    const double once = distanceOf(scaled(image, 1, 5), {image}).wasserstein[0];
    const double twice = distanceOf(scaled(image, 1, 10), {image}).wasserstein[0];
    EXPECT_NEAR(twice / once, 2, 0.02);
}

TEST(TextureDistance, doesNotDependOnTheUnitOrTheThreads) {
    const Image image = blobs({90, 90}, 3), other = blobs({120, 80}, 3, 5);
    const TextureDistance one = distanceOf(image, {other}, 1), many = distanceOf(image, {other}, 5);
    EXPECT_EQ(one.wasserstein, many.wasserstein);
    EXPECT_EQ(one.color, many.color);
    const TextureDistance bright = distanceOf(scaled(image, 64, 0), {scaled(other, 64, 0)});
    EXPECT_NEAR(bright.wasserstein[1], one.wasserstein[1], 1e-4);
    EXPECT_NEAR(bright.color, one.color, 1e-9);
}

TEST(TextureDistance, ofTinyAndConstantImagesIsFinite) {
    const Image tiny = noise({1, 1}, 2), flat = constant({30, 30}, 2, 0.25F);
    EXPECT_TRUE(std::isfinite(distanceOf(tiny, {flat}).wasserstein[0]));
    EXPECT_EQ(distanceOf(flat, {flat}).wasserstein[0], 0);
    EXPECT_EQ(distanceOf(flat, {flat}).color, 0);
}

} // namespace texloom::test

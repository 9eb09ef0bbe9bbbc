#include "core/job/random.h"
#include "core/math/zoom.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace texloom::test {
namespace {

double largestDifference(const ImageView& a, const ImageView& b, int margin = 0) {
    double largest = 0;
    for (int c = 0; c < a.channels; ++c)
        for (int y = margin; y < a.height - margin; ++y)
            for (int x = margin; x < a.width - margin; ++x)
                largest = std::max(largest, std::abs(static_cast<double>(a(x, y, c) - b(x, y, c))));
    return largest;
}

/// Waves of at most `highest` turns over the image.
Image waves(Size size, int highest) {
    const Random random(8);
    Image image(size, 2);
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                for (int k = 0; k <= highest; ++k)
                    image(x, y, c) += static_cast<float>(
                        random.uniform(k, c) *
                        std::cos(2 * std::numbers::pi *
                                 (static_cast<double>(k * x) / size.width +
                                  static_cast<double>((highest - k) * y) / size.height + 0.3 * c)));
    return image;
}

const auto kNoCheck = [] {};

TEST(Zoom, inAfterEverySecondPixelGivesBandLimitedImagesBack) {
    for (const Size size : {Size{48, 40}, Size{36, 60}}) {
        const Image image = waves(size, 8);
        const Image back = zoomedIn(everySecond(image), size, {true, true}, kNoCheck);
        EXPECT_LE(largestDifference(image, back), 2e-6);
    }
}

TEST(Zoom, keepsTheGivenPixels) {
    const Image image = blobs({31, 22}, 3);
    const Image soft = blurred(image, kZoomSigma, {}, kNoCheck);
    const Image wide = zoomedIn(soft, {62, 43}, {}, kNoCheck);
    EXPECT_EQ(wide.size(), (Size{62, 43}));
    EXPECT_LE(largestDifference(everySecond(wide), soft), 1e-4);
}

TEST(Zoom, smoothImagesDoNotRingAtBordersThatDoNotWrap) {
    Image ramp({40, 30}, 1);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            ramp(x, y, 0) = static_cast<float>(x);
    const Image wide = zoomedIn(ramp, {80, 60}, {}, kNoCheck);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 79; ++x)
            EXPECT_NEAR(wide(x, y, 0), 0.5 * x, 0.3) << x;
}

TEST(Zoom, blurKeepsTheMeanAndIsTheGaussian) {
    Image point({41, 41}, 1);
    point(20, 20, 0) = 1;
    const Image soft = blurred(point, 1.4, {true, true}, kNoCheck);
    EXPECT_NEAR(channelMeans(soft)[0] * 41 * 41, 1, 1e-5);
    EXPECT_NEAR(soft(21, 18, 0) / soft(20, 20, 0), std::exp(-5 / (2 * 1.4 * 1.4)), 1e-5);
    EXPECT_NEAR(channelMeans(blurred(blobs({30, 20}, 1), 2, {true, true}, kNoCheck))[0],
                channelMeans(blobs({30, 20}, 1))[0], 1e-6);
}

TEST(Zoom, oddWidthsThatWrapStillClose) {
    const Image image = waves({76, 40}, 5);
    const Image wide = zoomedIn(image, {151, 80}, {true, true}, kNoCheck);
    EXPECT_EQ(wide.size(), (Size{151, 80}));
    double seam = 0, inside = 0;
    for (int y = 0; y < 80; ++y) {
        seam += std::abs(static_cast<double>(wide(0, y, 0) - wide(150, y, 0)));
        inside += std::abs(static_cast<double>(wide(1, y, 0) - wide(0, y, 0)));
    }
    EXPECT_LT(seam, 2 * inside);
}

} // namespace
} // namespace texloom::test

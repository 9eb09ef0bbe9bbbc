#include "core/analysis/seam.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace texloom::test {

namespace {

constexpr int kSide = 64;

/// A wave with whole periods along x alone.
Image wave(double periods) {
    Image image({kSide, 10}, 2);
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < 10; ++y)
            for (int x = 0; x < kSide; ++x)
                image(x, y, c) = static_cast<float>(
                    std::sin(2 * std::numbers::pi * periods * (x + 0.5) / kSide + 1.0 * y + c));
    return image;
}

Image ramp() {
    Image image({kSide, 10}, 1);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < kSide; ++x)
            image(x, y, 0) = static_cast<float>(x);
    return image;
}

Image transposed(const Image& image) {
    Image turned({image.height(), image.width()}, image.channels());
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                turned(y, x, c) = image(x, y, c);
    return turned;
}

} // namespace

TEST(SeamScore, OfAPeriodicImageIsOne) {
    EXPECT_NEAR(seamScore(wave(3)).x, 1, 0.05);
    EXPECT_NEAR(seamScore(transposed(wave(3))).y, 1, 0.05);
}

TEST(SeamScore, OfARampIsItsLength) {
    EXPECT_NEAR(seamScore(ramp()).x, kSide - 1, 1e-9);
    EXPECT_NEAR(seamScore(transposed(ramp())).y, kSide - 1, 1e-9);
}

TEST(SeamScore, LooksAlongItsAxisOnly) {
    EXPECT_EQ(seamScore(ramp()).y, 1);
    EXPECT_EQ(seamScore(transposed(ramp())).x, 1);
}

TEST(SeamScore, OfAConstantIsOne) {
    EXPECT_EQ(seamScore(constant({9, 9}, 3, 0.5F)).x, 1);
}

TEST(SeamScore, OfAnImageOnePixelWideIsOne) {
    EXPECT_EQ(seamScore(noise({1, 9}, 1)).x, 1);
    EXPECT_EQ(seamScore(noise({9, 1}, 1)).y, 1);
}

TEST(SeamScore, RisesWhenThePeriodIsCutShort) {
    EXPECT_GT(seamScore(wave(3.5)).x, 3);
}

} // namespace texloom::test

#include "core/analysis/derived_maps.h"
#include "core/image/normal_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace texloom::test {

namespace {

/// Waves that wrap, 0 to 1.
Image hills(Size size) {
    Image height(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double across = 2 * std::numbers::pi * x / size.width,
                         down = 2 * std::numbers::pi * y / size.height;
            height(x, y, 0) = static_cast<float>(0.5 + 0.3 * std::sin(across) * std::cos(2 * down) +
                                                 0.2 * std::cos(2 * across));
        }
    return height;
}

void expectSame(const Image& one, const Image& other, double tolerance) {
    double worst = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            worst = std::max(worst, std::abs(static_cast<double>(one(x, y, 0)) - other(x, y, 0)));
    EXPECT_LE(worst, tolerance);
}

void stretched(Image& image) {
    const ValueRange range = valueRange(image);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image(x, y, 0) = (image(x, y, 0) - range.smallest) / (range.largest - range.smallest);
}

} // namespace

TEST(DerivedMaps, APlaneHasTheNormalOfItsSlopes) {
    Image plane(Size{9, 7}, 1);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x)
            plane(x, y, 0) = 0.03F * static_cast<float>(x) + 0.01F * static_cast<float>(y);
    const Image normals = normalsFromHeight(plane, 20);
    const double length = std::sqrt(0.6 * 0.6 + 0.2 * 0.2 + 1); // slopes 20 · 0.03 and 20 · 0.01
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(4, 3), std::pair(8, 6)}) {
        EXPECT_NEAR(2 * normals(x, y, 0) - 1, -0.6 / length, 1e-5);
        EXPECT_NEAR(2 * normals(x, y, 1) - 1, 0.2 / length, 1e-5); // rises downwards: faces up in the picture
        EXPECT_NEAR(2 * normals(x, y, 2) - 1, 1 / length, 1e-5);
    }
}

TEST(DerivedMaps, HeightsComeBackFromTheirNormals) {
    Image height = hills({96, 64});
    stretched(height);
    for (const bool wraps : {true, false}) {
        Image normals = normalsFromHeight(height, 10, {wraps, wraps});
        expectSame(heightFromNormals(normals, MapRole::NormalGl, wraps), height, 0.02);
        flipGreen(normals);
        expectSame(heightFromNormals(normals, MapRole::NormalDx, wraps), height, 0.02);
    }
    const Image flat(Size{8, 8}, 3);
    EXPECT_EQ(valueRange(heightFromNormals(normalsFromHeight(flat, 5), MapRole::NormalGl)).smallest, 0.5F);
}

TEST(DerivedMaps, reliefIsTheDepthThatNormalsWereMadeWith) {
    const Image height = hills({48, 40});
    const Wrap wrap{true, true};
    Image normals = normalsFromHeight(height, 5, wrap);
    const Relief relief = reliefOf(height, normals, MapRole::NormalGl, wrap);
    EXPECT_NEAR(relief.depth, 5, 1e-3);
    EXPECT_NEAR(relief.agreement, 1, 1e-5);
    // Green the other way round is another convention, and upside down if taken for the first.
    flipGreen(normals);
    EXPECT_NEAR(reliefOf(height, normals, MapRole::NormalDx, wrap).agreement, 1, 1e-5);
    EXPECT_LT(reliefOf(height, normals, MapRole::NormalGl, wrap).agreement, 0.9);
    // Of heights that have nothing to do with them.
    Image other(height.size(), 1);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 48; ++x)
            other(x, y, 0) = static_cast<float>(std::sin(2 * std::numbers::pi * 5 * y / 40));
    EXPECT_NEAR(reliefOf(other, normals, MapRole::NormalDx, wrap).agreement, 0, 1e-3);
    EXPECT_EQ(reliefOf(Image({8, 8}, 1), Image({8, 8}, 3), MapRole::NormalGl).agreement, 0);
}

TEST(DerivedMaps, GuessesGoTheRightWay) {
    Image pit(Size{64, 64}, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            pit(x, y, 0) = std::hypot(x - 32, y - 32) < 5 ? 0.2F : 0.8F;
    const Image open = occlusionGuess(pit);
    EXPECT_LT(open(32, 32, 0), 0.5F);
    EXPECT_NEAR(open(4, 4, 0), 1, 1e-3);
    Image colors(Size{2, 1}, 3);
    for (int c = 0; c < 3; ++c)
        colors(1, 0, c) = 1;
    const Image rough = roughnessGuess(colors);
    EXPECT_NEAR(rough(0, 0, 0), 0.9, 1e-6);
    EXPECT_NEAR(rough(1, 0, 0), 0.35, 1e-6);
}

} // namespace texloom::test

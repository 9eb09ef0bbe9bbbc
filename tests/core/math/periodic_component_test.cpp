#include "core/math/periodic_component.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace texloom::test {
namespace {

double at(const Image& image, int x, int y) {
    return static_cast<double>(
        image((x + image.width()) % image.width(), (y + image.height()) % image.height(), 0));
}

double periodicLaplacian(const Image& image, int x, int y) {
    return at(image, x - 1, y) + at(image, x + 1, y) + at(image, x, y - 1) + at(image, x, y + 1) -
           4 * at(image, x, y);
}

/// Second differences within the image alone: what Moisan's periodic component has as its Laplacian.
double innerLaplacian(const Image& image, int x, int y) {
    double sum = 0;
    for (const auto& [dx, dy] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
        if (x + dx >= 0 && x + dx < image.width() && y + dy >= 0 && y + dy < image.height())
            sum += at(image, x + dx, y + dy) - at(image, x, y);
    return sum;
}

TEST(PeriodicComponent, hasTheInnerLaplacianOfTheImageAndItsMean) {
    for (const Size size : {Size{16, 12}, Size{31, 17}, Size{1, 9}, Size{2, 2}}) {
        const Image image = noise(size, 1);
        const Image periodic = periodicComponent(image);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                EXPECT_NEAR(periodicLaplacian(periodic, x, y), innerLaplacian(image, x, y), 1e-5);
        EXPECT_NEAR(channelMeans(periodic).front(), channelMeans(image).front(), 1e-6);
    }
}

TEST(PeriodicComponent, leavesAPeriodicImageNearlyAsItIs) {
    Image wave({64, 48}, 1);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            wave(x, y, 0) = static_cast<float>(std::sin(2 * std::numbers::pi * (x / 64.0 + y / 24.0)));
    const Image periodic = periodicComponent(wave);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_NEAR(periodic(x, y, 0), wave(x, y, 0), 0.25);
}

TEST(PeriodicComponent, takesTheJumpOfARampAway) {
    Image ramp({40, 30}, 2);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            for (int c = 0; c < 2; ++c)
                ramp(x, y, c) = static_cast<float>(c == 0 ? x : y);
    const Image periodic = periodicComponent(ramp);
    for (int y = 0; y < 30; ++y)
        EXPECT_LT(std::abs(periodic(39, y, 0) - periodic(0, y, 0)), 1);
    for (int x = 0; x < 40; ++x)
        EXPECT_LT(std::abs(periodic(x, 29, 1) - periodic(x, 0, 1)), 1);
}

} // namespace
} // namespace texloom::test

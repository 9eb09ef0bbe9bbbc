#include "core/analysis/correlation.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

/// Eq. 3.10 to 3.12 word for word.
double bruteForce(const ImageView& f, const ImageView& g, int dx, int dy) {
    const int x0 = std::max(0, dx), x1 = std::min(f.width, dx + g.width);
    const int y0 = std::max(0, dy), y1 = std::min(f.height, dy + g.height);
    const double count = double(x1 - x0) * (y1 - y0);
    double above = 0, below = 0;
    for (int c = 0; c < f.channels; ++c) {
        double meanF = 0, meanG = 0;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                meanF += double(f(x, y, c)) / count;
                meanG += double(g(x - dx, y - dy, c)) / count;
            }
        double product = 0, ff = 0, gg = 0;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const double a = double(f(x, y, c)) - meanF, b = double(g(x - dx, y - dy, c)) - meanG;
                product += a * b;
                ff += a * a;
                gg += b * b;
            }
        above += product;
        below += std::sqrt(ff * gg);
    }
    return below > 0 ? above / below : 0;
}

void expectBruteForce(const ImageView& f, const ImageView& g) {
    const Correlation gamma = correlate(f, g);
    for (int dy = -gamma.top(); dy <= gamma.bottom(); ++dy)
        for (int dx = -gamma.left(); dx <= gamma.right(); ++dx)
            if (gamma.overlap(dx, dy).area() > 2) {
                EXPECT_NEAR(gamma.at(dx, dy), bruteForce(f, g, dx, dy), 2e-3) << dx << ", " << dy;
            }
}

TEST(Correlation, equalsTheDefinition) {
    const Image f = blobs({23, 17}, 3), g = blobs({11, 19}, 3, 5), small = noise({4, 3}, 3);
    expectBruteForce(f, g);
    expectBruteForce(g, small);
    expectBruteForce(f, f);
}

TEST(Correlation, ofAnImageWithItselfIsOneAtZeroAndSymmetric) {
    const Image image = blobs({40, 33}, 2);
    const Correlation gamma = autocorrelation(image), general = correlate(image, image);
    EXPECT_NEAR(gamma.at(0, 0), 1, 1e-5);
    for (int dy = -gamma.top(); dy <= gamma.bottom(); ++dy)
        for (int dx = -gamma.left(); dx <= gamma.right(); ++dx) {
            EXPECT_EQ(gamma.at(dx, dy), gamma.at(-dx, -dy));
            if (gamma.overlap(dx, dy).area() > 8) {
                EXPECT_NEAR(gamma.at(dx, dy), general.at(dx, dy), 2e-3);
            }
            EXPECT_LE(std::abs(gamma.at(dx, dy)), 1);
        }
}

TEST(Correlation, aChannelWithoutStructureCountsForNothing) {
    const Image one = blobs({30, 30}, 1);
    Image two({30, 30}, 2);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 30; ++x) {
            two(x, y, 0) = one(x, y, 0);
            two(x, y, 1) = 700;
        }
    const Correlation a = autocorrelation(one), b = autocorrelation(two);
    EXPECT_NEAR(a.at(7, 3), b.at(7, 3), 1e-4);
    EXPECT_NEAR(a.at(-12, 20), b.at(-12, 20), 1e-4);
}

TEST(Correlation, staysAsItIsWhenLightAndContrastChange) {
    const Image image = blobs({32, 32}, 3);
    Image bright(image);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                bright(x, y, c) = 1000 + 50 * image(x, y, c);
    const Correlation a = autocorrelation(image), b = correlate(image, bright);
    for (int dx = -20; dx <= 20; ++dx)
        EXPECT_NEAR(a.at(dx, 5), b.at(dx, 5), 2e-3);
}

TEST(Correlation, ofAConstantIsZero) {
    const Correlation gamma = autocorrelation(constant({9, 9}, 3, 0.3F));
    EXPECT_EQ(gamma.at(0, 0), 0);
    EXPECT_EQ(gamma.at(3, -4), 0);
}

TEST(Correlation, readsBetweenDisplacementsAndAsAPicture) {
    const Correlation gamma = autocorrelation(blobs({20, 16}, 1));
    EXPECT_NEAR(gamma.between(2.25, -3.5),
                0.375 * (gamma.at(2, -4) + gamma.at(2, -3)) + 0.125 * (gamma.at(3, -4) + gamma.at(3, -3)),
                1e-6);
    const Image picture = gamma.picture();
    EXPECT_EQ(picture.size(), (Size{39, 31}));
    EXPECT_EQ(picture(gamma.left() + 4, gamma.top() - 2, 0), gamma.at(4, -2));
}

} // namespace
} // namespace texloom::test

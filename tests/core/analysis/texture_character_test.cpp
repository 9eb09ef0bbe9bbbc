#include "core/analysis/texture_character.h"
#include "tests/support/lattices.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace texloom::test {
namespace {

/// A torus of Gaussian noise filtered along one axis with a Gaussian of standard deviation σ.
std::vector<double> smoothed(const std::vector<double>& from, Size size, double sigma, bool along) {
    const int radius = static_cast<int>(std::ceil(4 * sigma));
    std::vector<double> to(from.size());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int d = -radius; d <= radius; ++d) {
                const int fromX = along ? (x + d + size.width) % size.width : x;
                const int fromY = along ? y : (y + d + size.height) % size.height;
                to[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                   static_cast<std::size_t>(x)] +=
                    std::exp(-d * d / (2 * sigma * sigma)) *
                    from[static_cast<std::size_t>(fromY) * static_cast<std::size_t>(size.width) +
                         static_cast<std::size_t>(fromX)];
            }
    return to;
}

/// A Gaussian field whose autocorrelation is exp(−x² / 4σx² − y² / 4σy²).
Image gaussianField(Size size, double sigmaX, double sigmaY) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::vector<double> values(static_cast<std::size_t>(size.area()));
    for (double& value : values)
        value = normal(random);
    values = smoothed(smoothed(values, size, sigmaX, true), size, sigmaY, false);
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(x, y, 0) =
                static_cast<float>(values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                          static_cast<std::size_t>(x)]);
    return image;
}

Image stripes(Size size, int width) {
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(x, y, 0) = static_cast<float>(x / width % 2);
    return image;
}

/// Where a Gaussian autocorrelation falls to kAlike: 2σ √ln 5.
double reachOf(double sigma) {
    return 2 * sigma * std::sqrt(-std::log(TextureCharacter::kAlike));
}

TEST(TextureCharacter, aGaussianFieldDoesNotCluster) {
    for (const double sigma : {1.0, 2.0})
        EXPECT_NEAR(clustering(gaussianField({256, 256}, sigma, sigma)), 0, 0.02) << sigma;
    EXPECT_GT(characterOf(gaussianField({256, 256}, 1, 1)).grain, 0.8);
}

TEST(TextureCharacter, edgesCluster) {
    // Along a stripe's edge each difference across it is 1, and 0 elsewhere: a² and b² three pixels down the
    // edge are alike, and so are a and b; across stripes nothing is. Signs that change at random part the
    // two.
    Image walk(stripes({256, 256}, 16));
    std::mt19937_64 random(3);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            walk(x, y, 0) = random() % 2 == 0 ? walk(x, y, 0) : 0;
    EXPECT_GT(clustering(walk), 0.12);
    EXPECT_EQ(characterOf(walk).grain, 0);
    EXPECT_EQ(clustering(constant({64, 64}, 3, 0.3F)), 0);
    EXPECT_EQ(clustering(noise({6, 40}, 1)), 0) << "less than seven pixels a side tell nothing";
}

TEST(TextureCharacter, reachIsWhereTheAutocorrelationHasFallen) {
    const TextureCharacter round = characterOf(gaussianField({320, 320}, 4, 4));
    EXPECT_NEAR(round.shortest, reachOf(4), 0.2 * reachOf(4));
    EXPECT_NEAR(round.longest, reachOf(4), 0.2 * reachOf(4));
    const TextureCharacter drawnOut = characterOf(gaussianField({320, 320}, 8, 2));
    EXPECT_NEAR(drawnOut.shortest, reachOf(2), 0.2 * reachOf(2));
    EXPECT_NEAR(drawnOut.longest, reachOf(8), 0.25 * reachOf(8));
}

TEST(TextureCharacter, lengthsAreInPixelsOfTheExemplarThoughLessIsLookedAt) {
    const TextureCharacter large = characterOf(gaussianField({640, 640}, 8, 8));
    EXPECT_NEAR(large.longest, reachOf(8), 0.25 * reachOf(8));
    EXPECT_EQ(large.size, (Size{640, 640}));
}

TEST(TextureCharacter, findsWhatRepeats) {
    const Lattice lattice{{31, 0}, {0, 24}};
    const TextureCharacter regular = characterOf(regularTexture({200, 180}, 3, lattice, {}, 3));
    EXPECT_GT(regular.regularity, 0.5);
    EXPECT_FALSE(regular.rowsOnly);
    EXPECT_NEAR(regular.period, 24, 0.5);
    EXPECT_LT(characterOf(blobs({200, 180}, 3)).regularity, 0.5);
    const TextureCharacter rows = characterOf(coursesTexture({220, 220}, 3, {1, 0}, 20, {}, 1));
    EXPECT_TRUE(rows.rowsOnly);
    EXPECT_NEAR(rows.period, 20, 0.5);
}

TEST(TextureCharacter, takesTheSmallestPictures) {
    for (const Size size : {Size{8, 8}, Size{8, 40}, Size{1, 1}, Size{2, 300}}) {
        const TextureCharacter character = characterOf(noise(size, 3));
        EXPECT_TRUE(std::isfinite(character.grain) && std::isfinite(character.longest));
        EXPECT_GE(character.longest, character.shortest);
    }
}

} // namespace
} // namespace texloom::test

#include "core/math/histogram.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texloom::test {
namespace {

std::vector<float> sorted(const Image& image) {
    std::vector<float> values;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            values.push_back(image(x, y, 0));
    std::sort(values.begin(), values.end());
    return values;
}

Image signedNoise(Size size, std::uint64_t seed) {
    Image image = noise(size, 1, seed);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(x, y, 0) = 100 * (image(x, y, 0) - 0.5F) * image(x, y, 0);
    return image;
}

TEST(SampleRanks, orderAsTheValues) {
    for (const Size size : {Size{1, 1}, Size{2, 1}, Size{37, 53}, Size{700, 500}}) {
        const Image image = signedNoise(size, 1);
        SampleRanks ranks;
        ranks.sort(image.plane(0), [] {});
        const std::vector<float> expected = sorted(image);
        ASSERT_EQ(ranks.size(), expected.size());
        std::vector<bool> seen(expected.size(), false);
        for (std::size_t rank = 0; rank < expected.size(); ++rank) {
            const int index = static_cast<int>(ranks[rank]);
            ASSERT_EQ(image(index % size.width, index / size.width, 0), expected[rank]);
            ASSERT_FALSE(seen[static_cast<std::size_t>(index)]);
            seen[static_cast<std::size_t>(index)] = true;
        }
    }
}

TEST(Histogram, ofAsManySamplesIsTakenOnExactly) {
    const Image model = signedNoise({40, 30}, 1);
    Image image = noise({60, 20}, 1, 2);
    const Image before = image;
    SampleRanks ranks;
    Histogram(model.plane(0)).match(image.plane(0), ranks, [] {});
    EXPECT_EQ(sorted(image), sorted(model));
    for (int y = 1; y < 20; ++y)
        for (int x = 0; x < 60; ++x)
            if (before(x, y, 0) > before(x, y - 1, 0)) {
                EXPECT_GE(image(x, y, 0), image(x, y - 1, 0));
            }
}

TEST(Histogram, ofOtherNumbersOfSamplesIsTakenOnByQuantile) {
    const Image model = signedNoise({64, 64}, 1);
    for (const Size size : {Size{200, 150}, Size{31, 17}}) {
        Image image = noise(size, 1, 2);
        SampleRanks ranks;
        Histogram(model.plane(0)).match(image.plane(0), ranks, [] {});
        const std::vector<float> ours = sorted(image), theirs = sorted(model);
        for (const double quantile : {0.01, 0.2, 0.5, 0.77, 0.99}) {
            const auto at = [quantile](const std::vector<float>& values) {
                return values[static_cast<std::size_t>(quantile * static_cast<double>(values.size()))];
            };
            EXPECT_NEAR(at(ours), at(theirs), 0.3) << quantile;
        }
        EXPECT_GE(ours.front(), theirs.front());
        EXPECT_LE(ours.back(), theirs.back());
    }
}

TEST(Histogram, matchTellsTheChange) {
    const Image model = constant({8, 8}, 1, 5);
    Image image = constant({10, 10}, 1, 2);
    SampleRanks ranks;
    EXPECT_NEAR(Histogram(model.plane(0)).match(image.plane(0), ranks, [] {}), 9, 1e-9);
    EXPECT_NEAR(Histogram(model.plane(0)).match(image.plane(0), ranks, [] {}), 0, 1e-9);
}

TEST(Histogram, scattersEqualSamples) {
    Image flat = constant({64, 64}, 1, 1);
    SampleRanks ranks;
    Histogram(noise({64, 64}, 1).plane(0)).match(flat.plane(0), ranks, [] {});
    // Each quarter gets its share of low and high values: no ramp.
    for (const int top : {0, 32})
        for (const int left : {0, 32}) {
            const Image quarter(flat.view().crop(left, top, {32, 32}));
            EXPECT_NEAR(channelMeans(quarter).front(), 0.5, 0.02);
        }
}

} // namespace
} // namespace texloom::test

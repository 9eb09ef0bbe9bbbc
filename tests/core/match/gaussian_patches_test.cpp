#include "core/match/gaussian_patches.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace texloom::test {
namespace {

constexpr int kSide = 3, kValues = kSide * kSide * 2;

double valueOf(const ImageView& patch, int i) {
    return static_cast<double>(patch(i % kSide, i / kSide % kSide, i / (kSide * kSide)));
}

TEST(GaussianPatches, samplesHaveTheMeanAndCovarianceOfThePatches) {
    constexpr int kPatches = 5, kDraws = 60000;
    const Image source = noise({20, 20}, 2);
    std::vector<ImageView> patches;
    for (int i = 0; i < kPatches; ++i)
        patches.push_back(source.view().crop(3 * i, 2 * i, {kSide, kSide}));
    const Random random(3);
    Image sample({kSide, kSide}, 2);
    std::vector<double> sum(kValues, 0.0), products(kValues * kValues, 0.0);
    for (int draw = 0; draw < kDraws; ++draw) {
        const PatchCell cell{draw, 7, 0, 0, {}};
        combinePatches(patches, gaussianWeights(normalNumbers(random, cell, kPatches)), sample);
        for (int i = 0; i < kValues; ++i) {
            sum[static_cast<std::size_t>(i)] += valueOf(sample, i);
            for (int j = 0; j < kValues; ++j)
                products[static_cast<std::size_t>(i * kValues + j)] +=
                    valueOf(sample, i) * valueOf(sample, j);
        }
    }
    const auto mean = [&](int i) {
        double total = 0;
        for (const ImageView& patch : patches)
            total += valueOf(patch, i);
        return total / kPatches;
    };
    for (int i = 0; i < kValues; ++i) {
        const double found = sum[static_cast<std::size_t>(i)] / kDraws;
        EXPECT_NEAR(found, mean(i), 0.01);
        for (int j = 0; j < kValues; ++j) {
            double covariance = 0;
            for (const ImageView& patch : patches)
                covariance += (valueOf(patch, i) - mean(i)) * (valueOf(patch, j) - mean(j)) / (kPatches - 1);
            const double measured = products[static_cast<std::size_t>(i * kValues + j)] / kDraws -
                                    found * sum[static_cast<std::size_t>(j)] / kDraws;
            EXPECT_NEAR(measured, covariance, 0.006);
        }
    }
}

/// Lightness, and what each channel differs from it by.
std::vector<float> lightAndColors(const ImageView& patch, int x, int y) {
    std::vector<float> found(1, 0.0F);
    for (int c = 0; c < patch.channels; ++c)
        found[0] += patch(x, y, c) / static_cast<float>(patch.channels);
    for (int c = 0; c < patch.channels; ++c)
        found.push_back(patch(x, y, c) - found[0]);
    return found;
}

TEST(GaussianPatches, boundedPatchesShowNothingBeyondWhatTheOthersShow) {
    constexpr Size kCrop{8, 7};
    for (const int channels : {1, 3}) {
        const Image source = noise({40, 40}, channels);
        std::vector<ImageView> patches;
        for (int i = 0; i < 4; ++i)
            patches.push_back(source.view().crop(3 * i, 2 * i, kCrop));
        Image to(kCrop, channels);
        combinePatches(patches, std::vector<double>{1.5, -1.2, 0.9, -0.2}, to);
        const Image before = to;
        boundPatch(patches, to);
        const Image once = to;
        boundPatch(patches, to);
        int changed = 0;
        for (int y = 0; y < kCrop.height; ++y)
            for (int x = 0; x < kCrop.width; ++x) {
                const std::vector<float> was = lightAndColors(before, x, y), is = lightAndColors(once, x, y);
                bool inside = true;
                for (std::size_t k = 0; k < is.size(); ++k) {
                    float low = HUGE_VALF, high = -HUGE_VALF;
                    for (const ImageView& patch : patches) {
                        low = std::min(low, lightAndColors(patch, x, y)[k]);
                        high = std::max(high, lightAndColors(patch, x, y)[k]);
                    }
                    EXPECT_GE(is[k], low - 1e-5F);
                    EXPECT_LE(is[k], high + 1e-5F);
                    inside = inside && was[k] >= low && was[k] <= high;
                }
                changed += inside ? 0 : 1;
                for (int c = 0; c < channels; ++c) {
                    EXPECT_NEAR(to(x, y, c), once(x, y, c), 1e-5);
                    if (inside) {
                        EXPECT_NEAR(once(x, y, c), before(x, y, c), 1e-5);
                    }
                }
            }
        EXPECT_GT(changed, 10);
    }
}

TEST(GaussianPatches, equalPatchesAreTheirOwnBound) {
    const Image source = periodic({30, 30}, {5, 5}, 2);
    std::vector<ImageView> patches;
    for (int i = 0; i < 6; ++i)
        patches.push_back(source.view().crop(5 * (i % 4), 5 * (i / 4), {7, 7}));
    Image to(patches.front());
    boundPatch(patches, to);
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 7; ++x)
                EXPECT_NEAR(to(x, y, c), source(x, y, c), 1e-6); // fails for what is no number, too
}

TEST(GaussianPatches, boundedColoursKeepTheirHue) {
    // Grey patches and one red: a mirrored mean would be cyan, a doubled one redder than red.
    Image grey = constant({1, 1}, 3, 0.5F), red = grey, light = constant({1, 1}, 3, 0.6F);
    red(0, 0, 0) = 0.8F;
    const std::vector<ImageView> patches = {grey, red, light};
    Image cyan = grey;
    cyan(0, 0, 0) = 0.3F;
    boundPatch(patches, cyan);
    EXPECT_NEAR(cyan(0, 0, 0), cyan(0, 0, 1), 1e-6);
    EXPECT_NEAR(cyan(0, 0, 1), cyan(0, 0, 2), 1e-6);
    EXPECT_NEAR(cyan(0, 0, 0), 0.5, 1e-6); // as dark as the darkest
    Image redder = red;
    redder(0, 0, 0) = 1.1F;
    boundPatch(patches, redder);
    EXPECT_NEAR(redder(0, 0, 0), 0.8, 1e-6);
    EXPECT_NEAR(redder(0, 0, 2), 0.5, 1e-6);
}

TEST(GaussianPatches, weightsAddToOneAndOnePatchIsCopied) {
    const std::vector<double> weights = gaussianWeights(std::vector<double>{0.3, -2, 1.1});
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-12);
    EXPECT_EQ(gaussianWeights(std::vector<double>{1.7}), std::vector<double>{1.0});
}

TEST(GaussianPatches, normalNumbersAreNormal) {
    const Random random(5);
    double sum = 0, squares = 0, fourth = 0;
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
        const double value = random.normal(i / 100, 3, static_cast<std::uint32_t>(i % 100));
        sum += value;
        squares += value * value;
        fourth += value * value * value * value;
    }
    EXPECT_NEAR(sum / kCount, 0, 0.01);
    EXPECT_NEAR(squares / kCount, 1, 0.01);
    EXPECT_NEAR(fourth / kCount, 3, 0.08);
}

TEST(GaussianPatches, deviationIsTheMeanOverPixels) {
    const Image a = constant({2, 2}, 1, 1), b = constant({2, 2}, 1, 3);
    Image c = b;
    c(0, 0, 0) = 1;
    EXPECT_NEAR(meanPatchDeviation(std::vector<ImageView>{a, b}), std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(meanPatchDeviation(std::vector<ImageView>{a, c}), 0.75 * std::sqrt(2.0), 1e-12);
    EXPECT_EQ(meanPatchDeviation(std::vector<ImageView>{a}), 0);
}

} // namespace
} // namespace texloom::test

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

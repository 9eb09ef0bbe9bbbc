#include "core/analysis/histograms.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <numeric>

namespace texloom::test {

namespace {

template <class Make> auto inJob(Make make) {
    JobMonitor monitor;
    JobContext context(
        {1, 1, false}, [] { return false; }, monitor);
    return make(context);
}

std::vector<HistogramPair> colors(const Image& result, const Image& exemplar) {
    const ImageView view = exemplar;
    return inJob([&](JobContext& context) { return colorHistograms(result, {&view, 1}, 64, context); });
}

std::vector<HistogramPair> components(const Image& result, const Image& exemplar) {
    const ImageView view = exemplar;
    return inJob([&](JobContext& context) { return componentHistograms(result, {&view, 1}, 64, context); });
}

double sum(const std::vector<double>& shares) {
    return std::accumulate(shares.begin(), shares.end(), 0.0);
}

} // namespace

TEST(Histograms, countEveryPixelOnce) {
    Image exemplar({4, 2}, 1), result({2, 1}, 1);
    for (int i = 0; i < 8; ++i)
        exemplar(i % 4, i / 4, 0) = i < 2 ? 0.0F : 1.0F;
    result(0, 0, 0) = 2;
    const HistogramPair pair = colors(result, exemplar).front();
    EXPECT_EQ(pair.low, 0);
    EXPECT_EQ(pair.high, 2);
    EXPECT_DOUBLE_EQ(pair.exemplar[0], 0.25);
    EXPECT_DOUBLE_EQ(pair.exemplar[32], 0.75);
    EXPECT_DOUBLE_EQ(pair.result[0], 0.5);
    EXPECT_DOUBLE_EQ(pair.result[63], 0.5);
    EXPECT_DOUBLE_EQ(pair.distance(), 0.75);
}

TEST(Histograms, ofAnImageAndItselfAreTheSame) {
    const Image image = blobs({70, 60}, 3);
    for (const HistogramPair& pair : colors(image, image)) {
        EXPECT_EQ(pair.distance(), 0);
        EXPECT_NEAR(sum(pair.exemplar), 1, 1e-9);
    }
    ASSERT_EQ(components(image, image).size(), 2U);
    for (const HistogramPair& pair : components(image, image)) {
        EXPECT_LT(pair.distance(), 0.12); // other patches of it
        EXPECT_NEAR(sum(pair.result), 1, 1e-9);
    }
}

TEST(Histograms, ofPatchesTellTexturesApartThatColoursDoNot) {
    const Image image = noise({90, 80}, 1);
    Image sorted({90, 80}, 1);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 90; ++x)
            sorted(x, y, 0) = static_cast<float>((y * 90 + x + 0.5) / (90 * 80));
    EXPECT_LT(colors(sorted, image).front().distance(), 0.06);
    EXPECT_GT(components(image, sorted).front().distance(), 0.5);
    EXPECT_TRUE(components(Image({7, 20}, 1), image).empty());
}

TEST(Histograms, ofAConstantImageAreWhole) {
    const Image grey = constant({20, 20}, 1, 0.5F);
    EXPECT_DOUBLE_EQ(sum(colors(grey, grey).front().exemplar), 1);
    EXPECT_EQ(components(grey, grey).front().distance(), 0);
}

} // namespace texloom::test

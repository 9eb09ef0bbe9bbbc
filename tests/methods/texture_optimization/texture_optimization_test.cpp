#include "core/analysis/map_usage.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::texture_optimization_tests {

namespace {

Synthesis made(const Request& request, const Values& settings) {
    return resultOf(findMethod("texture-optimization"), request, settings);
}

const Values kOnePass = {{"scales", 1}, {"largest-patch", 8}, {"iterations", 12}};

} // namespace

TEST(TextureOptimization, energyNeverRisesWithExactSteps) {
    const Request request = requestOf(blobs({48, 48}, 3), {64, 64});
    const Synthesis result = made(request, with(kOnePass, {{"aggregation", std::string("mean")}}));
    const std::vector<double>& energy = result.curves.front().values;
    ASSERT_GE(energy.size(), 3U);
    for (std::size_t i = 1; i < energy.size(); ++i)
        EXPECT_LE(energy[i], energy[i - 1] * (1 + 1e-6)) << "iteration " << i;
    EXPECT_LT(energy.back(), energy.front());
}

TEST(TextureOptimization, patchMatchComesNearTheExactEnergy) {
    const Request request = requestOf(blobs({64, 64}, 3), {96, 96});
    const double exact = made(request, kOnePass).curves.front().values.front();
    const double near =
        made(request, with(kOnePass, {{"search", std::string("patchmatch")}})).curves.front().values.front();
    EXPECT_LT(near, 1.1 * exact);
}

TEST(TextureOptimization, everySwitchChangesTheResultAndKeepsItSound) {
    const Request request = requestOf(blobs({48, 48}, 3), {70, 60});
    const Image plain = made(request, {}).image;
    const ValueRange range = valueRange(*request.exemplars.front().image);
    const std::vector<Values> switches = {{{"aggregation", std::string("mean")}},
                                          {{"aggregation", std::string("robust")}},
                                          {{"aggregation", std::string("median")}},
                                          {{"histogram", true}},
                                          {{"bidirectional", true}},
                                          {{"uniformity", 1.0}},
                                          {{"search", std::string("patchmatch")}},
                                          {{"finish", std::string("copy")}}};
    for (const Values& settings : switches) {
        const Image image = made(request, settings).image;
        EXPECT_FALSE(samePixels(image, plain)) << settings.begin()->first;
        EXPECT_GE(valueRange(image).smallest, range.smallest - 1e-4F);
        EXPECT_LE(valueRange(image).largest, range.largest + 1e-4F);
    }
}

TEST(TextureOptimization, copyHasAnExactMap) {
    const Request request = requestOf(blobs({48, 48}, 3), {70, 60});
    const Synthesis result = made(request, {{"finish", std::string("copy")}});
    EXPECT_EQ(result.mapKind, MapKind::Exact);
    EXPECT_TRUE(samePixels(result.map.apply(request.exemplars.front().image->view()), result.image));
}

TEST(TextureOptimization, uniformityKeepsItsWordOverItsWholeRange) {
    const Request request = requestOf(blobs({64, 64}, 3), {96, 96});
    const auto variance = [](const Image& image) {
        double square = 0;
        const double mean = channelMeans(image)[0];
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                square += std::pow(static_cast<double>(image(x, y, 0)) - mean, 2);
        return square / static_cast<double>(image.size().area());
    };
    const double wanted = variance(*request.exemplars.front().image);
    double before = 0;
    for (const double uniformity : {0.0, 0.1, 1.0, 10.0}) {
        const Synthesis result = made(request, {{"uniformity", uniformity}});
        const double entropy = occurrenceEntropy(occurrencesOf(result.map));
        EXPECT_GT(entropy, before - 0.01) << uniformity;
        before = entropy;
        if (uniformity > 0) {
            EXPECT_NEAR(variance(result.image), wanted, 0.5 * wanted) << uniformity;
        }
    }
}

TEST(TextureOptimization, uniformityAndBothDirectionsUseMoreOfTheExemplar) {
    const Request request = requestOf(blobs({64, 64}, 3), {128, 128});
    const auto entropy = [&](const Values& settings) {
        return occurrenceEntropy(occurrencesOf(made(request, settings).map));
    };
    const double plain = entropy({});
    EXPECT_GT(entropy({{"uniformity", 1.0}}), plain);
    EXPECT_GT(entropy({{"bidirectional", true}}), plain);
}

} // namespace texloom::test::texture_optimization_tests

#include "core/job/job.h"
#include "core/math/waves.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace texloom::test::fourier_mask_tests {
namespace {

struct Cosine {
    double x, y; ///< cycles per pixel
    double strength, phase;
};

/// The source's own example has 7.2 cycles a side.
const std::vector<Cosine> kThree{
    {7.2 / 96, 0.4 / 96, 0.3, 0.4}, {2.7 / 96, -5.3 / 96, 0.2, 1.9}, {11.15 / 96, 9.62 / 96, 0.15, -2.2}};

Image sumOf(const std::vector<Cosine>& cosines, Size size) {
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            double value = 0.5;
            for (const Cosine& one : cosines)
                value += one.strength * std::cos(2 * std::numbers::pi * (one.x * x + one.y * y) + one.phase);
            image(x, y, 0) = static_cast<float>(value);
        }
    return image;
}

Image drawnWhole(const WaveModel& model, Size size) {
    Job<Image> job({0, 2, false}, [&](JobContext& context) { return drawn(model, {0, 0, size}, context); });
    return std::get<Image>(job.take());
}

double deviation(const Image& a, const Image& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            sum += std::pow(static_cast<double>(a(x, y, 0) - b(x, y, 0)), 2);
    return std::sqrt(sum / static_cast<double>(a.size().area()));
}

TEST(Waves, offTheGridAreFoundAndContinued) {
    const WaveModel model = findWaves(sumOf(kThree, {96, 96}), {}, {0.2, 24}, [] {});
    ASSERT_EQ(model.waves.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const Wave& wave = model.waves[i];
        const double sign = wave.x * kThree[i].x < 0 ? -1 : 1;
        EXPECT_NEAR(sign * wave.x * 96, kThree[i].x * 96, 1e-3);
        EXPECT_NEAR(sign * wave.y * 96, kThree[i].y * 96, 1e-3);
        EXPECT_NEAR(std::abs(wave.strengths.front()), kThree[i].strength, 1e-3);
    }
    EXPECT_GT(model.share, 0.9995);
    const Image wanted = sumOf(kThree, {384, 384});
    const Image flat = constant({384, 384}, 1, 0.5F);
    EXPECT_LT(deviation(drawnWhole(model, {384, 384}), wanted), 1e-2 * deviation(wanted, flat));
}

TEST(Waves, areFoundInNoiseAndUnderAMask) {
    Image image = sumOf(kThree, {96, 96});
    const Image grain = noise({96, 96}, 1);
    Image mask = constant({96, 96}, 1, 1);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            image(x, y, 0) += 0.3F * (grain(x, y, 0) - 0.5F);
            if (x > 60 && y > 70) {
                mask(x, y, 0) = 0;
                image(x, y, 0) = 9;
            }
        }
    const WaveModel model = findWaves(image, mask.plane(0), {0.3, 24}, [] {});
    ASSERT_EQ(model.waves.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const double sign = model.waves[i].x * kThree[i].x < 0 ? -1 : 1;
        EXPECT_NEAR(sign * model.waves[i].x * 96, kThree[i].x * 96, 0.03);
        // The error is of the size that the model says.
        EXPECT_LT(std::abs(sign * model.waves[i].x - kThree[i].x), 5 * model.waves[i].uncertainty + 1e-9);
        EXPECT_LT(model.waves[i].uncertainty * 96, 0.02);
    }
}

TEST(Waves, thresholdAndNumberLimitThem) {
    const Image image = sumOf(kThree, {96, 96});
    EXPECT_EQ(findWaves(image, {}, {0.9, 24}, [] {}).waves.size(), 1U);
    EXPECT_EQ(findWaves(image, {}, {0.6, 24}, [] {}).waves.size(), 2U);
    EXPECT_EQ(findWaves(image, {}, {0.01, 2}, [] {}).waves.size(), 2U);
    EXPECT_TRUE(findWaves(constant({40, 30}, 2, 0.3F), {}, {}, [] {}).waves.empty());
}

TEST(Waves, closeOnWholeNumbersOfCycles) {
    const WaveModel model = findWaves(sumOf(kThree, {96, 96}), {}, {0.2, 24}, [] {});
    double move = 0;
    const WaveModel moved = closed(model, {200, 150}, {true, false}, move);
    EXPECT_GT(move, 0.01);
    EXPECT_LE(move, 0.5);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(moved.waves[i].x * 200, std::round(moved.waves[i].x * 200), 1e-9);
        EXPECT_EQ(moved.waves[i].y, model.waves[i].y);
    }
    const Image image = drawnWhole(moved, {400, 20});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 200; ++x)
            ASSERT_NEAR(image(x, y, 0), image(x + 200, y, 0), 1e-4);
}

Synthesis made(const Request& request, const Values& settings = {}) {
    return resultOf(findMethod("fourier-mask"), request, settings);
}

TEST(FourierMask, patchesFollowTheWaves) {
    Image exemplar = sumOf({{6.3 / 96, 0, 0.25, 0.3}, {0.2 / 96, 7.8 / 96, 0.2, 1}}, {96, 96});
    const Image grain = noise({96, 96}, 1);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x)
            exemplar(x, y, 0) += 0.5F * (grain(x, y, 0) - 0.5F);
    const Request request = requestOf(exemplar, {300, 260});
    const Values settings{{"patch", 12}, {"tolerance", 0.1}, {"threshold", 0.4}};
    Values loose = settings;
    loose["weight"] = 0.0;
    const Synthesis guided = made(request, settings), unguided = made(request, loose);
    const auto part = [](const Synthesis& result) {
        return findWaves(result.image, {}, {0.4, 8}, [] {}).share;
    };
    EXPECT_GT(part(guided), 1.2 * part(unguided));
    ASSERT_NE(guided.outputs.image("regular-part"), nullptr);
    EXPECT_EQ(guided.outputs.image("regular-part")->size(), request.size);
    EXPECT_EQ(guided.figures.front().value, 2);
    EXPECT_LT(guided.figures[2].value, 0.2);
    EXPECT_TRUE(guided.notes.empty());
    // What there is to see follows the picture of the regular part.
    double together = 0;
    const Image& regular = *guided.outputs.image("regular-part");
    const double meanA = channelMeans(regular).front(), meanB = channelMeans(guided.image).front();
    for (int y = 0; y < 260; ++y)
        for (int x = 0; x < 300; ++x)
            together += (static_cast<double>(regular(x, y, 0)) - meanA) *
                        (static_cast<double>(guided.image(x, y, 0)) - meanB);
    EXPECT_GT(together / (300 * 260), 0.03); // of 0.051 where they agree
}

TEST(FourierMask, noiseHasHardlyARegularPart) {
    EXPECT_EQ(made(requestOf(noise({96, 96}, 1), {100, 100}, {}, 0), {{"threshold", 0.9}}).notes.size(), 1U);
}

} // namespace
} // namespace texloom::test::fourier_mask_tests

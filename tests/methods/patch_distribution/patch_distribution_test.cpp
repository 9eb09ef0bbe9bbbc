#include "core/job/job.h"
#include "core/match/patch_projection.h"
#include "core/methods/method.h"
#include "core/methods/patch_distribution/matcher.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::patch_distribution_tests {
namespace {

using patch_distribution::Matcher;
using patch_distribution::Settings;

Synthesis made(const Request& request, const Values& settings = {}) {
    return resultOf(findMethod("patch-distribution"), request, settings);
}

/// The value of an image's pixel, round the borders that wrap.
double at(const Image& image, int x, int y, int c) {
    return static_cast<double>(image(x % image.width(), y % image.height(), c));
}

TEST(PatchProjection, isTheScalarProductOfEveryPatch) {
    const Image image = noise({11, 9}, 2);
    const Image direction = noise({3, 3}, 2, 7);
    std::vector<float> numbers;
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 3; ++x)
                numbers.push_back(direction(x, y, c));
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{true, true}}) {
        const PatchProjection projection(image.size(), wrap, 3);
        EXPECT_EQ(projection.positions(), (Size{wrap.x ? 11 : 9, wrap.y ? 9 : 7}));
        Image padded(projection.padded(), 2);
        for (int c = 0; c < 2; ++c)
            for (int y = 0; y < 9; ++y)
                std::copy_n(image.plane(c).row(y), 11, padded.plane(c).row(y));
        projection.pad(padded);
        std::vector<float> row(static_cast<std::size_t>(projection.positions().width));
        for (int y = 0; y < projection.positions().height; ++y) {
            projection.projectRow(padded, numbers, y, row.data());
            for (int x = 0; x < projection.positions().width; ++x) {
                double sum = 0;
                for (int c = 0; c < 2; ++c)
                    for (int dy = 0; dy < 3; ++dy)
                        for (int dx = 0; dx < 3; ++dx)
                            sum += at(image, x + dx, y + dy, c) * at(direction, dx, dy, c);
                ASSERT_NEAR(row[static_cast<std::size_t>(x)], sum, 1e-5);
            }
        }
    }
}

TEST(PatchProjection, wayBackIsTheTransposed) {
    // ⟨A u, v⟩ = ⟨u, Aᵗ v⟩ for the products A u of all patches with two directions.
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}}) {
        const Image image = noise({10, 8}, 2), weights = noise({4, 4}, 4, 9);
        std::vector<float> directions;
        for (int c = 0; c < 4; ++c)
            for (int y = 0; y < 4; ++y)
                for (int x = 0; x < 4; ++x)
                    directions.push_back(weights(x, y, c));
        const PatchProjection projection(image.size(), wrap, 4);
        const Image numbers = noise(projection.positions(), 2, 5);
        Image padded(projection.padded(), 2);
        for (int c = 0; c < 2; ++c)
            for (int y = 0; y < 8; ++y)
                std::copy_n(image.plane(c).row(y), 10, padded.plane(c).row(y));
        projection.pad(padded);
        double left = 0, right = 0;
        int covering = 0;
        std::vector<float> row(static_cast<std::size_t>(projection.positions().width));
        for (int k = 0; k < 2; ++k)
            for (int y = 0; y < projection.positions().height; ++y) {
                projection.projectRow(
                    padded, std::span<const float>(directions).subspan(static_cast<std::size_t>(k) * 32, 32),
                    y, row.data());
                for (int x = 0; x < projection.positions().width; ++x)
                    left += static_cast<double>(row[static_cast<std::size_t>(x)]) * at(numbers, x, y, k);
            }
        for (int y = 0; y < 8; ++y) {
            for (int c = 0; c < 2; ++c) {
                std::vector<float> back(10, 0.0F);
                projection.spreadRow(numbers, directions, c, 2, y, back.data());
                for (int x = 0; x < 10; ++x)
                    right += at(image, x, y, c) * static_cast<double>(back[static_cast<std::size_t>(x)]);
            }
            for (int x = 0; x < 10; ++x)
                covering += projection.covering(x, y);
        }
        EXPECT_NEAR(left, right, 1e-3);
        EXPECT_EQ(covering, 16 * projection.positions().area());
    }
}

TEST(PatchDistribution, exemplarItselfStays) {
    const Image exemplar = blobs({40, 36}, 2);
    Settings settings;
    settings.directions = 8;
    const std::vector<PatchSource> sources{{exemplar.view(), {}, 1}};
    Image image(exemplar);
    Job<double> job({0, 2, false}, [&](JobContext& context) {
        Matcher matcher(sources, image.size(), {}, settings, {0.1, 0.1}, context);
        double most = 0;
        for (int n = 0; n < 5; ++n)
            most = std::max(most, matcher.step(image, n, 1));
        return most;
    });
    EXPECT_LT(std::get<double>(job.take()), 1e-9);
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 40; ++x)
            ASSERT_NEAR(image(x, y, 1), exemplar(x, y, 1), 1e-4);
}

TEST(PatchDistribution, distanceFalls) {
    const Synthesis result = made(requestOf(blobs({64, 64}, 3), {64, 64}), {{"scales", 1}});
    ASSERT_EQ(result.curves.size(), 1U);
    const std::vector<double>& distance = result.curves.front().values;
    ASSERT_EQ(distance.size(), 60U);
    EXPECT_LT(distance.back(), 0.1 * distance.front());
}

TEST(PatchDistribution, coloursAreTheExemplars) {
    Image exemplar({64, 64}, 1);
    // Stripes of two values: most pixels of the result must be near one of them.
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            exemplar(x, y, 0) = x / 8 % 2 == 0 ? 0.2F : 0.8F;
    const Image image = made(requestOf(exemplar, {96, 80}, {true, true})).image;
    int near = 0;
    double mean = 0;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 96; ++x) {
            near += std::min(std::abs(image(x, y, 0) - 0.2F), std::abs(image(x, y, 0) - 0.8F)) < 0.1F;
            mean += static_cast<double>(image(x, y, 0)) / (96 * 80);
        }
    EXPECT_GT(near, 96 * 80 * 3 / 4);
    EXPECT_NEAR(mean, 0.5, 0.03);
}

TEST(PatchDistribution, fineGrainIsNotLeftAtTheBlurOfCoarseScales) {
    // Of neighbouring pixels of white noise one says nothing of the other; enlarged ones are much alike.
    const Image image = made(requestOf(noise({96, 96}, 1), {96, 96}, {true, true})).image;
    const double mean = channelMeans(image).front();
    double product = 0, square = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            product += (at(image, x, y, 0) - mean) * (at(image, x + 1, y, 0) - mean);
            square += (at(image, x, y, 0) - mean) * (at(image, x, y, 0) - mean);
        }
    EXPECT_NEAR(square / (96 * 96), 1.0 / 12, 0.01); // noise() is uniform from 0 to 1
    EXPECT_LT(product / square, 0.2);
}

TEST(PatchDistribution, exemplarsAreMixedByWeight) {
    Request request = requestOf(constant({40, 40}, 1, 0.2F), {60, 60});
    Image noisy = blobs({40, 40}, 1);
    request.exemplars.front().image = std::make_shared<const Image>(noisy);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            noisy(x, y, 0) += 3;
    request.exemplars.push_back({"bright", std::make_shared<const Image>(noisy)});
    const auto mean = [&](double first, double second) {
        request.exemplars.front().weight = first;
        request.exemplars.back().weight = second;
        return channelMeans(made(request).image).front();
    };
    const double dark = channelMeans(*request.exemplars.front().image).front();
    EXPECT_NEAR(mean(1, 1) - dark, 1.5, 0.2);
    EXPECT_NEAR(mean(1, 4) - dark, 2.4, 0.2);
}

TEST(PatchDistribution, startsFromAnImage) {
    const Image exemplar = blobs({64, 64}, 3);
    Request request = requestOf(exemplar, {64, 64});
    request.inputs.set(kInitialPort, std::make_shared<const Image>(exemplar));
    const Image image = made(request, {{"scales", 1}}).image;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            ASSERT_NEAR(image(x, y, 0), exemplar(x, y, 0), 1e-3);
}

} // namespace
} // namespace texloom::test::patch_distribution_tests

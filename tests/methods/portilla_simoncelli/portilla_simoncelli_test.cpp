#include "core/base/error.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/methods/portilla_simoncelli/correlations.h"
#include "core/methods/portilla_simoncelli/marginals.h"
#include "core/methods/portilla_simoncelli/synthesizer.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace texloom::test::portilla_simoncelli_tests {
namespace {

using namespace portilla_simoncelli;

void uninterrupted() {}

Request requestFor(Image exemplar, Size output, Wrap wrap = {}) {
    return requestOf(std::move(exemplar), output, wrap, 4);
}

Synthesis run(const Request& request, const Settings& settings, int threads = 2) {
    Job<Synthesis> job({request.seed, threads, false}, [&](JobContext& context) {
        Synthesis made = Synthesizer(request, settings, context).run();
        made.curves = context.curves();
        return made;
    });
    return std::get<Synthesis>(job.take());
}

Settings brief(int iterations) {
    Settings settings;
    settings.iterations = iterations;
    return settings;
}

double figure(const Synthesis& synthesis, const std::string& name) {
    for (const Figure& figure : synthesis.figures)
        if (figure.name.text() == name)
            return figure.value;
    ADD_FAILURE() << "no figure " << name;
    return 0;
}

double deviation(const Synthesis& synthesis, Group group) {
    return figure(synthesis, "Deviation, " + titleOf(group).text());
}

/// Overlapping discs of random size and colour, which wrap: many small edges, as in gravel.
Image gravel(Size size, int channels, std::uint64_t seed) {
    const Random random(seed);
    Image image = constant(size, channels, 0.5F);
    const auto count = static_cast<int>(size.area() / 12);
    for (int disc = 0; disc < count; ++disc) {
        const double radius = 1.5 + 5 * random.uniform(disc, 0);
        const int left = static_cast<int>(random.below(static_cast<std::uint32_t>(size.width), disc, 1));
        const int top = static_cast<int>(random.below(static_cast<std::uint32_t>(size.height), disc, 2));
        const auto reach = static_cast<int>(radius) + 1;
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                const auto cover =
                    static_cast<float>(std::clamp(radius + 0.5 - std::hypot(dx, dy), 0.0, 1.0));
                for (int c = 0; c < channels; ++c) {
                    const auto shade =
                        static_cast<float>(0.7 * random.uniform(disc, 3) + 0.3 * random.uniform(disc, 4 + c));
                    float& pixel = image((left + dx + size.width) % size.width,
                                         (top + dy + size.height) % size.height, c);
                    pixel += cover * (shade - pixel);
                }
            }
    }
    return image;
}

Eigen::MatrixXd covarianceOf(int size, std::uint64_t seed) {
    const Random random(seed);
    Eigen::MatrixXd factor(size, size + 3);
    for (Eigen::Index i = 0; i < factor.size(); ++i)
        factor(i) = random.normal(static_cast<int>(i), 0);
    return factor * factor.transpose() / size;
}

TEST(LeastMap, givesTheWantedCovarianceAndIsSymmetric) {
    const Eigen::MatrixXd current = covarianceOf(5, 1), wanted = covarianceOf(5, 2);
    const Eigen::MatrixXd map = leastMap(current, wanted);
    EXPECT_LT((map * current * map.transpose() - wanted).norm(), 1e-9 * wanted.norm());
    EXPECT_LT((map - map.transpose()).norm(), 1e-9);
    EXPECT_LT((leastMap(current, current) - Eigen::MatrixXd::Identity(5, 5)).norm(), 1e-9);
}

TEST(MixingTo, givesBothWantedCovariances) {
    const Eigen::MatrixXd now = covarianceOf(7, 3), then = covarianceOf(7, 4);
    // The fixed variables keep their own covariance.
    const Eigen::MatrixXd yy = now.bottomRightCorner(3, 3);
    const Eigen::MatrixXd keep = leastMap(then.bottomRightCorner(3, 3), yy);
    const Eigen::MatrixXd wantedXx = then.topLeftCorner(4, 4), wantedXy = then.topRightCorner(4, 3) * keep;
    const Eigen::MatrixXd xx = now.topLeftCorner(4, 4), xy = now.topRightCorner(4, 3);
    const Mixing mixing = mixingTo(xx, xy, yy, wantedXx, wantedXy);
    const Eigen::MatrixXd &a = mixing.own, &b = mixing.other;
    EXPECT_LT((a * xy + b * yy - wantedXy).norm(), 1e-8);
    EXPECT_LT((a * xx * a.transpose() + a * xy * b.transpose() + b * xy.transpose() * a.transpose() +
               b * yy * b.transpose() - wantedXx)
                  .norm(),
              1e-8);
}

TEST(Autocorrelator, measuresLagsAsTheDefinitionDoes) {
    for (const Size size : {Size{32, 24}, Size{33, 27}}) {
        const SteerablePyramid pyramid(size, 1, 1);
        const Image image = noise(size, 1);
        const FftBuffer<std::complex<float>> spectrum = pyramid.spectrum(0);
        pyramid.forward(0, image.plane(0).data, spectrum.data(), uninterrupted);
        const Eigen::MatrixXd lags = Autocorrelator(pyramid, 0, 2).measure(spectrum.data(), uninterrupted);
        for (int dy = 0; dy <= 4; ++dy)
            for (int dx = -4; dx <= 4; ++dx) {
                double sum = 0;
                for (int y = 0; y < size.height; ++y)
                    for (int x = 0; x < size.width; ++x)
                        sum += static_cast<double>(image(x, y, 0)) *
                               static_cast<double>(
                                   image((x + dx + size.width) % size.width, (y + dy) % size.height, 0));
                EXPECT_NEAR(lags(dy, 4 + dx), sum / static_cast<double>(size.area()), 1e-5)
                    << dx << ' ' << dy;
            }
    }
}

TEST(Autocorrelator, imposesTheAutocorrelationOfANearImage) {
    const Size size{64, 64};
    const SteerablePyramid pyramid(size, 1, 1);
    const Autocorrelator autocorrelator(pyramid, 0, 3);
    // Two draws of the same filtered noise; a lag of 2 × reach does not wrap.
    const auto drawn = [&](std::uint64_t seed, float weight) {
        const Image grain = noise(size, 1, seed);
        Image image(size, 1);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                image(x, y, 0) =
                    grain(x, y, 0) + weight * grain((x + 1) % 64, y, 0) + 0.3F * grain(x, (y + 2) % 64, 0);
        FftBuffer<std::complex<float>> spectrum = pyramid.spectrum(0);
        pyramid.forward(0, image.plane(0).data, spectrum.data(), uninterrupted);
        spectrum.data()[0] = 0;
        return spectrum;
    };
    const auto wanted = drawn(1, 0.6F), changed = drawn(2, 0.5F);
    const Eigen::MatrixXd aim =
        Autocorrelator::central(autocorrelator.measure(wanted.data(), uninterrupted), 3);
    autocorrelator.impose(autocorrelator.measure(changed.data(), uninterrupted), aim, changed.data(),
                          uninterrupted);
    const Eigen::MatrixXd got =
        Autocorrelator::central(autocorrelator.measure(changed.data(), uninterrupted), 3);
    EXPECT_LT((got - aim).norm() / aim.norm(), 1e-3);
}

TEST(ImposeMoments, givesTheWantedMomentsAndRange) {
    Image image = noise({80, 70}, 1);
    const Moments before = momentsOf(image.plane(0), uninterrupted);
    EXPECT_NEAR(before.kurtosis, 1.8, 0.05);
    Moments wanted;
    wanted.mean = 30;
    wanted.variance = 4;
    wanted.skewness = 0.4;
    wanted.kurtosis = 2.3;
    wanted.smallest = -std::numeric_limits<double>::infinity();
    wanted.largest = std::numeric_limits<double>::infinity();
    imposeMoments(image.plane(0), before, wanted, uninterrupted);
    const Moments after = momentsOf(image.plane(0), uninterrupted);
    EXPECT_NEAR(after.mean, 30, 1e-4);
    EXPECT_NEAR(after.variance, 4, 1e-4);
    EXPECT_NEAR(after.skewness, 0.4, 0.15); // moved a little by the kurtosis
    EXPECT_NEAR(after.kurtosis, 2.3, 1e-3);
    wanted.smallest = 28;
    wanted.largest = 32;
    imposeMoments(image.plane(0), after, wanted, uninterrupted);
    EXPECT_GE(momentsOf(image.plane(0), uninterrupted).smallest, 28);
    EXPECT_LE(momentsOf(image.plane(0), uninterrupted).largest, 32);
}

TEST(PortillaSimoncelli, itsOwnStatisticsLeaveAnImageAsItIs) {
    const Image exemplar = blobs({64, 64}, 3);
    Request request = requestFor(exemplar, {64, 64}, {true, true});
    request.inputs.set(kInitialPort, std::make_shared<const Image>(exemplar));
    Settings settings = brief(2);
    settings.periodic = false;
    const Synthesis result = run(request, settings);
    double worst = 0;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                worst =
                    std::max(worst, std::abs(static_cast<double>(result.image(x, y, c) - exemplar(x, y, c))));
    EXPECT_LT(worst, 5e-3);
    for (std::size_t group = 0; group < kGroups; ++group)
        EXPECT_LT(deviation(result, static_cast<Group>(group)), 2e-3)
            << titleOf(static_cast<Group>(group)).text();
}

TEST(PortillaSimoncelli, statisticsComeWithinTwoPerCent) {
    for (const int channels : {1, 3})
        for (const std::uint64_t seed : {5, 8}) {
            const Synthesis result =
                run(requestFor(gravel({128, 128}, channels, seed), {256, 256}), brief(50));
            for (std::size_t group = 0; group < kGroups; ++group)
                EXPECT_LT(deviation(result, static_cast<Group>(group)), 0.02)
                    << titleOf(static_cast<Group>(group)).text() << ", channels " << channels << ", seed "
                    << seed;
        }
}

TEST(PortillaSimoncelli, aGroupLeftOutStaysFartherOff) {
    const Image exemplar = gravel({96, 96}, 1, 2);
    const Synthesis all = run(requestFor(exemplar, {96, 96}), brief(15));
    const auto expectFarther = [&](bool Settings::*toggle, Group group) {
        Settings settings = brief(15);
        settings.*toggle = false;
        const Synthesis without = run(requestFor(exemplar, {96, 96}), settings);
        EXPECT_GT(deviation(without, group), 1.5 * deviation(all, group)) << titleOf(group).text();
    };
    expectFarther(&Settings::marginals, Group::Marginals);
    expectFarther(&Settings::magnitudeAutocorrelation, Group::MagnitudeAutocorrelation);
    expectFarther(&Settings::magnitudeOrientations, Group::MagnitudeOrientations);
    expectFarther(&Settings::magnitudeScales, Group::MagnitudeScales);
    expectFarther(&Settings::phases, Group::Phases);
}

TEST(PortillaSimoncelli, everyGroupHasACurveOfAllIterationsThatFalls) {
    const Synthesis result = run(requestFor(gravel({64, 64}, 1, 2), {64, 64}), brief(12));
    ASSERT_EQ(result.curves.size(), kGroups);
    for (const Curve& curve : result.curves) {
        ASSERT_EQ(curve.values.size(), 12U) << curve.name.text();
        EXPECT_LT(curve.values.back(), 0.5 * curve.values.front()) << curve.name.text();
    }
}

TEST(PortillaSimoncelli, goesBetweenTwoExemplars) {
    // A pale, soft texture and a dark, grainy one: the mean goes along, and at the ends there is one alone.
    Image pale = blobs({64, 64}, 1), dark = noise({48, 80}, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            pale(x, y, 0) += 2;
    Request request = requestFor(pale, {64, 64});
    request.exemplars.push_back({"dark", std::make_shared<const Image>(dark)});
    const double first = channelMeans(pale).front(), second = channelMeans(dark).front();
    for (const double weight : {0.0, 0.25, 1.0}) {
        Settings settings = brief(5);
        settings.weight = weight;
        EXPECT_NEAR(channelMeans(run(request, settings).image).front(), first + weight * (second - first),
                    0.05);
    }
    request.exemplars.push_back(request.exemplars.front());
    EXPECT_THROW(findMethod("portilla-simoncelli").check(request, {}), UsageError);
}

TEST(PortillaSimoncelli, equalChannelsStayEqual) {
    Image grey({64, 64}, 3);
    const Image one = blobs({64, 64}, 1);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                grey(x, y, c) = one(x, y, 0);
    const Image image = run(requestFor(grey, {80, 64}), brief(4)).image;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 80; ++x) {
            ASSERT_NEAR(image(x, y, 0), image(x, y, 1), 1e-4);
            ASSERT_NEAR(image(x, y, 0), image(x, y, 2), 1e-4);
        }
}

TEST(PortillaSimoncelli, channelsThatDoNotCountFollowTheOthers) {
    Image exemplar = blobs({64, 64}, 2);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            exemplar(x, y, 1) = 3 - 2 * exemplar(x, y, 0);
    Settings settings = brief(4);
    settings.jointChannels = 1;
    const Image image = run(requestFor(exemplar, {64, 64}), settings).image;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            ASSERT_NEAR(image(x, y, 1), 3 - 2 * image(x, y, 0), 2e-3);
}

TEST(PortillaSimoncelli, oddSizesHaveTheStatisticsOfEvenOnes) {
    const Image exemplar = gravel({127, 93}, 1, 2);
    const Synthesis result = run(requestFor(exemplar, {101, 119}, {true, true}), brief(25));
    EXPECT_EQ(result.image.size(), (Size{101, 119}));
    for (const Group group : {Group::Autocorrelation, Group::MagnitudeAutocorrelation, Group::Marginals})
        EXPECT_LT(deviation(result, group), 0.05) << titleOf(group).text();
}

} // namespace
} // namespace texloom::test::portilla_simoncelli_tests

#include "core/math/fft.h"
#include "core/math/periodic_component.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

namespace texloom::test::random_phase_tests {
namespace {

using Complex = std::complex<float>;

Image drawn(const Request& request, const Values& settings = {}) {
    return resultOf(findMethod("random-phase"), request, settings).image;
}

std::vector<Complex> spectrumOf(const Image& image, int channel) {
    const RealFft2d fft(image.size());
    FftBuffer<Complex> spectrum(fft.spectrumSize());
    fft.forward(image.plane(channel).data, spectrum.data(), [] {});
    std::vector<Complex> bins;
    for (int u = 0; u < fft.columns(); ++u)
        for (int v = 0; v < image.height(); ++v)
            bins.push_back(spectrum.data()[u * fft.columnStride() + v]);
    return bins;
}

double variance(const ImageView& image, int channel) {
    const double mean = channelMeans(image)[static_cast<std::size_t>(channel)];
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            sum += std::pow(static_cast<double>(image(x, y, channel)) - mean, 2);
    return sum / static_cast<double>(image.size().area());
}

/// Mean of (u(p) − m)(u(p + lag) − m) over a torus.
double autocovariance(const Image& image, int dx, int dy) {
    const double mean = channelMeans(image).front();
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            sum +=
                (static_cast<double>(image(x, y, 0)) - mean) *
                (static_cast<double>(image((x + dx) % image.width(), (y + dy) % image.height(), 0)) - mean);
    return sum / static_cast<double>(image.size().area());
}

TEST(RandomPhase, keepsTheModulusOfThePeriodicComponent) {
    for (const Size size : {Size{64, 48}, Size{33, 27}, Size{30, 41}}) {
        const Image exemplar = blobs(size, 2);
        const Image image = drawn(requestOf(exemplar, size));
        const Image periodic = periodicComponent(exemplar);
        for (int c = 0; c < 2; ++c) {
            const auto ours = spectrumOf(image, c), theirs = spectrumOf(periodic, c);
            for (std::size_t i = 0; i < ours.size(); ++i)
                ASSERT_NEAR(std::abs(ours[i]), std::abs(theirs[i]), 2e-3) << i;
        }
    }
}

TEST(RandomPhase, keepsTheModulusOfTheExemplarWithoutTakingJumpsOff) {
    const Image exemplar = blobs({32, 32}, 1);
    const auto ours = spectrumOf(drawn(requestOf(exemplar, {32, 32}), {{"periodic", false}}), 0);
    const auto theirs = spectrumOf(exemplar, 0);
    for (std::size_t i = 0; i < ours.size(); ++i)
        ASSERT_NEAR(std::abs(ours[i]), std::abs(theirs[i]), 2e-3);
}

TEST(RandomPhase, turnsEveryChannelByTheSamePhase) {
    const Image exemplar = blobs({40, 40}, 3);
    for (const char* model : {"phase-noise", "spot-noise"}) {
        const Image image = drawn(requestOf(exemplar, {40, 40}), {{"model", std::string(model)}});
        const Image periodic = periodicComponent(exemplar);
        const auto a = spectrumOf(image, 0), b = spectrumOf(image, 2);
        const auto a0 = spectrumOf(periodic, 0), b0 = spectrumOf(periodic, 2);
        for (std::size_t i = 1; i < a.size(); ++i)
            ASSERT_LT(std::abs(a[i] * b0[i] - b[i] * a0[i]), 0.02F + 2e-3F * std::abs(a[i] * b0[i]));
    }
}

TEST(RandomPhase, keepsMeanAndVarianceAtEverySizeOfATorus) {
    const Image exemplar = blobs({48, 40}, 3);
    const Image periodic = periodicComponent(exemplar);
    double wanted = 0;
    for (int c = 0; c < 3; ++c)
        wanted += variance(periodic, c);
    for (const Size size : {Size{48, 40}, Size{128, 100}, Size{48, 97}, Size{31, 120}, Size{17, 16}}) {
        const Image image = drawn(requestOf(exemplar, size, {true, true}));
        double sum = 0;
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(channelMeans(image)[static_cast<std::size_t>(c)],
                        channelMeans(exemplar)[static_cast<std::size_t>(c)], 1e-5);
            sum += variance(image, c);
        }
        EXPECT_NEAR(sum / wanted, 1, 1e-3) << size.width << " × " << size.height;
    }
}

TEST(RandomPhase, spotNoiseHasTheAutocovarianceOfTheExemplar) {
    const Image exemplar = blobs({24, 24}, 1);
    const Image periodic = periodicComponent(exemplar);
    constexpr int kDraws = 600;
    const std::vector<Size> lags{{0, 0}, {1, 0}, {0, 1}, {2, 3}, {5, 0}, {12, 12}};
    std::vector<double> sums(lags.size(), 0.0);
    for (int draw = 0; draw < kDraws; ++draw) {
        const Image image = drawn(requestOf(exemplar, {24, 24}, {}, static_cast<std::uint64_t>(draw)),
                                  {{"model", std::string("spot-noise")}});
        for (std::size_t i = 0; i < lags.size(); ++i)
            sums[i] += autocovariance(image, lags[i].width, lags[i].height) / kDraws;
    }
    const double scale = variance(periodic, 0);
    for (std::size_t i = 0; i < lags.size(); ++i)
        EXPECT_NEAR(sums[i] / scale, autocovariance(periodic, lags[i].width, lags[i].height) / scale, 0.06)
            << lags[i].width << ' ' << lags[i].height;
}

TEST(RandomPhase, smallOutputIsCutFromATorusOfTheExemplarsSize) {
    const Image exemplar = blobs({60, 50}, 1);
    const Image whole = drawn(requestOf(exemplar, {60, 50}));
    const Image part = drawn(requestOf(exemplar, {20, 30}));
    EXPECT_TRUE(samePixels(whole.view().crop(0, 0, {20, 30}), part));
}

TEST(RandomPhase, keepsTheScaleOfHighValues) {
    Image bright = blobs({40, 40}, 1);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            bright(x, y, 0) = 1000 + 300 * bright(x, y, 0);
    const double wanted = variance(periodicComponent(bright), 0);
    EXPECT_NEAR(variance(drawn(requestOf(bright, {90, 70})), 0) / wanted, 1, 1e-3);
}

} // namespace
} // namespace texloom::test::random_phase_tests

#include "core/math/fft.h"
#include "core/math/periodic_component.h"
#include "core/math/smooth_spectrum.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace texloom::test::low_frequency_tests {
namespace {

using Complex = std::complex<float>;

Image made(const Request& request, const std::string& id, const Values& settings = {}) {
    return resultOf(findMethod(id), request, settings).image;
}

Image made(const Request& request, double theta) {
    return made(request, "low-frequency", {{"theta", theta}});
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

/// The transform of the Gaussian at every bin of spectrumOf().
std::vector<double> gaussianOf(Size size, double theta) {
    std::vector<double> values;
    for (int u = 0; u < size.width / 2 + 1; ++u)
        for (int v = 0; v < size.height; ++v) {
            const double x = static_cast<double>(u) / size.width;
            const double y = static_cast<double>(std::min(v, size.height - v)) / size.height;
            values.push_back(
                std::exp(-2 * std::numbers::pi * std::numbers::pi * theta * theta * (x * x + y * y)));
        }
    return values;
}

double largestDifference(const ImageView& a, const ImageView& b) {
    double most = 0;
    for (int c = 0; c < a.channels; ++c)
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x)
                most = std::max(most, std::abs(static_cast<double>(a(x, y, c) - b(x, y, c))));
    return most;
}

TEST(SmoothSpectrum, isThatOfTheSmoothComponent) {
    for (const Size size : {Size{40, 32}, Size{33, 27}, Size{1, 9}}) {
        const Image image = blobs(size, 1), periodic = periodicComponent(image);
        Image smooth(image);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                smooth(x, y, 0) -= periodic(x, y, 0);
        const auto wanted = spectrumOf(smooth, 0);
        const SmoothSpectrum spectrum(image.plane(0));
        for (int u = 0; u < size.width / 2 + 1; ++u)
            for (int v = 0; v < size.height; ++v)
                ASSERT_NEAR(
                    std::abs(spectrum.at(u, v) - wanted[static_cast<std::size_t>(u * size.height + v)]), 0,
                    1e-3);
    }
}

TEST(LowFrequency, addsNothingButTheBandsDifference) {
    // u − (p − p ∗ G) has the modulus of p ∗ G at every frequency: the high band is untouched, and the low
    // one is a random phase texture.
    for (const Size size : {Size{64, 48}, Size{45, 33}}) {
        const Image exemplar = blobs(size, 2), image = made(requestOf(exemplar, size), 4.0);
        const Image periodic = periodicComponent(exemplar);
        const std::vector<double> gauss = gaussianOf(size, 4.0);
        for (int c = 0; c < 2; ++c) {
            const auto ours = spectrumOf(image, c), theirs = spectrumOf(periodic, c);
            for (std::size_t i = 0; i < ours.size(); ++i) {
                const Complex high = static_cast<float>(1 - gauss[i]) * theirs[i];
                ASSERT_NEAR(std::abs(ours[i] - high), gauss[i] * static_cast<double>(std::abs(theirs[i])),
                            2e-3);
            }
        }
    }
}

TEST(LowFrequency, keepsDetailToTheLastBits) {
    const Image exemplar = noise({96, 80}, 1);
    const auto ours = spectrumOf(made(requestOf(exemplar, {96, 80}), 10.0), 0);
    const auto theirs = spectrumOf(periodicComponent(exemplar), 0);
    const std::vector<double> gauss = gaussianOf({96, 80}, 10.0);
    int high = 0;
    for (std::size_t i = 0; i < ours.size(); ++i)
        if (gauss[i] < 1e-8) {
            ++high;
            // A bin is a sum over 7,680 pixels of 1e-5 of the range, at most.
            ASSERT_LT(std::abs(ours[i] - theirs[i]), 1e-3F);
        }
    EXPECT_GT(high, 3000);
}

TEST(LowFrequency, parts) {
    const Image exemplar = blobs({50, 40}, 3);
    const Request request = requestOf(exemplar, {50, 40});
    // All is low: a texture of random phase. Nothing is low: the exemplar.
    EXPECT_LT(largestDifference(made(request, 0.0), made(request, "random-phase")), 1e-5);
    EXPECT_LT(
        largestDifference(made(request, "low-frequency", {{"theta", 512.0}, {"periodic", false}}), exemplar),
        1e-5);
    EXPECT_LT(largestDifference(made(request, 512.0), periodicComponent(exemplar)), 1e-5);
    EXPECT_GT(largestDifference(made(request, 6.0), exemplar), 0.05);
}

TEST(LowFrequency, keepsTheMeanAndEqualChannelsEqual) {
    Image exemplar = blobs({60, 44}, 2);
    for (int y = 0; y < 44; ++y)
        for (int x = 0; x < 60; ++x)
            exemplar(x, y, 1) = exemplar(x, y, 0);
    for (const Size size : {Size{60, 44}, Size{100, 90}, Size{30, 20}}) {
        const Image image = made(requestOf(exemplar, size, {size.width > 30, size.width > 30}), 5.0);
        EXPECT_LT(largestDifference(image.view().channelRange(0, 1), image.view().channelRange(1, 1)), 1e-6);
        if (size.width > 30) {
            EXPECT_NEAR(channelMeans(image).front(), channelMeans(exemplar).front(), 1e-5);
        }
    }
}

TEST(LowFrequency, takesDetailFromAnInitialImageAndShadesFromTheExemplar) {
    const Image exemplar = blobs({48, 48}, 1, 2), initial = noise({100, 70}, 1);
    Request request = requestOf(exemplar, {100, 70}, {true, true});
    request.inputs.set(kInitialPort, std::make_shared<const Image>(initial));
    const Image image = made(request, 6.0);
    const auto ours = spectrumOf(image, 0), theirs = spectrumOf(periodicComponent(initial), 0);
    const std::vector<double> gauss = gaussianOf({100, 70}, 6.0);
    for (std::size_t i = 0; i < ours.size(); ++i)
        if (gauss[i] < 1e-8) {
            ASSERT_LT(std::abs(ours[i] - theirs[i]), 1e-3F);
        }
    EXPECT_NEAR(channelMeans(image).front(), channelMeans(exemplar).front(), 1e-5);
}

} // namespace
} // namespace texloom::test::low_frequency_tests

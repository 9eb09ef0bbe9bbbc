#include "core/image/image.h"
#include "core/math/steerable_pyramid.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace texloom::test {
namespace {

using Complex = std::complex<float>;
using Spectrum = FftBuffer<Complex>;

void uninterrupted() {}

/// One image's analysis, as images.
struct Parts {
    Image high;
    std::vector<std::vector<Image>> bands; ///< by scale and orientation
    Image low;
};

Image imageOf(const SteerablePyramid& pyramid, int scale, const Spectrum& spectrum) {
    Image image(pyramid.size(scale), 1);
    pyramid.backward(scale, spectrum.data(), image.plane(0).data, uninterrupted);
    return image;
}

Parts analysed(const SteerablePyramid& pyramid, const Image& image) {
    Parts parts;
    Spectrum current = pyramid.spectrum(0);
    pyramid.forward(0, image.plane(0).data, current.data(), uninterrupted);
    const Spectrum high = pyramid.spectrum(0);
    pyramid.takeHigh(current.data(), high.data(), uninterrupted);
    parts.high = imageOf(pyramid, 0, high);
    pyramid.limit(0, current.data(), uninterrupted);
    for (int scale = 0; scale < pyramid.scales(); ++scale) {
        parts.bands.emplace_back();
        for (int k = 0; k < pyramid.orientations(); ++k) {
            const Spectrum band = pyramid.spectrum(scale);
            pyramid.takeBand(scale, k, current.data(), band.data(), uninterrupted);
            parts.bands.back().push_back(imageOf(pyramid, scale, band));
        }
        Spectrum next = pyramid.spectrum(scale + 1);
        pyramid.lower(scale, current.data(), next.data(), uninterrupted);
        current = std::move(next);
    }
    parts.low = imageOf(pyramid, pyramid.scales(), current);
    return parts;
}

Spectrum spectrumOf(const SteerablePyramid& pyramid, int scale, const Image& image) {
    Spectrum spectrum = pyramid.spectrum(scale);
    pyramid.forward(scale, image.plane(0).data, spectrum.data(), uninterrupted);
    return spectrum;
}

Image synthesised(const SteerablePyramid& pyramid, const Parts& parts) {
    Spectrum current = spectrumOf(pyramid, pyramid.scales(), parts.low);
    for (int scale = pyramid.scales() - 1; scale >= 0; --scale) {
        pyramid.limit(scale + 1, current.data(), uninterrupted);
        Spectrum above = pyramid.spectrum(scale);
        pyramid.raise(scale, current.data(), above.data(), uninterrupted);
        for (int k = 0; k < pyramid.orientations(); ++k)
            pyramid.addBand(
                scale, k,
                spectrumOf(pyramid, scale,
                           parts.bands[static_cast<std::size_t>(scale)][static_cast<std::size_t>(k)])
                    .data(),
                above.data(), uninterrupted);
        current = std::move(above);
    }
    pyramid.limit(0, current.data(), uninterrupted);
    pyramid.addHigh(spectrumOf(pyramid, 0, parts.high).data(), current.data(), uninterrupted);
    return imageOf(pyramid, 0, current);
}

double meanSquare(const Image& image) {
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            sum += std::pow(static_cast<double>(image(x, y, 0)), 2);
    return sum / static_cast<double>(image.size().area());
}

struct Shape {
    Size size;
    int scales, orientations;
};

const std::vector<Shape> kShapes{{{64, 64}, 4, 4}, {{64, 48}, 3, 1},   {{61, 47}, 3, 4}, {{50, 38}, 3, 3},
                                 {{37, 90}, 3, 6}, {{128, 96}, 4, 5},  {{17, 33}, 2, 2}, {{8, 8}, 1, 4},
                                 {{1, 7}, 1, 4},   {{317, 211}, 5, 4}, {{23, 23}, 2, 7}};

TEST(SteerablePyramid, reconstructsExactly) {
    for (const auto& [size, scales, orientations] : kShapes) {
        const SteerablePyramid pyramid(size, scales, orientations);
        const Image image = noise(size, 1);
        const Image again = synthesised(pyramid, analysed(pyramid, image));
        Image difference(size, 1);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                difference(x, y, 0) = again(x, y, 0) - image(x, y, 0);
        EXPECT_LT(std::sqrt(meanSquare(difference) / meanSquare(image)), 1e-6)
            << size.width << " × " << size.height;
    }
}

TEST(SteerablePyramid, keepsTheMeanSquare) {
    for (const auto& [size, scales, orientations] : kShapes) {
        const SteerablePyramid pyramid(size, scales, orientations);
        const Image image = noise(size, 1);
        const Parts parts = analysed(pyramid, image);
        double sum = meanSquare(parts.high) + meanSquare(parts.low);
        for (const auto& scale : parts.bands)
            for (const Image& band : scale)
                sum += meanSquare(band);
        EXPECT_NEAR(sum / meanSquare(image), 1, 1e-6) << size.width << " × " << size.height;
    }
}

/// A straight wave whose frequency has the given angle and number of radians per pixel, nearly.
Image wave(int side, double angle, double frequency) {
    const double turns = frequency * side / (2 * std::numbers::pi);
    const int u = static_cast<int>(std::lround(turns * std::cos(angle)));
    const int v = static_cast<int>(std::lround(turns * std::sin(angle)));
    Image image({side, side}, 1);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            image(x, y, 0) =
                static_cast<float>(std::cos(2 * std::numbers::pi * (u * x + v * y) / side + 0.3));
    return image;
}

TEST(SteerablePyramid, bandsFollowTheAngleOfAWave) {
    constexpr int kOrientations = 4;
    const SteerablePyramid pyramid({256, 256}, 3, kOrientations);
    for (const double angle : {0.0, 0.4, 0.9, 1.6, 2.5, 3.0}) {
        const Parts parts = analysed(pyramid, wave(256, angle, 0.6));
        double total = 0;
        for (int k = 0; k < kOrientations; ++k)
            total += meanSquare(parts.bands[1][static_cast<std::size_t>(k)]);
        for (int k = 0; k < kOrientations; ++k) {
            const double along = std::cos(angle - std::numbers::pi * k / kOrientations);
            EXPECT_NEAR(meanSquare(parts.bands[1][static_cast<std::size_t>(k)]) / total,
                        0.8 * std::pow(along, 6), 0.02)
                << angle << ' ' << k;
        }
    }
}

TEST(SteerablePyramid, steersToAnyAngle) {
    // The basis of K = 4 gives the band along any φ as Σ f(φ − θ_k) band_k with f(α) = (cos α + cos 3α) / 2
    // (Freeman & Adelson 1991, theorem 1). A quarter turn of an edge keeps the grid and turns φ by 90°.
    const SteerablePyramid pyramid({64, 64}, 2, 4);
    Image edge({64, 64}, 1), turned({64, 64}, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            edge(x, y, 0) = std::sin(0.9 * (x - 32) + 0.5 * (y - 32)) > 0 && y > 10 ? 1.0F : 0.2F;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            turned(x, y, 0) = edge(y, (64 - x) % 64, 0);
    const Parts straight = analysed(pyramid, edge), quarter = analysed(pyramid, turned);
    const auto steered = [](const Parts& parts, double phi, int x, int y) {
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const double angle = phi - std::numbers::pi * static_cast<double>(k) / 4;
            sum +=
                (std::cos(angle) + std::cos(3 * angle)) / 2 * static_cast<double>(parts.bands[0][k](x, y, 0));
        }
        return sum;
    };
    for (const double phi : {0.0, 0.3, 1.0, 2.2})
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                ASSERT_NEAR(steered(quarter, phi, x, y),
                            steered(straight, phi - std::numbers::pi / 2, y, (64 - x) % 64), 1e-5)
                    << phi;
}

TEST(SteerablePyramid, analyticBandHasTheBandAsRealPartAndOneSideOfTheSpectrum) {
    for (const auto& [size, scales, orientations] : kShapes) {
        const SteerablePyramid pyramid(size, scales, orientations);
        const Image image = noise(size, 1);
        const Parts parts = analysed(pyramid, image);
        const Spectrum spectrum = spectrumOf(pyramid, 0, image);
        pyramid.limit(0, spectrum.data(), uninterrupted);
        for (int k = 0; k < orientations; ++k) {
            const ComplexFft2d& fft = pyramid.complexFft(0);
            const FftBuffer<Complex> complex(fft.imageSize());
            pyramid.analyticBand(0, k, spectrum.data(), complex.data(), uninterrupted);
            double imaginary = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    const Complex value = complex.data()[y * fft.rowStride() + x];
                    ASSERT_NEAR(value.real(), parts.bands[0][static_cast<std::size_t>(k)](x, y, 0), 1e-5);
                    imaginary += std::norm(value.imag()) / static_cast<double>(size.area());
                }
            // Off the line between the two sides, both parts have the same energy.
            if (orientations > 1) {
                EXPECT_NEAR(imaginary, meanSquare(parts.bands[0][static_cast<std::size_t>(k)]), 1e-5);
            }
        }
    }
}

TEST(SteerablePyramid, raisedAnalyticBandInterpolatesTheBand) {
    const SteerablePyramid pyramid({64, 64}, 3, 4);
    const Image image = blobs({64, 64}, 1);
    const Parts parts = analysed(pyramid, image);
    const ComplexFft2d& fft = pyramid.complexFft(0);
    const FftBuffer<Complex> raised(fft.imageSize());
    for (int k = 0; k < 4; ++k) {
        const Image& band = parts.bands[1][static_cast<std::size_t>(k)];
        pyramid.analyticRaised(0, k, spectrumOf(pyramid, 1, band).data(), raised.data(), uninterrupted);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                ASSERT_NEAR(raised.data()[2 * y * fft.rowStride() + 2 * x].real(), band(x, y, 0), 1e-5);
    }
}

TEST(SteerablePyramid, frequenciesAreThoseOfTheWholeImage) {
    const SteerablePyramid pyramid({61, 47}, 3, 2);
    EXPECT_EQ(pyramid.size(3), (Size{8, 6}));
    EXPECT_NEAR(pyramid.frequencyX(2, 3), 2 * std::numbers::pi * 3 * 4 / 61, 1e-12);
    EXPECT_NEAR(pyramid.frequencyY(1, 23), -2 * std::numbers::pi * 2 / 47, 1e-12);
    EXPECT_EQ(SteerablePyramid::largestScales({256, 64}), 4);
    EXPECT_EQ(SteerablePyramid::largestScales({3, 500}), 1);
}

} // namespace
} // namespace texloom::test

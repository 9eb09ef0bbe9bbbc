#include "core/job/random.h"
#include "core/math/fft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

namespace texloom::test {

namespace {

using Wide = std::complex<double>;

/// For the names of the tests.
struct Extent {
    Size size;
    friend void PrintTo(const Extent& extent, std::ostream* out) {
        *out << extent.size.width << 'x' << extent.size.height;
    }
};

/// The transform's images and spectra in one place.
struct Transform {
    explicit Transform(Size size)
        : fft(size), image(fft.imageSize()), spectrum(fft.spectrumSize()), back(fft.imageSize()) {
        const Random random(7);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                at(image, x, y) = static_cast<float>(random.uniform(x, y) - 0.5);
    }
    float& at(const FftBuffer<float>& buffer, int x, int y) const {
        return buffer.data()[y * fft.rowStride() + x];
    }
    Wide bin(int column, int row) const { return spectrum.data()[column * fft.columnStride() + row]; }
    void forward(int rows) const {
        fft.forwardRows(image.data(), rows, spectrum.data(), [] {});
        for (int k = 0; k < fft.columns(); k += RealFft2d::kBlock)
            fft.forwardColumns(spectrum.data(), k, std::min(fft.columns(), k + RealFft2d::kBlock));
    }
    void backward(int rows) const {
        for (int k = 0; k < fft.columns(); k += RealFft2d::kBlock)
            fft.backwardColumns(spectrum.data(), k, std::min(fft.columns(), k + RealFft2d::kBlock));
        fft.backwardRows(spectrum.data(), rows, back.data(), [] {});
    }

    RealFft2d fft;
    FftBuffer<float> image;
    FftBuffer<std::complex<float>> spectrum;
    FftBuffer<float> back;
};

/// The definition: Σ f(x, y) exp(−2πi (u x / W + v y / H)) over the first `rows` rows.
Wide slowBin(const Transform& t, int rows, int u, int v) {
    const Size size = t.fft.size();
    Wide sum = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double turns =
                static_cast<double>(u) * x / size.width + static_cast<double>(v) * y / size.height;
            sum += static_cast<double>(t.at(t.image, x, y)) * std::polar(1.0, -2 * std::numbers::pi * turns);
        }
    return sum;
}

bool madeOfSmallPrimes(int number) {
    for (const int prime : {2, 3, 5, 7})
        while (number % prime == 0)
            number /= prime;
    return number == 1;
}

} // namespace

class FftSizes : public ::testing::TestWithParam<Extent> {};

INSTANTIATE_TEST_SUITE_P(RealFft2d, FftSizes,
                         ::testing::Values(Extent{{8, 8}}, Extent{{15, 12}}, Extent{{30, 14}}, Extent{{1, 7}},
                                           Extent{{7, 1}}, Extent{{36, 35}}, Extent{{20, 41}}),
                         [](const auto& test) {
                             return std::to_string(test.param.size.width) + "x" +
                                    std::to_string(test.param.size.height);
                         });

TEST_P(FftSizes, ForwardIsTheDefinition) {
    const Transform t(GetParam().size);
    t.forward(GetParam().size.height);
    for (int u = 0; u < t.fft.columns(); ++u)
        for (int v = 0; v < GetParam().size.height; ++v)
            ASSERT_LT(std::abs(t.bin(u, v) - slowBin(t, GetParam().size.height, u, v)), 1e-4)
                << u << ' ' << v;
}

TEST_P(FftSizes, RowsLeftOutCountAsZero) {
    const int rows = (GetParam().size.height + 1) / 2;
    const Transform t(GetParam().size);
    t.forward(rows);
    for (int u = 0; u < t.fft.columns(); ++u)
        for (int v = 0; v < GetParam().size.height; ++v)
            ASSERT_LT(std::abs(t.bin(u, v) - slowBin(t, rows, u, v)), 1e-4) << u << ' ' << v;
}

TEST_P(FftSizes, ThereAndBackMultipliesByTheArea) {
    const Size size = GetParam().size;
    const Transform t(size);
    t.forward(size.height);
    t.backward(size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            ASSERT_NEAR(t.at(t.back, x, y) / static_cast<float>(size.area()), t.at(t.image, x, y), 1e-6);
}

TEST_P(FftSizes, FirstRowsComeAsOfTheWhole) {
    const Size size = GetParam().size;
    const int rows = (size.height + 1) / 2;
    const Transform whole(size), part(size);
    for (const Transform* t : {&whole, &part})
        t->forward(size.height);
    whole.backward(size.height);
    part.backward(rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < size.width; ++x)
            ASSERT_NEAR(part.at(part.back, x, y), whole.at(whole.back, x, y), 1e-4);
}

TEST_P(FftSizes, RowsMayBeDoneInBlocks) {
    const Size size = GetParam().size;
    const Transform whole(size), parts(size);
    whole.forward(size.height);
    for (int row = 0; row < size.height; row += RealFft2d::kBlock)
        parts.fft.forwardRows(parts.image.data(), row, std::min(size.height, row + RealFft2d::kBlock),
                              parts.spectrum.data());
    for (int k = 0; k < parts.fft.columns(); ++k)
        parts.fft.forwardColumns(parts.spectrum.data(), k, k + 1);
    for (int u = 0; u < whole.fft.columns(); ++u)
        for (int v = 0; v < size.height; ++v)
            ASSERT_LT(std::abs(whole.bin(u, v) - parts.bin(u, v)), 1e-4);
}

TEST_P(FftSizes, ComplexBackwardIsTheDefinition) {
    const Size size = GetParam().size;
    const ComplexFft2d fft(size);
    FftBuffer<std::complex<float>> spectrum(fft.spectrumSize()), image(fft.imageSize());
    const Random random(3);
    std::fill_n(spectrum.data(), spectrum.size(), std::complex<float>(0));
    std::vector<bool> filled(static_cast<std::size_t>(size.width), false);
    std::vector<Wide> bins(static_cast<std::size_t>(size.area()));
    for (int u = 0; u < (size.width + 2) / 3; ++u) {
        filled[static_cast<std::size_t>(u)] = true;
        for (int v = 0; v < size.height; ++v) {
            const Wide bin(random.uniform(u, v, 0) - 0.5, random.uniform(u, v, 1) - 0.5);
            spectrum.data()[u * fft.columnStride() + v] = std::complex<float>(bin);
            bins[static_cast<std::size_t>(u * size.height + v)] = bin;
        }
    }
    fft.backward(spectrum.data(), filled, image.data(), [] {});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            Wide sum = 0;
            for (int u = 0; u < size.width; ++u)
                for (int v = 0; v < size.height; ++v)
                    sum += bins[static_cast<std::size_t>(u * size.height + v)] *
                           std::polar(1.0, 2 * std::numbers::pi *
                                               (static_cast<double>(u) * x / size.width +
                                                static_cast<double>(v) * y / size.height));
            ASSERT_LT(std::abs(Wide(image.data()[y * fft.rowStride() + x]) - sum), 1e-4) << x << ' ' << y;
        }
}

TEST(RealFft2d, GivesTheSameBitsOnEveryThread) {
    const Transform here({60, 42}), there({60, 42});
    here.forward(42);
    std::thread([&] { there.forward(42); }).join();
    for (int u = 0; u < here.fft.columns(); ++u)
        for (int v = 0; v < 42; ++v)
            ASSERT_EQ(here.bin(u, v), there.bin(u, v));
}

TEST(RealFft2d, LeavesItsInputAlone) {
    const Transform t({30, 14}), untouched({30, 14});
    t.forward(14);
    for (int y = 0; y < 14; ++y)
        for (int x = 0; x < 30; ++x)
            ASSERT_EQ(t.at(t.image, x, y), untouched.at(untouched.image, x, y));
}

TEST(FastFftLength, IsTheNextProductOfSmallPrimes) {
    for (int length = 1; length <= 3000; ++length) {
        const int fast = fastFftLength(length);
        ASSERT_GE(fast, length);
        ASSERT_TRUE(madeOfSmallPrimes(fast)) << length;
        for (int between = length; between < fast; ++between)
            ASSERT_FALSE(madeOfSmallPrimes(between)) << length;
    }
}

} // namespace texloom::test

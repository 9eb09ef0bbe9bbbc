#include "tests/methods/golden/rounding.h"

#include "core/job/random.h"
#include "core/math/fft.h"

#include <array>
#include <cmath>

namespace texloom::test {

namespace {

void addFunctions(Hash& hash) {
    const Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const double x = 20 * random.uniform(i, 0) + 1e-6, y = 4 * random.uniform(i, 1) - 2;
        const auto f = static_cast<float>(x), g = static_cast<float>(y);
        hash.addAll(std::span<const double>(
            std::array{std::exp(y), std::log(x), std::log2(x), std::pow(x, y), std::sin(x), std::cos(x),
                       std::tan(y), std::atan2(y, x), std::acos(y / 2), std::hypot(x, y), std::tanh(y)}));
        hash.addAll(std::span<const float>(std::array{std::exp(g), std::log(f), std::log2(f), std::pow(f, g),
                                                      std::sin(f), std::cos(f), std::hypot(f, g)}));
    }
}

void addTransforms(Hash& hash, Size size) {
    const RealFft2d fft(size);
    FftBuffer<float> image(fft.imageSize());
    FftBuffer<RealFft2d::Complex> spectrum(fft.spectrumSize());
    const Random random(6);
    for (std::size_t i = 0; i < image.size(); ++i)
        image.data()[i] = static_cast<float>(random.uniform(static_cast<int>(i), 0));
    std::fill_n(spectrum.data(), spectrum.size(), RealFft2d::Complex{});
    fft.forward(image.data(), spectrum.data(), [] {});
    for (int k = 0; k < fft.columns(); ++k)
        hash.addAll(std::span<const RealFft2d::Complex>(spectrum.data() + k * fft.columnStride(),
                                                        static_cast<std::size_t>(size.height)));
    fft.backward(spectrum.data(), image.data(), [] {});
    for (int y = 0; y < size.height; ++y)
        hash.addAll(
            std::span<const float>(image.data() + y * fft.rowStride(), static_cast<std::size_t>(size.width)));
}

} // namespace

std::uint64_t roundingOfThisMachine() {
    Hash hash;
    addFunctions(hash);
    for (const Size size : {Size{128, 128}, Size{160, 144}, Size{96, 90}, Size{21, 35}, Size{250, 8}})
        addTransforms(hash, size);
    return hash.value();
}

} // namespace texloom::test

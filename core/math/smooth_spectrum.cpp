#include "core/math/smooth_spectrum.h"

#include "core/math/fft.h"

#include <cmath>
#include <numbers>

namespace texloom {

namespace {

using Complex = std::complex<float>;

/// The transform of a real line, at all its frequencies.
std::vector<Complex> transformed(const std::vector<float>& line) {
    const int length = static_cast<int>(line.size());
    const RealFft2d fft({length, 1});
    FftBuffer<float> values(fft.imageSize());
    FftBuffer<Complex> spectrum(fft.spectrumSize());
    std::copy(line.begin(), line.end(), values.data());
    fft.forward(values.data(), spectrum.data(), [] {});
    std::vector<Complex> all;
    for (int k = 0; k < length; ++k)
        all.push_back(k < fft.columns() ? spectrum.data()[k * fft.columnStride()]
                                        : std::conj(spectrum.data()[(length - k) * fft.columnStride()]));
    return all;
}

/// 1 − e^(2πik / length): a sample at 0 minus one at the far end.
std::vector<Complex> steps(int length) {
    std::vector<Complex> values;
    for (int k = 0; k < length; ++k) {
        const double angle = 2 * std::numbers::pi * k / length;
        const double half = std::sin(angle / 2);
        values.emplace_back(static_cast<float>(2 * half * half), static_cast<float>(-std::sin(angle)));
    }
    return values;
}

/// 2 cos(2πk / length) − 2, without cancellation.
std::vector<float> laplacianFactors(int length) {
    std::vector<float> values;
    for (int k = 0; k < length; ++k) {
        const double half = std::sin(std::numbers::pi * k / length);
        values.push_back(static_cast<float>(-4 * half * half));
    }
    return values;
}

} // namespace

SmoothSpectrum::SmoothSpectrum(const PlaneView& image)
    : m_stepsX(steps(image.width)), m_stepsY(steps(image.height)),
      m_laplacianX(laplacianFactors(image.width)), m_laplacianY(laplacianFactors(image.height)) {
    const int right = image.width - 1, bottom = image.height - 1;
    std::vector<float> below, beside;
    for (int x = 0; x <= right; ++x)
        below.push_back(image(x, bottom) - image(x, 0));
    for (int y = 0; y <= bottom; ++y)
        beside.push_back(image(right, y) - image(0, y));
    m_below = transformed(below);
    m_beside = transformed(beside);
}

} // namespace texloom

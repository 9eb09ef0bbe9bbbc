#include "core/methods/low_frequency/low_band.h"

#include "core/base/text.h"
#include "core/math/random_phases.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace texloom::low_frequency {

namespace {

constexpr int kBlock = RealFft2d::kBlock;

/// The transform of a Gaussian of this deviation on a torus: e^(−2π²θ²f²).
std::vector<float> gaussian(int length, double theta) {
    std::vector<float> values;
    for (int k = 0; k < length; ++k) {
        const double frequency = static_cast<double>(std::min(k, length - k)) / length;
        const double exponent = std::numbers::pi * theta * frequency;
        values.push_back(static_cast<float>(std::exp(-2 * exponent * exponent)));
    }
    return values;
}

} // namespace

LowBand::LowBand(Size size, const Settings& settings, JobContext& context)
    : m_settings(settings), m_context(context), m_fft(size), m_alongX(gaussian(size.width, settings.theta)),
      m_alongY(gaussian(size.height, settings.theta)), m_factors(m_fft.spectrumSize()),
      m_spectrum(m_fft.spectrumSize()), m_plane(size, 1) {}

void LowBand::drawFactors() {
    const RandomPhases phases(PhaseModel::PhaseNoise, m_fft.size(), m_context.random());
    m_context.parallel(0, m_fft.columns(), [&](int column) {
        phases.draw(column, m_factors.data() + column * m_fft.columnStride());
    });
}

void LowBand::forward(const PlaneView& plane, Complex* spectrum) {
    m_context.parallel(0, RealFft2d::blocksFor(plane.height), [&](int block) {
        m_fft.forwardRows(plane.data, block * kBlock, std::min(plane.height, (block + 1) * kBlock), spectrum);
    });
    m_context.parallel(0, RealFft2d::blocksFor(m_fft.columns()), [&](int block) {
        m_fft.forwardColumns(spectrum, block * kBlock, std::min(m_fft.columns(), (block + 1) * kBlock));
    });
}

void LowBand::transformSpot(const PhaseSpot& spot, int channel) {
    const PlaneSpan plane = m_plane.plane(0);
    m_context.parallel(0, plane.height, [&](int y) { std::fill_n(plane.row(y), plane.width, 0.0F); });
    spot.write(channel, plane);
    forward(plane, m_spot.data());
}

/// Turns a column of the image's spectrum into that of what is to be taken off.
void LowBand::changeColumn(int column, const SmoothSpectrum* smooth, const PhaseSpot* spot, int channel) {
    const std::ptrdiff_t offset = column * m_fft.columnStride();
    Complex* values = m_spectrum.data() + offset;
    const Complex* factors = m_factors.data() + offset;
    const auto area = static_cast<float>(m_fft.size().area());
    const float gaussX = m_alongX[static_cast<std::size_t>(column)];
    for (int row = 0; row < m_fft.size().height; ++row) {
        const Complex jumps = smooth ? smooth->at(column, row) : Complex(0, 0);
        const float gauss = gaussX * m_alongY[static_cast<std::size_t>(row)];
        const Complex own = gauss * (values[row] - jumps);
        Complex fresh = spot ? gauss * m_spot.data()[offset + row] : own;
        fresh = {fresh.real() * factors[row].real() - fresh.imag() * factors[row].imag(),
                 fresh.real() * factors[row].imag() + fresh.imag() * factors[row].real()};
        if (column == 0 && row == 0)
            fresh = spot ? Complex(static_cast<float>(spot->mean(channel)) * area, 0) : own;
        values[row] = (jumps + own - fresh) / area;
    }
}

void LowBand::subtract(const PlaneSpan& plane) {
    m_context.parallel(0, RealFft2d::blocksFor(plane.height), [&](int block) {
        const int first = block * kBlock, last = std::min(plane.height, first + kBlock);
        m_fft.backwardRows(m_spectrum.data(), first, last, m_plane.plane(0).data);
        for (int y = first; y < last; ++y) {
            const float* change = m_plane.plane(0).row(y);
            float* row = plane.row(y);
            for (int x = 0; x < plane.width; ++x)
                row[x] -= change[x];
        }
    });
}

void LowBand::change(Image& image, const PhaseSpot* spot, Size visible, double weight) {
    m_context.stage(0.2 * weight, TR("Drawing phases"));
    drawFactors();
    if (spot)
        m_spot = FftBuffer<Complex>(m_fft.spectrumSize());
    m_context.stage(0.8 * weight, TR("Changing low frequencies"));
    for (int c = 0; c < image.channels(); ++c) {
        const auto show = [&](double share) {
            m_context.progress((c + share) / image.channels());
            m_context.preview(image.view().crop(0, 0, visible));
        };
        show(0);
        const std::optional<SmoothSpectrum> smooth =
            m_settings.periodic ? std::optional<SmoothSpectrum>(image.plane(c)) : std::nullopt;
        if (spot)
            transformSpot(*spot, c);
        forward(image.plane(c), m_spectrum.data());
        show(0.4);
        m_context.parallel(0, RealFft2d::blocksFor(m_fft.columns()), [&](int block) {
            const int first = block * kBlock, last = std::min(m_fft.columns(), first + kBlock);
            for (int column = first; column < last; ++column)
                changeColumn(column, smooth ? &*smooth : nullptr, spot, c);
            m_fft.backwardColumns(m_spectrum.data(), first, last);
        });
        show(0.7);
        subtract(image.plane(c));
        show(1);
    }
}

std::uint64_t LowBand::bytesFor(Size size, bool spot) {
    const RealFft2d fft(size);
    return Image::bytesFor(size, 1) + (spot ? 3 : 2) * fft.spectrumSize() * sizeof(Complex) +
           static_cast<std::uint64_t>(size.width + size.height) * 64;
}

} // namespace texloom::low_frequency

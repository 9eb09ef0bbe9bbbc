#include "core/math/steerable_pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace texloom {

namespace {

using Complex = std::complex<float>;

constexpr double kPi = std::numbers::pi;
/// Samples that the low residual keeps along the shorter side.
constexpr int kLeastSide = 4;

Size sizeAt(Size size, int scale) {
    const int step = 1 << scale;
    return {(size.width + step - 1) / step, (size.height + step - 1) / step};
}

/// The raised cosine of one octave below π: 1 up to π/2, 0 from π on.
double lowPass(double radius) {
    if (radius <= kPi / 2)
        return 1;
    return radius >= kPi ? 0 : std::cos(kPi / 2 * std::log2(2 * radius / kPi));
}

double complement(double low) {
    return std::sqrt(std::max(0.0, 1 - low * low));
}

/// The factor that makes the squares of all orientations add to 1: 2^(K−1) (K−1)! / √(K (2K−2)!).
double angularScale(int orientations) {
    double scale = 1 / std::sqrt(static_cast<double>(orientations));
    for (int i = 1; i < orientations; ++i)
        scale *= 2 * i / std::sqrt((2.0 * i) * (2.0 * i - 1));
    return scale;
}

int signedIndex(int index, int length) {
    return 2 * index > length ? index - length : index;
}

/// (−i)^power, or its conjugate.
Complex turn(int power, bool conjugate) {
    constexpr Complex kTurns[] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
    const Complex value = kTurns[power % 4];
    return conjugate ? std::conj(value) : value;
}

/// Where the frequencies of a smaller spectrum lie in a larger one. Its Nyquist column and row are left out.
struct Window {
    Window(Size small, Size large)
        : columns((small.width + 1) / 2), top((small.height + 1) / 2), bottom((small.height - 1) / 2),
          smallBottom(small.height - bottom), largeBottom(large.height - bottom) {}

    int columns;     ///< from the left
    int top, bottom; ///< rows from the top, for frequencies from 0 up, and rows at the bottom
    int smallBottom, largeBottom;
};

} // namespace

SteerablePyramid::SteerablePyramid(Size size, int scales, int orientations, const Check& check)
    : m_size(size), m_orientations(orientations) {
    for (int scale = 0; scale <= scales; ++scale) {
        m_levels.push_back({RealFft2d(sizeAt(size, scale)), ComplexFft2d(sizeAt(size, scale)), {}, {}});
        makeFilters(scale, scale == scales, check);
    }
}

int SteerablePyramid::largestScales(Size size) {
    int scales = 1;
    while (sizeAt(size, scales + 1).shorterSide() >= kLeastSide)
        ++scales;
    return scales;
}

FftBuffer<Complex> SteerablePyramid::spectrum(int scale) const {
    FftBuffer<Complex> made(fft(scale).spectrumSize());
    std::fill_n(made.data(), made.size(), Complex(0, 0));
    return made;
}

double SteerablePyramid::frequencyX(int scale, int column) const {
    return 2 * kPi * signedIndex(column, size(scale).width) * (1 << scale) / m_size.width;
}

double SteerablePyramid::frequencyY(int scale, int row) const {
    return 2 * kPi * signedIndex(row, size(scale).height) * (1 << scale) / m_size.height;
}

void SteerablePyramid::makeFilters(int scale, bool last, const Check& check) {
    Level& level = m_levels[static_cast<std::size_t>(scale)];
    const std::size_t count = level.fft.spectrumSize();
    level.limit.assign(count, 0);
    if (scale == 0)
        m_high.assign(count, 0);
    for (int k = 0; k < m_orientations && !last; ++k) {
        check();
        level.bands.emplace_back(count, 0.0F);
    }
    const double angular = angularScale(m_orientations);
    for (int column = 0; column < level.fft.columns(); ++column) {
        check();
        const double x = frequencyX(scale, column);
        for (int row = 0; row < level.fft.size().height; ++row) {
            const double y = frequencyY(scale, row), radius = std::hypot(x, y);
            const std::size_t bin = at(scale, column) + static_cast<std::size_t>(row);
            const double low = lowPass(radius);
            level.limit[bin] = static_cast<float>(low);
            if (scale == 0)
                m_high[bin] = static_cast<float>(complement(low));
            const double high = low > 0 ? complement(lowPass(2 * radius)) : 0;
            for (std::size_t k = 0; high > 0 && k < level.bands.size(); ++k) {
                const double angle = kPi * static_cast<double>(k) / m_orientations;
                const double along = (x * std::cos(angle) + y * std::sin(angle)) / radius;
                level.bands[k][bin] =
                    static_cast<float>(high * angular * std::pow(along, m_orientations - 1));
            }
        }
    }
}

void SteerablePyramid::forward(int scale, const float* image, Complex* spectrum, const Check& check) const {
    const RealFft2d& transform = fft(scale);
    const float factor = 1 / static_cast<float>(transform.size().area());
    transform.forwardRows(image, transform.size().height, spectrum, check);
    for (int column = 0; column < transform.columns(); column += RealFft2d::kBlock) {
        check();
        const int last = std::min(column + RealFft2d::kBlock, transform.columns());
        transform.forwardColumns(spectrum, column, last);
        auto* values = reinterpret_cast<float*>(spectrum + at(scale, column));
        const std::size_t count = 2 * (at(scale, last) - at(scale, column));
        for (std::size_t i = 0; i < count; ++i)
            values[i] *= factor;
    }
}

void SteerablePyramid::backward(int scale, Complex* spectrum, float* image, const Check& check) const {
    fft(scale).backward(spectrum, image, check);
}

namespace {

/// Bins between two checks.
constexpr std::size_t kPiece = std::size_t{1} << 19;

/// to = from × filter.
void multiply(const Complex* from, const std::vector<float>& filter, Complex* to,
              const SteerablePyramid::Check& check) {
    const auto* p = reinterpret_cast<const float*>(from);
    auto* q = reinterpret_cast<float*>(to);
    for (std::size_t first = 0; first < filter.size(); first += kPiece) {
        check();
        for (std::size_t i = first; i < std::min(filter.size(), first + kPiece); ++i) {
            q[2 * i] = p[2 * i] * filter[i];
            q[2 * i + 1] = p[2 * i + 1] * filter[i];
        }
    }
}

/// to += from × filter × factor.
void addProduct(const Complex* from, const std::vector<float>& filter, Complex factor, Complex* to,
                const SteerablePyramid::Check& check) {
    const auto* p = reinterpret_cast<const float*>(from);
    auto* q = reinterpret_cast<float*>(to);
    const float re = factor.real(), im = factor.imag();
    for (std::size_t first = 0; first < filter.size(); first += kPiece) {
        check();
        for (std::size_t i = first; i < std::min(filter.size(), first + kPiece); ++i) {
            q[2 * i] += (re * p[2 * i] - im * p[2 * i + 1]) * filter[i];
            q[2 * i + 1] += (re * p[2 * i + 1] + im * p[2 * i]) * filter[i];
        }
    }
}

void clear(Complex* spectrum, std::size_t count, const SteerablePyramid::Check& check) {
    for (std::size_t first = 0; first < count; first += kPiece) {
        check();
        std::fill_n(spectrum + first, std::min(kPiece, count - first), Complex(0, 0));
    }
}

} // namespace

void SteerablePyramid::takeHigh(const Complex* whole, Complex* high, const Check& check) const {
    multiply(whole, m_high, high, check);
}

void SteerablePyramid::addHigh(const Complex* high, Complex* whole, const Check& check) const {
    addProduct(high, m_high, 1, whole, check);
}

void SteerablePyramid::limit(int scale, Complex* spectrum, const Check& check) const {
    multiply(spectrum, m_levels[static_cast<std::size_t>(scale)].limit, spectrum, check);
}

void SteerablePyramid::lower(int scale, const Complex* spectrum, Complex* next, const Check& check) const {
    const Window window(size(scale + 1), size(scale));
    clear(next, fft(scale + 1).spectrumSize(), check);
    for (int column = 0; column < window.columns; ++column) {
        const Complex* from = spectrum + at(scale, column);
        Complex* to = next + at(scale + 1, column);
        std::copy_n(from, window.top, to);
        std::copy_n(from + window.largeBottom, window.bottom, to + window.smallBottom);
    }
    limit(scale + 1, next, check);
}

void SteerablePyramid::raise(int scale, const Complex* next, Complex* spectrum, const Check& check) const {
    const Window window(size(scale + 1), size(scale));
    for (int column = 0; column < window.columns; ++column) {
        check();
        const Complex* from = next + at(scale + 1, column);
        Complex* to = spectrum + at(scale, column);
        for (int row = 0; row < window.top; ++row)
            to[row] += from[row];
        for (int row = 0; row < window.bottom; ++row)
            to[window.largeBottom + row] += from[window.smallBottom + row];
    }
}

void SteerablePyramid::addFiltered(int scale, int orientation, const Complex* from, bool backwards,
                                   Complex* to, const Check& check) const {
    const Level& level = m_levels[static_cast<std::size_t>(scale)];
    addProduct(from, level.bands[static_cast<std::size_t>(orientation)], turn(m_orientations - 1, backwards),
               to, check);
}

void SteerablePyramid::takeBand(int scale, int orientation, const Complex* spectrum, Complex* band,
                                const Check& check) const {
    clear(band, fft(scale).spectrumSize(), check);
    addFiltered(scale, orientation, spectrum, false, band, check);
}

void SteerablePyramid::addBand(int scale, int orientation, const Complex* band, Complex* spectrum,
                               const Check& check) const {
    addFiltered(scale, orientation, band, true, spectrum, check);
}

void SteerablePyramid::analyticBand(int scale, int orientation, const Complex* spectrum, Complex* image,
                                    const Check& check) const {
    const FftBuffer<Complex> band(fft(scale).spectrumSize());
    takeBand(scale, orientation, spectrum, band.data(), check);
    layOneSided(scale, orientation, band.data(), scale, image, check);
}

void SteerablePyramid::analyticRaised(int scale, int orientation, const Complex* next, Complex* image,
                                      const Check& check) const {
    layOneSided(scale, orientation, next, scale + 1, image, check);
}

/// Doubles the frequencies on the orientation's side, each read from a half spectrum at its own place or,
/// conjugated, at the opposite one, and sets the others to 0. Frequencies on the dividing line count once.
void SteerablePyramid::layOneSided(int scale, int orientation, const Complex* half, int halfScale,
                                   Complex* image, const Check& check) const {
    const ComplexFft2d& transform = complexFft(scale);
    const Size large = size(scale);
    const Window window(size(halfScale), large);
    const double angle = kPi * orientation / m_orientations;
    const FftBuffer<Complex> whole(transform.spectrumSize());
    clear(whole.data(), whole.size(), check);
    std::vector<bool> filled(static_cast<std::size_t>(large.width), false);
    std::vector<float> alongY(static_cast<std::size_t>(size(halfScale).height));
    for (std::size_t row = 0; row < alongY.size(); ++row)
        alongY[row] = static_cast<float>(frequencyY(halfScale, static_cast<int>(row)) * std::sin(angle));
    constexpr float kNone = 1e-6F;
    const float reachY =
        std::abs(*std::max_element(alongY.begin(), alongY.end(),
                                   [](float a, float b) { return std::abs(a) < std::abs(b); })) +
        kNone;
    for (int column = 0; column < window.columns; ++column) {
        check();
        const Complex* from = half + at(halfScale, column);
        const int opposite = column == 0 ? 0 : large.width - column;
        Complex* own = whole.data() + column * transform.columnStride();
        Complex* other = whole.data() + opposite * transform.columnStride();
        const auto alongX = static_cast<float>(frequencyX(halfScale, column) * std::cos(angle));
        const auto lay = [&](int row, int to) {
            const float along = alongX + alongY[static_cast<std::size_t>(row)];
            if (along > kNone)
                own[to] = 2.0F * from[row];
            else if (along >= -kNone)
                own[to] = from[row];
            if (along < -kNone && column > 0)
                other[to == 0 ? 0 : large.height - to] = 2.0F * std::conj(from[row]);
            else if (along <= kNone && column > 0)
                other[to == 0 ? 0 : large.height - to] = std::conj(from[row]);
        };
        for (int row = 0; row < window.top; ++row)
            lay(row, row);
        for (int row = 0; row < window.bottom; ++row)
            lay(window.smallBottom + row, window.largeBottom + row);
        if (alongX + reachY >= 0)
            filled[static_cast<std::size_t>(column)] = true;
        if (alongX - reachY <= 0)
            filled[static_cast<std::size_t>(opposite)] = true;
    }
    transform.backward(whole.data(), filled, image, check);
}

std::uint64_t SteerablePyramid::bytesFor(Size size, int scales, int orientations) {
    std::uint64_t floats = RealFft2d(size).spectrumSize();
    for (int scale = 0; scale <= scales; ++scale)
        floats += RealFft2d(sizeAt(size, scale)).spectrumSize() *
                  static_cast<std::uint64_t>(scale < scales ? orientations + 1 : 1);
    return floats * sizeof(float);
}

Size pyramidCanvas(Size output, bool wrapX, bool wrapY, int scales) {
    const auto rounded = [scales](int length, bool wraps) {
        const int step = 1 << scales;
        return wraps ? length : fastFftLength(std::max((length + step - 1) / step, kLeastSide)) * step;
    };
    return {rounded(output.width, wrapX), rounded(output.height, wrapY)};
}

int commonScales(int wanted, Size exemplar, Size output, bool wrapX, bool wrapY) {
    int scales = std::min(wanted, SteerablePyramid::largestScales(exemplar));
    if (wrapX)
        scales = std::min(scales, SteerablePyramid::largestScales({output.width, output.width}));
    if (wrapY)
        scales = std::min(scales, SteerablePyramid::largestScales({output.height, output.height}));
    return scales;
}

} // namespace texloom

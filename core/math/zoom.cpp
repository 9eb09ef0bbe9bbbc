#include "core/math/zoom.h"

#include "core/image/mirror.h"
#include "core/math/fft.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace texloom {

namespace {

using Complex = std::complex<float>;

int reflected(int at, int length, bool wraps) {
    return wraps ? (at % length + length) % length : mirrored(at, length);
}

std::vector<float> gaussianKernel(double sigma) {
    const int reach = static_cast<int>(std::ceil(4 * sigma));
    std::vector<double> values;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
        values.push_back(std::exp(-i * i / (2 * sigma * sigma)));
        sum += values.back();
    }
    std::vector<float> kernel;
    for (const double value : values)
        kernel.push_back(static_cast<float>(value / sum));
    return kernel;
}

/// to[x] = Σ kernel[k] × padded[x + k].
void convolveRow(const float* padded, const std::vector<float>& kernel, float* to, int count) {
    std::fill_n(to, count, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k)
        for (int x = 0; x < count; ++x)
            to[x] += kernel[k] * padded[static_cast<std::size_t>(x) + k];
}

/// One periodic line, sampled more finely.
class LineZoom {
public:
    LineZoom(int length, int target)
        : m_length(length), m_short({length, 1}), m_long({target, 1}), m_image(m_short.imageSize()),
          m_spectrum(m_short.spectrumSize()), m_wideSpectrum(m_long.spectrumSize()),
          m_wide(m_long.imageSize()) {}

    float* line() { return m_image.data(); }
    /// `target` samples.
    const float* zoomed() {
        m_short.forwardRows(m_image.data(), 1, m_spectrum.data(), [] {});
        const float scale = 1.0F / static_cast<float>(m_length);
        for (int k = 0; k < m_long.columns(); ++k) {
            const bool kept = k <= (m_length - 1) / 2;
            m_wideSpectrum.data()[k * m_long.columnStride()] =
                kept ? scale * m_spectrum.data()[k * m_short.columnStride()] : Complex{};
        }
        m_long.backwardRows(m_wideSpectrum.data(), 1, m_wide.data(), [] {});
        return m_wide.data();
    }

private:
    int m_length;
    RealFft2d m_short, m_long;
    FftBuffer<float> m_image;
    FftBuffer<Complex> m_spectrum, m_wideSpectrum;
    FftBuffer<float> m_wide;
};

/// Resamples rows to `width` pixels, twice as many as they have or 1 less.
Image zoomedRows(const ImageView& image, int width, bool wraps, const std::function<void()>& check) {
    Image wide({width, image.height}, image.channels);
    const int length = wraps ? image.width : 2 * image.width;
    LineZoom zoom(length, wraps ? width : 2 * length);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y) {
            check();
            const float* from = image.plane(c).row(y);
            for (int x = 0; x < length; ++x)
                zoom.line()[x] = from[reflected(x, image.width, wraps)];
            std::copy_n(zoom.zoomed(), width, wide.plane(c).row(y));
        }
    return wide;
}

Image transposed(const ImageView& image) {
    Image turned({image.height, image.width}, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                turned(y, x, c) = image(x, y, c);
    return turned;
}

Image blurredRows(const ImageView& image, const std::vector<float>& kernel, bool wraps,
                  const std::function<void()>& check) {
    Image soft(image.size(), image.channels);
    const int reach = static_cast<int>(kernel.size()) / 2;
    std::vector<float> padded(static_cast<std::size_t>(image.width) + kernel.size());
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y) {
            check();
            for (int x = -reach; x < image.width + reach; ++x)
                padded.data()[x + reach] = image.plane(c).row(y)[reflected(x, image.width, wraps)];
            convolveRow(padded.data(), kernel, soft.plane(c).row(y), image.width);
        }
    return soft;
}

} // namespace

Image blurred(const ImageView& image, double sigma, Wrap wrap, const std::function<void()>& check) {
    const std::vector<float> kernel = gaussianKernel(sigma);
    const Image rows = blurredRows(image, kernel, wrap.x, check);
    return transposed(blurredRows(transposed(rows), kernel, wrap.y, check));
}

Image everySecond(const ImageView& image) {
    Image small({(image.width + 1) / 2, (image.height + 1) / 2}, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < small.height(); ++y)
            for (int x = 0; x < small.width(); ++x)
                small(x, y, c) = image(2 * x, 2 * y, c);
    return small;
}

Image zoomedIn(const ImageView& image, Size size, Wrap wrap, const std::function<void()>& check) {
    const Image wide = zoomedRows(image, size.width, wrap.x, check);
    return transposed(zoomedRows(transposed(wide), size.height, wrap.y, check));
}

} // namespace texloom

#include "core/match/masked_distances.h"

#include "core/match/whole_patches.h"

#include <algorithm>
#include <limits>

namespace texloom {

namespace {

/// Of a patch's contrast so much is the same for all, beside the mean: what is all but flat may still be
/// taken.
constexpr float kEvenContrast = 0.25F;

Size maskedFftSize(Size exemplar) {
    return {fastFftLength(exemplar.width), fastFftLength(exemplar.height)};
}

} // namespace

MaskedDistances::MaskedDistances(const PatchSource& source, int patch, const std::function<void()>& check)
    : m_patch(patch), m_positions{source.image.width - patch + 1, source.image.height - patch + 1},
      m_fft(maskedFftSize(source.image.size())), m_means(channelMeans(source.image)),
      m_allowed(static_cast<std::size_t>(m_positions.area()), source.mask.data ? 0 : 1) {
    const ImageView& image = source.image;
    FftBuffer<float> values(m_fft.imageSize()), squares(m_fft.imageSize());
    std::fill_n(values.data(), values.size(), 0.0F);
    std::fill_n(squares.data(), squares.size(), 0.0F);
    for (int c = 0; c < image.channels; ++c) {
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const auto value = static_cast<float>(static_cast<double>(image(x, y, c)) -
                                                      m_means[static_cast<std::size_t>(c)]);
                values.data()[y * m_fft.rowStride() + x] = value;
                squares.data()[y * m_fft.rowStride() + x] += value * value;
            }
        m_spectra.push_back(spectrumOf(values, image.height, check));
    }
    m_spectra.push_back(spectrumOf(squares, image.height, check));
    m_count = m_positions.area();
    if (source.mask.data)
        m_count = 0;
    if (source.mask.data)
        anyWholePatch(
            source.mask, patch,
            [this](int x, int y) {
                m_allowed[index(x, y)] = 1;
                ++m_count;
                return false;
            },
            check);
    measureContrasts(image, check);
}

/// The variance of every patch about its own mean, over all channels, beside the mean of those that are
/// allowed.
void MaskedDistances::measureContrasts(const ImageView& image, const std::function<void()>& check) {
    m_contrasts.assign(m_allowed.size(), 0.0F);
    const auto width = static_cast<std::size_t>(image.width);
    const double pixels = static_cast<double>(m_patch) * m_patch;
    for (int c = 0; c < image.channels; ++c) {
        std::vector<double> sums(width, 0.0), squares(width, 0.0); // of the last rows, by column
        for (int y = 0; y < image.height; ++y) {
            check();
            for (int x = 0; x < image.width; ++x) {
                const auto at = static_cast<std::size_t>(x);
                const double mean = m_means[static_cast<std::size_t>(c)];
                const double in = static_cast<double>(image(x, y, c)) - mean;
                const double out = y >= m_patch ? static_cast<double>(image(x, y - m_patch, c)) - mean : 0;
                sums[at] += in - out;
                squares[at] += in * in - out * out;
            }
            double sum = 0, square = 0;
            for (int x = 0; y + 1 >= m_patch && x < image.width; ++x) {
                const auto at = static_cast<std::size_t>(x);
                const std::size_t gone = x >= m_patch ? at - static_cast<std::size_t>(m_patch) : width;
                sum += sums[at] - (gone < width ? sums[gone] : 0);
                square += squares[at] - (gone < width ? squares[gone] : 0);
                if (x + 1 >= m_patch)
                    m_contrasts[index(x + 1 - m_patch, y + 1 - m_patch)] +=
                        static_cast<float>(std::max(0.0, square - sum * sum / pixels));
            }
        }
    }
    double whole = 0;
    for (std::size_t i = 0; i < m_allowed.size(); ++i)
        whole += m_allowed[i] != 0 ? static_cast<double>(m_contrasts[i]) : 0;
    const auto mean = static_cast<float>(m_count > 0 ? whole / static_cast<double>(m_count) : 0);
    for (float& contrast : m_contrasts)
        contrast = mean > 0 ? (contrast / mean + kEvenContrast) / (1 + kEvenContrast) : 1;
}

void MaskedDistances::balance(std::vector<float>& distances) const {
    for (std::size_t i = 0; i < distances.size(); ++i)
        distances[i] /= m_contrasts[i];
}

FftBuffer<std::complex<float>> MaskedDistances::spectrumOf(const FftBuffer<float>& image, int rows,
                                                           const std::function<void()>& check) const {
    FftBuffer<Complex> spectrum(m_fft.spectrumSize());
    m_fft.forwardRows(image.data(), rows, spectrum.data(), check);
    for (int k = 0; k < m_fft.columns(); k += RealFft2d::kBlock) {
        check();
        m_fft.forwardColumns(spectrum.data(), k, std::min(m_fft.columns(), k + RealFft2d::kBlock));
    }
    return spectrum;
}

void MaskedDistances::compute(const ImageView& known, const PlaneView& counts, std::vector<float>& distances,
                              const std::function<void()>& check) const {
    FftBuffer<float> patch(m_fft.imageSize());
    std::fill_n(patch.data(), patch.size(), 0.0F);
    FftBuffer<Complex> sum(m_fft.spectrumSize());
    std::fill_n(sum.data(), sum.size(), Complex());
    double norm = 0;
    for (int c = 0; c <= known.channels; ++c) {
        for (int y = 0; y < m_patch; ++y)
            for (int x = 0; x < m_patch; ++x) {
                float& to = patch.data()[y * m_fft.rowStride() + x];
                to = counts(x, y);
                if (c == known.channels)
                    continue;
                const double value =
                    static_cast<double>(known(x, y, c)) - m_means[static_cast<std::size_t>(c)];
                norm += static_cast<double>(counts(x, y)) * value * value;
                to = counts(x, y) != 0 ? static_cast<float>(-2 * value) : 0;
            }
        const FftBuffer<Complex> spectrum = spectrumOf(patch, m_patch, check);
        const FftBuffer<Complex>& other = m_spectra[static_cast<std::size_t>(c)];
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum.data()[i] += std::conj(spectrum.data()[i]) * other.data()[i];
    }
    for (int k = 0; k < m_fft.columns(); k += RealFft2d::kBlock) {
        check();
        m_fft.backwardColumns(sum.data(), k, std::min(m_fft.columns(), k + RealFft2d::kBlock));
    }
    m_fft.backwardRows(sum.data(), m_positions.height, patch.data(), check);
    const auto scale = static_cast<float>(1.0 / static_cast<double>(m_fft.size().area()));
    distances.resize(m_allowed.size());
    for (int y = 0; y < m_positions.height; ++y)
        for (int x = 0; x < m_positions.width; ++x)
            distances[index(x, y)] = allows(x, y)
                                         ? std::max(0.0F, static_cast<float>(norm) +
                                                              scale * patch.data()[y * m_fft.rowStride() + x])
                                         : std::numeric_limits<float>::infinity();
}

std::uint64_t MaskedDistances::bytesFor(Size exemplar, int channels) {
    const RealFft2d fft(maskedFftSize(exemplar));
    return fft.spectrumSize() * sizeof(Complex) * static_cast<std::uint64_t>(channels + 3) +
           3 * fft.imageSize() * sizeof(float) + static_cast<std::uint64_t>(exemplar.area()) * 9;
}

} // namespace texloom

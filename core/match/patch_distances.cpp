#include "core/match/patch_distances.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace texloom {

namespace {

using Complex = std::complex<float>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Size fftSize(Size exemplar) {
    return {fastFftLength(exemplar.width), fastFftLength(exemplar.height)};
}

/// to += conj(a) × b, written out on interleaved floats so that it vectorises.
void addConjugateProduct(const Complex* a, const Complex* b, Complex* to, std::ptrdiff_t count) {
    const auto* p = reinterpret_cast<const float*>(a);
    const auto* q = reinterpret_cast<const float*>(b);
    auto* sum = reinterpret_cast<float*>(to);
    for (std::ptrdiff_t i = 0; i < 2 * count; i += 2) {
        sum[i] += p[i] * q[i] + p[i + 1] * q[i + 1];
        sum[i + 1] += p[i] * q[i + 1] - p[i + 1] * q[i];
    }
}

/// to = conj(to) × b.
void conjugateProduct(Complex* to, const Complex* b, std::ptrdiff_t count) {
    auto* p = reinterpret_cast<float*>(to);
    const auto* q = reinterpret_cast<const float*>(b);
    for (std::ptrdiff_t i = 0; i < 2 * count; i += 2) {
        const float re = p[i] * q[i] + p[i + 1] * q[i + 1];
        const float im = p[i] * q[i + 1] - p[i + 1] * q[i];
        p[i] = re;
        p[i + 1] = im;
    }
}

/// distances[i] = max(smallest, norm + squares[i] − scale × correlation[i]) in place of the correlation; the
/// minimum is kept in lanes because a single running one does not vectorise.
float finishRow(float* row, const float* squares, int count, float norm, float scale, float smallest) {
    constexpr int kLanes = 16;
    float minima[kLanes];
    std::fill_n(minima, kLanes, kInfinity);
    int x = 0;
    for (; x + kLanes <= count; x += kLanes)
        for (int lane = 0; lane < kLanes; ++lane) {
            const float distance = norm + squares[x + lane] - scale * row[x + lane];
            const float raised = distance > smallest ? distance : smallest;
            row[x + lane] = raised;
            minima[lane] = raised < minima[lane] ? raised : minima[lane];
        }
    for (; x < count; ++x) {
        row[x] = std::max(smallest, norm + squares[x] - scale * row[x]);
        minima[0] = std::min(minima[0], row[x]);
    }
    return *std::min_element(minima, minima + kLanes);
}

} // namespace

PatchDistances::PatchDistances(const ImageView& exemplar, const PlaneView& mask, std::vector<double> means,
                               int patch)
    : m_size(exemplar.size()), m_channels(exemplar.channels),
      m_patch(patch), m_positions{exemplar.width - patch + 1, exemplar.height - patch + 1},
      m_means(std::move(means)), m_fft(fftSize(exemplar.size())) {
    FftBuffer<float> image(m_fft.imageSize());
    std::fill_n(image.data(), image.size(), 0.0F);
    for (int c = 0; c < m_channels; ++c) {
        const double mean = m_means[static_cast<std::size_t>(c)];
        for (int y = 0; y < m_size.height; ++y)
            for (int x = 0; x < m_size.width; ++x)
                image.data()[y * m_fft.rowStride() + x] =
                    static_cast<float>(static_cast<double>(exemplar(x, y, c)) - mean);
        FftBuffer<Complex>& spectrum = m_spectra.emplace_back(m_fft.spectrumSize());
        m_fft.forwardRows(image.data(), m_size.height, spectrum.data(), [] {});
        for (int k = 0; k < m_fft.columns(); k += RealFft2d::kBlock)
            m_fft.forwardColumns(spectrum.data(), k, std::min(m_fft.columns(), k + RealFft2d::kBlock));
    }
    tabulate(exemplar);
    m_allowed = m_positions.area();
    if (mask.data)
        forbid(mask);
}

void PatchDistances::tabulate(const ImageView& exemplar) {
    const auto width = static_cast<std::size_t>(m_size.width) + 1;
    m_table.assign(width * (static_cast<std::size_t>(m_size.height) + 1), 0.0);
    for (int y = 0; y < m_size.height; ++y) {
        double row = 0;
        for (int x = 0; x < m_size.width; ++x) {
            for (int c = 0; c < m_channels; ++c) {
                const double value =
                    static_cast<double>(exemplar(x, y, c)) - m_means[static_cast<std::size_t>(c)];
                row += value * value;
            }
            const std::size_t at =
                (static_cast<std::size_t>(y) + 1) * width + static_cast<std::size_t>(x) + 1;
            m_table[at] = m_table[at - width] + row;
        }
    }
}

double PatchDistances::tableSum(int x, int y, int width, int height) const {
    const auto stride = static_cast<std::size_t>(m_size.width) + 1;
    const std::size_t top = static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x);
    const std::size_t bottom = top + static_cast<std::size_t>(height) * stride;
    const auto right = static_cast<std::size_t>(width);
    return m_table[bottom + right] - m_table[bottom] - m_table[top + right] + m_table[top];
}

void PatchDistances::forbid(const PlaneView& mask) {
    const auto width = static_cast<std::size_t>(m_size.width) + 1;
    std::vector<std::int32_t> table(width * (static_cast<std::size_t>(m_size.height) + 1), 0);
    for (int y = 0; y < m_size.height; ++y) {
        std::int32_t row = 0;
        for (int x = 0; x < m_size.width; ++x) {
            row += mask(x, y) == 0 ? 1 : 0;
            const std::size_t at =
                (static_cast<std::size_t>(y) + 1) * width + static_cast<std::size_t>(x) + 1;
            table[at] = table[at - width] + row;
        }
    }
    const auto patch = static_cast<std::size_t>(m_patch);
    m_forbiddenPatches.reserve(static_cast<std::size_t>(m_positions.area()));
    for (std::size_t y = 0; y < static_cast<std::size_t>(m_positions.height); ++y)
        for (std::size_t x = 0; x < static_cast<std::size_t>(m_positions.width); ++x) {
            const std::size_t top = y * width + x;
            const std::size_t bottom = top + patch * width;
            const std::int32_t excluded =
                table[bottom + patch] - table[bottom] - table[top + patch] + table[top];
            m_forbiddenPatches.push_back(excluded > 0 ? 1 : 0);
        }
    m_allowed = std::count(m_forbiddenPatches.begin(), m_forbiddenPatches.end(), 0);
}

void PatchDistances::prepare(const Footprint& shape) {
    for (const Shape& known : m_shapes)
        if (known.footprint == shape)
            return;
    Image squares(m_positions, 1);
    const Size area{std::min(m_patch, shape.area.width), std::min(m_patch, shape.area.height)};
    const Overlap& border = shape.border;
    // What the border leaves free, as far as it lies in the area.
    const int innerWidth = std::max(0, std::min(area.width, m_patch - border.right) - border.left);
    const int innerHeight = std::max(0, std::min(area.height, m_patch - border.bottom) - border.top);
    for (int y = 0; y < m_positions.height; ++y) {
        float* row = squares.plane(0).row(y);
        for (int x = 0; x < m_positions.width; ++x) {
            double sum = tableSum(x, y, area.width, area.height);
            if (innerWidth > 0 && innerHeight > 0)
                sum -= tableSum(x + border.left, y + border.top, innerWidth, innerHeight);
            row[x] = forbidden(x, y) ? kInfinity : static_cast<float>(sum);
        }
    }
    m_shapes.push_back({shape, std::move(squares)});
}

const Image& PatchDistances::squaresOf(const Footprint& shape) const {
    return std::find_if(m_shapes.begin(), m_shapes.end(),
                        [&](const Shape& s) { return s.footprint == shape; })
        ->squares;
}

PatchDistances::Scratch PatchDistances::scratch() const {
    Scratch made;
    made.patch =
        FftBuffer<float>(static_cast<std::size_t>(m_fft.rowStride()) * static_cast<std::size_t>(m_patch));
    std::fill_n(made.patch.data(), made.patch.size(), 0.0F);
    for (int c = 0; c < m_channels; ++c)
        made.spectra.emplace_back(m_fft.spectrumSize());
    made.distances = FftBuffer<float>(m_fft.imageSize());
    made.rowMinima.resize(static_cast<std::size_t>(m_positions.height));
    return made;
}

double PatchDistances::transform(const ImageView& known, const Footprint& shape, Scratch& scratch,
                                 const std::function<void()>& check) const {
    double norm = 0;
    for (int c = 0; c < m_channels; ++c) {
        const auto mean = static_cast<float>(m_means[static_cast<std::size_t>(c)]);
        for (int y = 0; y < m_patch; ++y) {
            float* row = scratch.patch.data() + y * m_fft.rowStride();
            for (int x = 0; x < m_patch; ++x) {
                row[x] = shape.contains(x, y, m_patch) ? known(x, y, c) - mean : 0.0F;
                norm += static_cast<double>(row[x]) * static_cast<double>(row[x]);
            }
        }
        m_fft.forwardRows(scratch.patch.data(), m_patch, scratch.spectra[static_cast<std::size_t>(c)].data(),
                          check);
    }
    return norm;
}

void PatchDistances::correlateColumns(Scratch& scratch, int first, int last) const {
    const std::ptrdiff_t begin = first * m_fft.columnStride();
    const std::ptrdiff_t count = (last - first) * m_fft.columnStride();
    Complex* sum = scratch.spectra[0].data();
    for (std::size_t c = 0; c < scratch.spectra.size(); ++c) {
        Complex* patch = scratch.spectra[c].data();
        m_fft.forwardColumns(patch, first, last);
        if (c == 0)
            conjugateProduct(sum + begin, m_spectra[0].data() + begin, count);
        else
            addConjugateProduct(patch + begin, m_spectra[c].data() + begin, sum + begin, count);
    }
    m_fft.backwardColumns(sum, first, last);
}

void PatchDistances::compute(const ImageView& known, const Footprint& shape, float smallest, Scratch& scratch,
                             const std::function<void()>& check) const {
    const double norm = transform(known, shape, scratch, check);
    for (int k = 0; k < m_fft.columns(); k += RealFft2d::kBlock) {
        check();
        correlateColumns(scratch, k, std::min(m_fft.columns(), k + RealFft2d::kBlock));
    }
    m_fft.backwardRows(scratch.spectra[0].data(), m_positions.height, scratch.distances.data(), check);
    const Image& squares = squaresOf(shape);
    const auto scale = static_cast<float>(2.0 / static_cast<double>(m_fft.size().area()));
    for (int y = 0; y < m_positions.height; ++y)
        scratch.rowMinima[static_cast<std::size_t>(y)] =
            finishRow(scratch.distances.data() + y * m_fft.rowStride(), squares.plane(0).row(y),
                      m_positions.width, static_cast<float>(norm), scale, smallest);
}

std::uint64_t PatchDistances::bytesFor(Size exemplar, int channels, int patch, int shapes) {
    const RealFft2d fft(fftSize(exemplar));
    const Size positions{exemplar.width - patch + 1, exemplar.height - patch + 1};
    const auto area = static_cast<std::uint64_t>((exemplar.width + 1LL) * (exemplar.height + 1LL));
    return fft.imageSize() * sizeof(float) +
           fft.spectrumSize() * sizeof(Complex) * static_cast<std::uint64_t>(channels) +
           area * (sizeof(double) + sizeof(std::int32_t) + 1) +
           Image::bytesFor(positions, 1) * static_cast<std::uint64_t>(shapes);
}

std::uint64_t PatchDistances::scratchBytesFor(Size exemplar, int channels) {
    const RealFft2d fft(fftSize(exemplar));
    return 2 * fft.imageSize() * sizeof(float) +
           fft.spectrumSize() * sizeof(Complex) * static_cast<std::uint64_t>(channels);
}

} // namespace texloom

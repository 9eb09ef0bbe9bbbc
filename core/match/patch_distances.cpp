#include "core/match/patch_distances.h"

#include "core/match/whole_patches.h"

#include <algorithm>
#include <cmath>
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

/// distances[i] = factors[i] × max(smallest, norm + squares[i] − scale × correlation[i]) in place of the
/// correlation, the factors being 1 if there are none; the minimum is kept in lanes because a single running
/// one does not vectorise.
float finishRow(float* row, const float* squares, const float* factors, int count, float norm, float scale,
                float smallest) {
    constexpr int kLanes = 16;
    float minima[kLanes];
    std::fill_n(minima, kLanes, kInfinity);
    int x = 0;
    for (; x + kLanes <= count; x += kLanes)
        for (int lane = 0; lane < kLanes; ++lane) {
            const float distance = norm + squares[x + lane] - scale * row[x + lane];
            const float raised = distance > smallest ? distance : smallest;
            const float found = factors ? factors[x + lane] * raised : raised;
            row[x + lane] = found;
            minima[lane] = found < minima[lane] ? found : minima[lane];
        }
    for (; x < count; ++x) {
        row[x] = std::max(smallest, norm + squares[x] - scale * row[x]) * (factors ? factors[x] : 1);
        minima[0] = std::min(minima[0], row[x]);
    }
    return *std::min_element(minima, minima + kLanes);
}

} // namespace

int Footprint::pixels(int patch) const {
    int count = 0;
    for (int y = 0; y < patch; ++y)
        for (int x = 0; x < patch; ++x)
            count += contains(x, y, patch) ? 1 : 0;
    return count;
}

PatchDistances::PatchDistances(const ImageView& exemplar, const PlaneView& mask, std::vector<double> means,
                               int patch, const ContrastBalance& balance)
    : m_size(exemplar.size()), m_channels(exemplar.channels),
      m_patch(patch), m_positions{exemplar.width - patch + 1, exemplar.height - patch + 1},
      m_means(std::move(means)), m_fft(fftSize(exemplar.size())), m_balance(balance) {
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
    const auto value = [&](int x, int y, int c) {
        return static_cast<double>(exemplar(x, y, c)) - m_means[static_cast<std::size_t>(c)];
    };
    m_squares = tabulated([&](int x, int y) {
        double sum = 0;
        for (int c = 0; c < m_channels; ++c)
            sum += value(x, y, c) * value(x, y, c);
        return sum;
    });
    for (int c = 0; c < m_channels && balances(); ++c)
        m_sums.push_back(tabulated([&](int x, int y) { return value(x, y, c); }));
    m_allowed = m_positions.area();
    if (mask.data)
        forbid(mask);
}

template <class Value> PatchDistances::Table PatchDistances::tabulated(const Value& value) const {
    const auto width = static_cast<std::size_t>(m_size.width) + 1;
    Table table(width * (static_cast<std::size_t>(m_size.height) + 1), 0.0);
    for (int y = 0; y < m_size.height; ++y) {
        double row = 0;
        for (int x = 0; x < m_size.width; ++x) {
            row += value(x, y);
            const std::size_t at =
                (static_cast<std::size_t>(y) + 1) * width + static_cast<std::size_t>(x) + 1;
            table[at] = table[at - width] + row;
        }
    }
    return table;
}

double PatchDistances::tableSum(const Table& table, int x, int y, int width, int height) const {
    const auto stride = static_cast<std::size_t>(m_size.width) + 1;
    const std::size_t top = static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x);
    const std::size_t bottom = top + static_cast<std::size_t>(height) * stride;
    const auto right = static_cast<std::size_t>(width);
    return table[bottom + right] - table[bottom] - table[top + right] + table[top];
}

double PatchDistances::shapeSum(const Table& table, const Footprint& shape, int x, int y) const {
    const Size area{std::min(m_patch, shape.area.width), std::min(m_patch, shape.area.height)};
    const Overlap& border = shape.border;
    // The part inside the border, as far as it lies in the area.
    const int innerWidth = std::min(area.width, m_patch - border.right) - border.left;
    const int innerHeight = std::min(area.height, m_patch - border.bottom) - border.top;
    const double sum = tableSum(table, x, y, area.width, area.height);
    return innerWidth > 0 && innerHeight > 0
               ? sum - tableSum(table, x + border.left, y + border.top, innerWidth, innerHeight)
               : sum;
}

void PatchDistances::forbid(const PlaneView& mask) {
    m_forbiddenPatches.assign(static_cast<std::size_t>(m_positions.area()), 1);
    m_allowed = 0;
    anyWholePatch(mask, m_patch, [this](int x, int y) {
        m_forbiddenPatches[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_positions.width) +
                           static_cast<std::size_t>(x)] = 0;
        ++m_allowed;
        return false;
    });
}

void PatchDistances::prepare(const Footprint& shape) {
    for (const Shape& known : m_shapes)
        if (known.footprint == shape)
            return;
    Image squares(m_positions, 1);
    for (int y = 0; y < m_positions.height; ++y) {
        float* row = squares.plane(0).row(y);
        for (int x = 0; x < m_positions.width; ++x)
            row[x] = forbidden(x, y) ? kInfinity : static_cast<float>(shapeSum(m_squares, shape, x, y));
    }
    Image factors = balances() ? factorsOf(shape) : Image();
    m_shapes.push_back({shape, std::move(squares), std::move(factors)});
}

Image PatchDistances::factorsOf(const Footprint& shape) const {
    // Contrast below this share of the usual does not increase distances any further.
    constexpr double kLeast = 0.02;
    const double pixels = shape.pixels(m_patch);
    const double usual = pixels * m_balance.variance;
    Image factors(m_positions, 1);
    for (int y = 0; y < m_positions.height; ++y)
        for (int x = 0; x < m_positions.width; ++x) {
            double contrast = shapeSum(m_squares, shape, x, y);
            for (const Table& table : m_sums) {
                const double sum = shapeSum(table, shape, x, y);
                contrast -= sum * sum / pixels;
            }
            factors(x, y, 0) = static_cast<float>(
                std::pow(std::max(0.0, contrast) / usual + kLeast, -0.5 * m_balance.share));
        }
    return factors;
}

const PatchDistances::Shape& PatchDistances::prepared(const Footprint& shape) const {
    return *std::find_if(m_shapes.begin(), m_shapes.end(),
                         [&](const Shape& s) { return s.footprint == shape; });
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
    const Shape& measured = prepared(shape);
    const auto scale = static_cast<float>(2.0 / static_cast<double>(m_fft.size().area()));
    for (int y = 0; y < m_positions.height; ++y)
        scratch.rowMinima[static_cast<std::size_t>(y)] = finishRow(
            scratch.distances.data() + y * m_fft.rowStride(), measured.squares.view().plane(0).row(y),
            measured.factors.empty() ? nullptr : measured.factors.view().plane(0).row(y), m_positions.width,
            static_cast<float>(norm), scale, smallest);
}

std::uint64_t PatchDistances::bytesFor(Size exemplar, int channels, int patch, int shapes, bool balanced) {
    const RealFft2d fft(fftSize(exemplar));
    const Size positions{exemplar.width - patch + 1, exemplar.height - patch + 1};
    const auto area = static_cast<std::uint64_t>((exemplar.width + 1LL) * (exemplar.height + 1LL));
    const auto deep = static_cast<std::uint64_t>(channels);
    const std::uint64_t tables = 1 + (balanced ? deep : 0), images = balanced ? 2 : 1;
    return fft.imageSize() * sizeof(float) + fft.spectrumSize() * sizeof(Complex) * deep +
           area * (tables * sizeof(double) + 1) +
           images * Image::bytesFor(positions, 1) * static_cast<std::uint64_t>(shapes);
}

std::uint64_t PatchDistances::scratchBytesFor(Size exemplar, int channels) {
    const RealFft2d fft(fftSize(exemplar));
    return 2 * fft.imageSize() * sizeof(float) +
           fft.spectrumSize() * sizeof(Complex) * static_cast<std::uint64_t>(channels);
}

} // namespace texloom

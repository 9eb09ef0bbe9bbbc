#include "core/methods/sparse/terms.h"

#include "core/base/at.h"
#include "core/math/channel_pca.h"
#include "core/math/pca.h"
#include "core/math/phase_spot.h"
#include "core/math/random_phases.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace texloom::sparse {

namespace {

constexpr int kBlock = RealFft2d::kBlock;
/// Columns that one thread filters at a time.
constexpr int kColumns = 64;

/// The pixels that a mask leaves, in one row.
Image chosenPixels(const PatchSource& source, const std::function<void()>& check) {
    if (!source.mask.data)
        return Image(source.image);
    std::int64_t count = 0;
    for (int y = 0; y < source.mask.height; ++y)
        count += std::count_if(source.mask.row(y), source.mask.row(y) + source.mask.width,
                               [](float value) { return value != 0; });
    Image chosen({static_cast<int>(count), 1}, source.image.channels);
    for (int c = 0; c < source.image.channels; ++c) {
        float* to = chosen.plane(c).row(0);
        for (int y = 0; y < source.mask.height; ++y) {
            check();
            for (int x = 0; x < source.mask.width; ++x)
                if (source.mask(x, y) != 0)
                    *to++ = source.image(x, y, c);
        }
    }
    return chosen;
}

/// to[i] = the mean of the `reach` values that end with i. On an axis that wraps there are as many as
/// before, on another `reach` − 1 more. `step` is the distance between values.
class Box {
public:
    Box(int length, int reach, bool wraps) : m_length(length), m_reach(reach), m_wraps(wraps) {}

    int filtered() const { return m_wraps ? m_length : m_length + m_reach - 1; }

    void forward(const float* from, std::ptrdiff_t step, float* to, std::ptrdiff_t toStep) const {
        double sum = 0;
        if (m_wraps)
            for (int i = 1; i < m_reach; ++i)
                sum += value(from, step, wrapped(-i));
        for (int i = 0; i < filtered(); ++i) {
            sum += inside(from, step, i);
            to[i * toStep] = static_cast<float>(sum / m_reach);
            sum -= inside(from, step, i - m_reach + 1);
        }
    }

    /// The adjoint: the mean of the `reach` values that begin with i.
    void backward(const float* from, std::ptrdiff_t step, float* to, std::ptrdiff_t toStep) const {
        double sum = 0;
        for (int i = 0; i < m_reach - 1; ++i)
            sum += value(from, step, m_wraps ? wrapped(i) : i);
        for (int i = 0; i < m_length; ++i) {
            const int last = i + m_reach - 1;
            sum += value(from, step, m_wraps ? wrapped(last) : last);
            to[i * toStep] = static_cast<float>(sum / m_reach);
            sum -= value(from, step, i);
        }
    }

private:
    int wrapped(int i) const { return ((i % m_length) + m_length) % m_length; }
    static double value(const float* from, std::ptrdiff_t step, int i) {
        return static_cast<double>(from[i * step]);
    }
    double inside(const float* from, std::ptrdiff_t step, int i) const {
        if (m_wraps)
            return value(from, step, wrapped(i));
        return i >= 0 && i < m_length ? value(from, step, i) : 0;
    }

    int m_length, m_reach;
    bool m_wraps;
};

void forwardFft(const RealFft2d& fft, const float* image, std::complex<float>* spectrum,
                JobContext& context) {
    const int height = fft.size().height;
    context.parallel(0, RealFft2d::blocksFor(height), [&](int block) {
        fft.forwardRows(image, block * kBlock, std::min(height, (block + 1) * kBlock), spectrum);
    });
    context.parallel(0, RealFft2d::blocksFor(fft.columns()), [&](int block) {
        fft.forwardColumns(spectrum, block * kBlock, std::min(fft.columns(), (block + 1) * kBlock));
    });
}

/// As the image is, not multiplied by the area.
void backwardFft(const RealFft2d& fft, std::complex<float>* spectrum, float* image, JobContext& context) {
    const int height = fft.size().height;
    const float scale = 1 / static_cast<float>(fft.size().area());
    context.parallel(0, RealFft2d::blocksFor(fft.columns()), [&](int block) {
        const int first = block * kBlock, last = std::min(fft.columns(), first + kBlock);
        for (int k = first; k < last; ++k)
            for (int y = 0; y < height; ++y)
                spectrum[k * fft.columnStride() + y] *= scale;
        fft.backwardColumns(spectrum, first, last);
    });
    context.parallel(0, RealFft2d::blocksFor(height), [&](int block) {
        fft.backwardRows(spectrum, block * kBlock, std::min(height, (block + 1) * kBlock), image);
    });
}

/// The product as it is written, without the library's care for what is not finite.
std::complex<float> times(std::complex<float> a, std::complex<float> b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

double sum(const std::vector<double>& values) {
    double whole = 0;
    for (const double value : values)
        whole += value;
    return whole;
}

} // namespace

HistogramTerm::HistogramTerm(const PatchSource& exemplar, bool principal, JobContext& context) {
    const auto check = [&context] { context.check(); };
    const Image pixels = chosenPixels(exemplar, check);
    const int channels = pixels.channels();
    m_axes = principal ? covarianceAxes(channelCovariance(pixels, check)).directions.cast<float>().eval()
                       : Eigen::MatrixXf::Identity(channels, channels).eval();
    const Image along = alongAxes(pixels, context);
    for (int c = 0; c < channels; ++c)
        m_wanted.emplace_back(along.view().plane(c), check);
}

Image HistogramTerm::alongAxes(const ImageView& image, JobContext& context) const {
    Image along(image.size(), image.channels);
    context.parallel(0, image.height, [&](int y) {
        for (int a = 0; a < image.channels; ++a) {
            float* to = along.plane(a).row(y);
            for (int c = 0; c < image.channels; ++c) {
                const float share = m_axes(c, a);
                const float* from = image.plane(c).row(y);
                for (int x = 0; x < image.width; ++x)
                    to[x] += share * from[x];
            }
        }
    });
    return along;
}

double HistogramTerm::add(const Image& image, double weight, JobContext& context, Image& gradient) {
    Image along = alongAxes(image, context);
    const int channels = image.channels();
    std::vector<double> changes(at(channels));
    context.parallel(0, channels, [&](int a) {
        SampleRanks ranks;
        changes[at(a)] = m_wanted[at(a)].match(along.plane(a), ranks, [&context] { context.check(); });
    });
    const auto factor = static_cast<float>(weight);
    context.parallel(0, image.height(), [&](int y) {
        std::vector<float> matched(at(image.width()));
        for (int c = 0; c < channels; ++c) {
            std::fill(matched.begin(), matched.end(), 0.0F);
            for (int a = 0; a < channels; ++a)
                for (int x = 0; x < image.width(); ++x)
                    matched[at(x)] += m_axes(c, a) * along(x, y, a);
            for (int x = 0; x < image.width(); ++x)
                gradient(x, y, c) += factor * (image(x, y, c) - matched[at(x)]);
        }
    });
    return sum(changes) * static_cast<double>(image.size().area());
}

std::uint64_t HistogramTerm::bytesFor(Size exemplar, Size output, int channels, int threads) {
    const auto both = static_cast<std::uint64_t>(std::min(threads, channels));
    return 3 * Image::bytesFor(exemplar, channels) + Image::bytesFor(output, channels) +
           both * (SampleRanks::bytesFor(output) + SampleRanks::bytesFor(exemplar));
}

double LowPassTerm::add(const Image& image, double weight, JobContext& context, Image& gradient) const {
    const Box across(image.width(), m_patch, m_wrap.x), down(image.height(), m_patch, m_wrap.y);
    Image difference(image.size(), image.channels());
    Image rows({across.filtered(), image.height()}, image.channels());
    Image smooth({across.filtered(), down.filtered()}, image.channels());
    context.parallel(0, image.height(), [&](int y) {
        for (int c = 0; c < image.channels(); ++c) {
            float* apart = difference.plane(c).row(y);
            std::transform(image.plane(c).row(y), image.plane(c).row(y) + image.width(),
                           m_target.plane(c).row(y), apart, std::minus<>());
            across.forward(apart, 1, rows.plane(c).row(y), 1);
        }
    });
    const int chunks = (across.filtered() + kColumns - 1) / kColumns;
    std::vector<double> energies(at(chunks), 0.0);
    context.parallel(0, chunks, [&](int chunk) {
        for (int c = 0; c < image.channels(); ++c)
            for (int x = chunk * kColumns; x < std::min(across.filtered(), (chunk + 1) * kColumns); ++x) {
                context.check();
                const PlaneSpan from = rows.plane(c), to = smooth.plane(c);
                down.forward(from.data + x, from.stride, to.data + x, to.stride);
                for (int y = 0; y < to.height; ++y)
                    energies[at(chunk)] += static_cast<double>(to(x, y)) * static_cast<double>(to(x, y));
                down.backward(to.data + x, to.stride, from.data + x, from.stride);
            }
    });
    const auto factor = static_cast<float>(weight);
    context.parallel(0, image.height(), [&](int y) {
        for (int c = 0; c < image.channels(); ++c) {
            float* pull = difference.plane(c).row(y);
            across.backward(rows.plane(c).row(y), 1, pull, 1);
            for (int x = 0; x < image.width(); ++x)
                gradient(x, y, c) += factor * pull[x];
        }
    });
    return sum(energies);
}

std::uint64_t LowPassTerm::bytesFor(Size output, int channels, int patch) {
    return Image::bytesFor(output, channels) +
           3 * Image::bytesFor({output.width + patch, output.height + patch}, channels);
}

SpectrumTerm::SpectrumTerm(const ImageView& exemplar, Size size, JobContext& context)
    : m_fft(size), m_image(size, 1) {
    const PhaseSpot spot(exemplar, size, {}, [&context] { context.check(); });
    for (int c = 0; c < exemplar.channels; ++c) {
        for (int y = 0; y < size.height; ++y)
            std::fill_n(m_image.plane(0).row(y), size.width, 0.0F);
        spot.write(c, m_image.plane(0));
        Complex* const wanted = m_wanted.emplace_back(m_fft.spectrumSize()).data();
        forwardFft(m_fft, m_image.plane(0).data, wanted, context);
        wanted[0] = static_cast<float>(spot.mean(c) * static_cast<double>(size.area()));
        m_spectra.emplace_back(m_fft.spectrumSize());
    }
}

/// Ŝ_c(k) = û0_c(k) e^{iφ(k)} with φ(k) = arg Σ_c conj(û0_c(k)) û_c(k). The mean is the exemplar's as it is.
void SpectrumTerm::nearest(int column) {
    const std::ptrdiff_t first = column * m_fft.columnStride();
    for (std::ptrdiff_t i = first; i < first + m_fft.size().height; ++i) {
        Complex like = 0;
        for (std::size_t c = 0; c < m_wanted.size(); ++c)
            like += times(std::conj(m_wanted[c].data()[i]), m_spectra[c].data()[i]);
        const float length = std::abs(like);
        const Complex turn = i > 0 && length > 0 ? like / length : Complex(1, 0);
        for (std::size_t c = 0; c < m_wanted.size(); ++c)
            m_spectra[c].data()[i] = times(m_wanted[c].data()[i], turn);
    }
}

double SpectrumTerm::add(const Image& image, double weight, JobContext& context, Image& gradient) {
    for (int c = 0; c < image.channels(); ++c)
        forwardFft(m_fft, image.plane(c).data, m_spectra[at(c)].data(), context);
    context.parallel(0, m_fft.columns(), [&](int column) { nearest(column); });
    const auto factor = static_cast<float>(weight);
    std::vector<double> energies(at(image.height()), 0.0);
    for (int c = 0; c < image.channels(); ++c) {
        backwardFft(m_fft, m_spectra[at(c)].data(), m_image.plane(0).data, context);
        context.parallel(0, image.height(), [&](int y) {
            for (int x = 0; x < image.width(); ++x) {
                const float pull = image(x, y, c) - m_image(x, y, 0);
                energies[at(y)] += static_cast<double>(pull) * static_cast<double>(pull);
                gradient(x, y, c) += factor * pull;
            }
        });
    }
    return sum(energies);
}

std::uint64_t SpectrumTerm::bytesFor(Size exemplar, Size output, int channels) {
    return PhaseSpot::bytesFor(exemplar, channels) + Image::bytesFor(output, 1) +
           static_cast<std::uint64_t>(channels) * 2 * RealFft2d(output).spectrumSize() * sizeof(Complex);
}

Image randomPhaseOf(const ImageView& exemplar, Size size, Wrap wrap, const Random& random,
                    JobContext& context) {
    const Size torus = PhaseSpot::torusFor(exemplar.size(), size, wrap);
    const PhaseSpot spot(exemplar, torus, {}, [&context] { context.check(); });
    const RealFft2d fft(torus);
    FftBuffer<std::complex<float>> factors(fft.spectrumSize()), spectrum(fft.spectrumSize());
    const RandomPhases phases(PhaseModel::PhaseNoise, torus, random);
    context.parallel(0, fft.columns(),
                     [&](int column) { phases.draw(column, factors.data() + column * fft.columnStride()); });
    Image image(torus, exemplar.channels);
    for (int c = 0; c < exemplar.channels; ++c) {
        spot.write(c, image.plane(c));
        forwardFft(fft, image.plane(c).data, spectrum.data(), context);
        context.parallel(0, fft.columns(), [&](int column) {
            const std::ptrdiff_t first = column * fft.columnStride();
            for (std::ptrdiff_t i = first; i < first + torus.height; ++i)
                spectrum.data()[i] = times(spectrum.data()[i], factors.data()[i]);
        });
        backwardFft(fft, spectrum.data(), image.plane(c).data, context);
        const auto mean = static_cast<float>(spot.mean(c));
        context.parallel(0, torus.height, [&](int y) {
            float* row = image.plane(c).row(y);
            std::transform(row, row + torus.width, row, [mean](float value) { return value + mean; });
        });
    }
    image.shrink(size);
    return image;
}

std::uint64_t randomPhaseBytes(Size exemplar, Size size, Wrap wrap, int channels) {
    const Size torus = PhaseSpot::torusFor(exemplar, size, wrap);
    return PhaseSpot::bytesFor(exemplar, channels) + Image::bytesFor(torus, channels) +
           2 * RealFft2d(torus).spectrumSize() * sizeof(std::complex<float>);
}

} // namespace texloom::sparse

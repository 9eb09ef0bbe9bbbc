#include "core/methods/portilla_simoncelli/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace texloom::portilla_simoncelli {

namespace {

/// Samples of one variable that are gathered at a time, so that all variables stay in the cache.
constexpr int kBlockSamples = 1024;
/// Parts into which covariances are summed, whatever the number of threads.
constexpr int kParts = 64;
/// The coarsest scale goes with each component's low residual and its neighbours on either side.
constexpr int kNeighbours = 5;
constexpr std::array<std::array<int, 2>, kNeighbours> kShifts{{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

using Complex = SteerablePyramid::Complex;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// The factors by which a column of a spectrum goes to a neighbour.
std::vector<Complex> shiftFactors(const SteerablePyramid& pyramid, int column, int neighbour) {
    const int scale = pyramid.scales();
    std::vector<Complex> factors(at(pyramid.size(scale).height));
    for (int row = 0; row < pyramid.size(scale).height; ++row)
        factors[at(row)] = std::polar(
            1.0F, static_cast<float>(kShifts[at(neighbour)][0] * pyramid.frequencyX(scale, column) +
                                     kShifts[at(neighbour)][1] * pyramid.frequencyY(scale, row)));
    return factors;
}

} // namespace

Sweep::Sweep(const SteerablePyramid& pyramid, int components, int joint, const std::vector<int>& reaches,
             const Settings& settings, JobContext& context)
    : m_pyramid(pyramid), m_components(components), m_joint(settings.crossChannel ? joint : 0),
      m_settings(settings), m_context(context), m_check([&context] { context.check(); }) {
    const int scales = pyramid.scales();
    const auto spectra = [&pyramid](int scale, int count) {
        std::vector<Spectrum> made;
        for (int i = 0; i < count; ++i)
            made.emplace_back(pyramid.fft(scale).spectrumSize());
        return made;
    };
    const auto planes = [&pyramid](int count) {
        std::vector<Plane> made;
        for (int i = 0; i < count; ++i)
            made.emplace_back(pyramid.fft(0).imageSize());
        return made;
    };
    for (int scale = 0; scale <= scales; ++scale) {
        m_autocorrelators.emplace_back(pyramid, scale, reaches[at(scale)]);
        m_spectra.push_back(spectra(scale, components));
        m_images.push_back(spectra(scale, components));
        m_bands.push_back(spectra(scale, scale == scales ? 0
                                         : scale > 0     ? bands()
                                                         : std::min(bands(), context.threads())));
    }
    m_high = spectra(0, components);
    m_magnitudes = planes(bands());
    m_reals = planes(bands());
    m_next = planes(std::max(scales > 1 ? 2 * bands() : 0, kNeighbours * components));
    m_planes = planes(components);
    m_means.resize(at(bands()));
    m_nextMeans.resize(at(bands()));
}

std::vector<int> Sweep::reachesFor(Size size, int scales, const Settings& settings) {
    std::vector<int> reaches;
    for (int scale = 0; scale <= scales; ++scale) {
        const int side = (size.shorterSide() + (1 << scale) - 1) >> scale;
        reaches.push_back(std::clamp(side / 4 - 1, 0, settings.reach()));
    }
    return reaches;
}

PlaneSpan Sweep::span(const Plane& plane, int scale) const {
    const Size size = m_pyramid.size(scale);
    return {plane.data(), size.width, size.height, m_pyramid.fft(scale).rowStride()};
}

int Sweep::nextCount(int scale, Kind kind) const {
    if (coarsest(scale))
        return kind == Kind::Reals ? kNeighbours * m_components : 0;
    return kind == Kind::Reals ? 2 * bands() : bands();
}

Sweep::Spectrum& Sweep::bandAt(int scale, int band) {
    std::vector<Spectrum>& spectra = m_bands[at(scale)];
    return spectra[at(band) % spectra.size()];
}

void Sweep::begin() {
    m_measured = {};
    m_measured.whole.resize(at(m_components));
    m_measured.highVariances.resize(at(m_components));
    m_measured.images.resize(at(m_pyramid.scales() + 1), std::vector<ImageStatistics>(at(m_components)));
    m_measured.scales.resize(at(m_pyramid.scales()));
    for (ScaleStatistics& scale : m_measured.scales) {
        scale.magnitudeMeans.resize(at(bands()));
        scale.magnitudeAutocorrelations.resize(at(bands()));
    }
}

Statistics Sweep::run(Image& components, const Statistics* wanted, const Progress& progress) {
    m_wanted = wanted;
    m_progress = &progress;
    begin();
    m_context.parallel(0, m_components, [&](int c) { decompose(components, c); });
    shapeLow();
    m_planeScale = m_pyramid.scales();
    m_context.parallel(0, m_components, [&](int c) { shapeImage(m_pyramid.scales(), c); });
    for (int scale = m_pyramid.scales(); scale-- > 0;)
        shapeScale(scale);
    m_context.parallel(0, m_components, [&](int c) { finish(components, c); });
    return std::move(m_measured);
}

/// Every scale has a quarter of the samples of the finer one.
void Sweep::report(int scale, double share) {
    std::vector<PlaneView> planes;
    for (const Plane& plane : m_planes)
        planes.push_back(span(plane, m_planeScale));
    (*m_progress)(std::pow(0.25, scale + 1) + share * 3 * std::pow(0.25, scale + 1), planes);
}

void Sweep::decompose(const Image& components, int component) {
    const auto spectrum = [&](int scale) { return m_spectra[at(scale)][at(component)].data(); };
    m_pyramid.forward(0, components.view().plane(component).data, spectrum(0), m_check);
    spectrum(0)[0] = 0;
    m_pyramid.takeHigh(spectrum(0), m_high[at(component)].data(), m_check);
    m_pyramid.limit(0, spectrum(0), m_check);
    for (int scale = 0; scale < m_pyramid.scales(); ++scale)
        m_pyramid.lower(scale, spectrum(scale), spectrum(scale + 1), m_check);
}

/// One column of the low residuals' spectra, shifted to each neighbour: real parts, then imaginary parts.
Sweep::Samples Sweep::shiftedLow(int column) const {
    const int scale = m_pyramid.scales(), height = m_pyramid.size(scale).height;
    Samples samples(kNeighbours * m_components, 2 * height);
    for (int j = 0; j < kNeighbours; ++j) {
        const std::vector<Complex> factors = shiftFactors(m_pyramid, column, j);
        for (int c = 0; c < m_components; ++c) {
            const Complex* bins =
                m_spectra[at(scale)][at(c)].data() + column * m_pyramid.fft(scale).columnStride();
            for (int row = 0; row < height; ++row) {
                const Complex value = bins[row] * factors[at(row)];
                samples(kNeighbours * c + j, row) = value.real();
                samples(kNeighbours * c + j, height + row) = value.imag();
            }
        }
    }
    return samples;
}

/// The covariances of the low residuals and their neighbours are set by a linear map; what it makes of each
/// neighbour is shifted back and averaged.
void Sweep::shapeLow() {
    const int scale = m_pyramid.scales(), width = m_pyramid.size(scale).width;
    const int height = m_pyramid.size(scale).height, columns = m_pyramid.fft(scale).columns();
    const std::ptrdiff_t stride = m_pyramid.fft(scale).columnStride();
    Eigen::MatrixXd low = Eigen::MatrixXd::Zero(kNeighbours * m_components, kNeighbours * m_components);
    for (int column = 0; column < columns; ++column) {
        m_check();
        const Eigen::MatrixXd samples = shiftedLow(column).cast<double>();
        low += (column == 0 || 2 * column == width ? 1 : 2) * samples * samples.transpose();
    }
    keepFamilies(low, kNeighbours, kNeighbours);
    m_measured.low = low;
    if (!m_wanted || !m_settings.bandOrientations)
        return;
    const Eigen::MatrixXf map = leastMap(low, m_wanted->low).cast<float>();
    for (int column = 0; column < columns; ++column) {
        m_check();
        const Samples mixed = map * shiftedLow(column);
        for (int c = 0; c < m_components; ++c)
            std::fill_n(m_spectra[at(scale)][at(c)].data() + column * stride, height, Complex(0, 0));
        for (int j = 0; j < kNeighbours; ++j) {
            const std::vector<Complex> factors = shiftFactors(m_pyramid, column, j);
            for (int variable = j; variable < map.rows(); variable += kNeighbours) {
                Complex* bins = m_spectra[at(scale)][at(variable / kNeighbours)].data() + column * stride;
                for (int row = 0; row < height; ++row)
                    bins[row] += Complex(mixed(variable, row), mixed(variable, height + row)) *
                                 std::conj(factors[at(row)]) / static_cast<float>(kNeighbours);
            }
        }
    }
}

void Sweep::shapeScale(int scale) {
    m_context.parallel(0, bands(), [&](int band) { splitBand(scale, band); });
    report(scale, 0.2);
    if (coarsest(scale))
        m_context.parallel(0, m_components, [&](int c) { splitLow(scale, c); });
    else
        m_context.parallel(0, bands(), [&](int band) { splitNext(scale, band); });
    report(scale, 0.4);
    relate(scale, Kind::Magnitudes);
    m_context.parallel(0, bands(), [&](int band) { shapeMagnitude(scale, band); });
    report(scale, 0.6);
    relate(scale, Kind::Reals);
    report(scale, 0.8);
    collect(scale);
    m_planeScale = scale;
    m_context.parallel(0, m_components, [&](int c) { shapeImage(scale, c); });
    report(scale, 1);
}

void Sweep::splitBand(int scale, int band) {
    const int component = band / m_pyramid.orientations(), orientation = band % m_pyramid.orientations();
    const ComplexFft2d& fft = m_pyramid.complexFft(scale);
    const FftBuffer<Complex> image(fft.imageSize());
    m_pyramid.analyticBand(scale, orientation, m_spectra[at(scale)][at(component)].data(), image.data(),
                           m_check);
    const PlaneSpan magnitude = span(m_magnitudes[at(band)], scale), cosine = span(m_reals[at(band)], scale);
    double sum = 0;
    for (int y = 0; y < magnitude.height; ++y) {
        const Complex* values = image.data() + y * fft.rowStride();
        float *lengths = magnitude.row(y), *cosines = cosine.row(y);
        for (int x = 0; x < magnitude.width; ++x) {
            const float re = values[x].real(), im = values[x].imag();
            lengths[x] = std::sqrt(re * re + im * im);
            cosines[x] = lengths[x] > 0 ? re / lengths[x] : 0.0F;
        }
        for (int x = 0; x < magnitude.width; ++x)
            sum += static_cast<double>(lengths[x]);
    }
    m_means[at(band)] = sum / static_cast<double>(m_pyramid.size(scale).area());
    measuredAt(scale).magnitudeMeans[at(band)] = m_means[at(band)];
}

/// Interpolates a band of the next scale and doubles its phase, so that it turns as fast as this scale's.
void Sweep::splitNext(int scale, int band) {
    const ComplexFft2d& fft = m_pyramid.complexFft(scale);
    const FftBuffer<Complex> image(fft.imageSize());
    m_pyramid.analyticRaised(scale, band % m_pyramid.orientations(), bandAt(scale + 1, band).data(),
                             image.data(), m_check);
    const PlaneSpan first = span(m_next[at(2 * band)], scale), second = span(m_next[at(2 * band + 1)], scale);
    double sum = 0;
    for (int y = 0; y < first.height; ++y) {
        const Complex* values = image.data() + y * fft.rowStride();
        float *even = first.row(y), *odd = second.row(y);
        for (int x = 0; x < first.width; ++x) {
            const float re = values[x].real(), im = values[x].imag();
            const float length = std::sqrt(re * re + im * im);
            const float inverse = length > 0 ? 1 / length : 0.0F;
            even[x] = (re * re - im * im) * inverse;
            odd[x] = 2 * re * im * inverse;
            sum += static_cast<double>(length);
        }
    }
    m_nextMeans[at(band)] = sum / static_cast<double>(m_pyramid.size(scale).area());
}

void Sweep::splitLow(int scale, int component) {
    const int last = m_pyramid.scales();
    const Spectrum shifted = m_pyramid.spectrum(last);
    for (int j = 0; j < kNeighbours; ++j) {
        const Spectrum raised = m_pyramid.spectrum(scale);
        for (int column = 0; column < m_pyramid.fft(last).columns(); ++column) {
            m_check();
            const std::ptrdiff_t offset = column * m_pyramid.fft(last).columnStride();
            const std::vector<Complex> factors = shiftFactors(m_pyramid, column, j);
            const Complex* bins = m_spectra[at(last)][at(component)].data() + offset;
            for (int row = 0; row < m_pyramid.size(last).height; ++row)
                shifted.data()[offset + row] = bins[row] * factors[at(row)];
        }
        m_pyramid.raise(scale, shifted.data(), raised.data(), m_check);
        m_pyramid.backward(scale, raised.data(), m_next[at(kNeighbours * component + j)].data(), m_check);
    }
}

int Sweep::blockCount(int scale) const {
    const Size size = m_pyramid.size(scale);
    const int rows = std::max(1, kBlockSamples / size.width);
    return (size.height + rows - 1) / rows * ((size.width + kBlockSamples - 1) / kBlockSamples);
}

Sweep::Block Sweep::block(int scale, int index) const {
    const Size size = m_pyramid.size(scale);
    const int rows = std::max(1, kBlockSamples / size.width);
    const int across = (size.width + kBlockSamples - 1) / kBlockSamples;
    const int left = index % across * kBlockSamples, top = index / across * rows;
    return {left, top, std::min(size.width, left + kBlockSamples), std::min(size.height, top + rows)};
}

/// One row of `samples` for each variable of this scale, then for each of the next; magnitudes without mean.
void Sweep::gather(int scale, Kind kind, const Block& block, Samples& samples) const {
    const int width = block.right - block.left, next = nextCount(scale, kind);
    samples.resize(bands() + next, static_cast<Eigen::Index>(width) * (block.bottom - block.top));
    for (int y = block.top; y < block.bottom; ++y) {
        const Eigen::Index column = static_cast<Eigen::Index>(width) * (y - block.top);
        for (int band = 0; band < bands(); ++band) {
            const bool magnitudes = kind == Kind::Magnitudes;
            const float* from =
                span((magnitudes ? m_magnitudes : m_reals)[at(band)], scale).row(y) + block.left;
            const float mean = magnitudes ? static_cast<float>(m_means[at(band)]) : 0.0F;
            float* to = &samples(band, column);
            for (int x = 0; x < width; ++x)
                to[x] = from[x] - mean;
        }
        for (int i = 0; i < next; ++i) {
            float* to = &samples(bands() + i, column);
            if (kind == Kind::Reals) {
                std::copy_n(span(m_next[at(i)], scale).row(y) + block.left, width, to);
                continue;
            }
            const float* even = span(m_next[at(2 * i)], scale).row(y) + block.left;
            const float* odd = span(m_next[at(2 * i + 1)], scale).row(y) + block.left;
            const auto mean = static_cast<float>(m_nextMeans[at(i)]);
            for (int x = 0; x < width; ++x)
                to[x] = std::sqrt(even[x] * even[x] + odd[x] * odd[x]) - mean;
        }
    }
}

Eigen::MatrixXd Sweep::covariance(int scale, Kind kind) const {
    const int count = bands() + nextCount(scale, kind), blocks = blockCount(scale);
    const int parts = std::min(kParts, blocks);
    std::vector<Eigen::MatrixXd> sums(at(parts), Eigen::MatrixXd::Zero(count, count));
    m_context.parallel(0, parts, [&](int part) {
        Samples samples;
        Eigen::MatrixXf sum(count, count);
        const auto first = static_cast<int>(static_cast<std::int64_t>(part) * blocks / parts);
        const auto last = static_cast<int>(static_cast<std::int64_t>(part + 1) * blocks / parts);
        for (int index = first; index < last; ++index) {
            m_check();
            gather(scale, kind, block(scale, index), samples);
            sum.setZero();
            sum.selfadjointView<Eigen::Lower>().rankUpdate(samples);
            sums[at(part)] += sum.cast<double>();
        }
    });
    Eigen::MatrixXd total = Eigen::MatrixXd::Zero(count, count);
    for (const Eigen::MatrixXd& sum : sums)
        total += sum;
    total /= static_cast<double>(m_pyramid.size(scale).area());
    return total.selfadjointView<Eigen::Lower>();
}

/// Forgets what relates components that have no statistics in common.
void Sweep::keepFamilies(Eigen::MatrixXd& matrix, int rowsEach, int columnsEach) const {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
            const Eigen::Index a = i / rowsEach, b = j / columnsEach;
            if (a != b && (a >= m_joint || b >= m_joint))
                matrix(i, j) = 0;
        }
}

/// Measures how a scale's variables go together and with the next scale's, and mixes them as wanted.
void Sweep::relate(int scale, Kind kind) {
    const bool magnitudes = kind == Kind::Magnitudes;
    const int next = nextCount(scale, kind), each = m_pyramid.orientations(), nextEach = next / m_components;
    const Eigen::MatrixXd whole = covariance(scale, kind);
    Eigen::MatrixXd own = whole.topLeftCorner(bands(), bands());
    Eigen::MatrixXd cross = whole.topRightCorner(bands(), next);
    Eigen::MatrixXd other = whole.bottomRightCorner(next, next);
    keepFamilies(own, each, each);
    if (next > 0) {
        keepFamilies(cross, each, nextEach);
        keepFamilies(other, nextEach, nextEach);
    }
    if (m_wanted) {
        const bool alone = magnitudes ? m_settings.magnitudeOrientations : m_settings.bandOrientations;
        const bool across = (magnitudes ? m_settings.magnitudeScales : m_settings.phases) && next > 0;
        const ScaleStatistics& wanted = wantedAt(scale);
        const Eigen::MatrixXd& wantedOwn = !alone ? own : magnitudes ? wanted.magnitudes : wanted.reals;
        Mixing mixing;
        if (across)
            mixing =
                mixingTo(own, cross, other, wantedOwn, magnitudes ? wanted.magnitudesNext : wanted.realsNext);
        else if (alone)
            mixing.own = leastMap(own, wantedOwn);
        if (across || alone)
            mix(scale, kind, mixing);
    }
    ScaleStatistics& measured = measuredAt(scale);
    (magnitudes ? measured.magnitudes : measured.reals) = own;
    (magnitudes ? measured.magnitudesNext : measured.realsNext) = cross;
    (magnitudes ? measured.nextMagnitudes : measured.nextReals) = other;
}

void Sweep::mix(int scale, Kind kind, const Mixing& mixing) {
    Eigen::MatrixXf map = Eigen::MatrixXf::Zero(bands(), bands() + nextCount(scale, kind));
    map.leftCols(bands()) = mixing.own.cast<float>();
    if (mixing.other.size() > 0)
        map.rightCols(mixing.other.cols()) = mixing.other.cast<float>();
    const int blocks = blockCount(scale), parts = std::min(kParts, blocks);
    m_context.parallel(0, parts, [&](int part) {
        Samples samples, mixed;
        const auto first = static_cast<int>(static_cast<std::int64_t>(part) * blocks / parts);
        const auto last = static_cast<int>(static_cast<std::int64_t>(part + 1) * blocks / parts);
        for (int index = first; index < last; ++index) {
            m_check();
            const Block here = block(scale, index);
            gather(scale, kind, here, samples);
            mixed.noalias() = map * samples;
            const int width = here.right - here.left;
            for (int band = 0; band < bands(); ++band) {
                const bool magnitudes = kind == Kind::Magnitudes;
                const PlaneSpan to = span((magnitudes ? m_magnitudes : m_reals)[at(band)], scale);
                const float mean = magnitudes ? static_cast<float>(m_means[at(band)]) : 0.0F;
                for (int y = here.top; y < here.bottom; ++y) {
                    const float* from = &mixed(band, static_cast<Eigen::Index>(width) * (y - here.top));
                    float* row = to.row(y) + here.left;
                    for (int x = 0; x < width; ++x)
                        row[x] = from[x] + mean;
                }
            }
        }
    });
}

/// Sets a magnitude's autocorrelation and mean, and makes the real band of it and the phase.
void Sweep::shapeMagnitude(int scale, int band) {
    const Autocorrelator& autocorrelator = m_autocorrelators[at(scale)];
    const Spectrum spectrum(m_pyramid.fft(scale).spectrumSize());
    const PlaneSpan magnitude = span(m_magnitudes[at(band)], scale);
    m_pyramid.forward(scale, magnitude.data, spectrum.data(), m_check);
    spectrum.data()[0] = 0;
    const Eigen::MatrixXd lags = autocorrelator.measure(spectrum.data(), m_check);
    measuredAt(scale).magnitudeAutocorrelations[at(band)] =
        Autocorrelator::central(lags, autocorrelator.reach());
    float mean = 0;
    if (m_wanted && m_settings.magnitudeAutocorrelation) {
        autocorrelator.impose(lags, wantedAt(scale).magnitudeAutocorrelations[at(band)], spectrum.data(),
                              m_check);
        m_pyramid.backward(scale, spectrum.data(), magnitude.data, m_check);
        mean = static_cast<float>(wantedAt(scale).magnitudeMeans[at(band)]);
    }
    const PlaneSpan real = span(m_reals[at(band)], scale);
    for (int y = 0; y < real.height; ++y) {
        const float* lengths = magnitude.row(y);
        float* values = real.row(y);
        for (int x = 0; x < real.width; ++x)
            values[x] *= std::max(0.0F, lengths[x] + mean);
    }
}

/// Transforms the real bands and adds them to the low-pass image of the next scale, a few at a time and in
/// their order. When statistics are only measured, the bands are there in the spectrum already.
void Sweep::collect(int scale) {
    const int orientations = m_pyramid.orientations();
    if (!m_wanted) {
        m_context.parallel(0, m_components, [&](int c) {
            const Spectrum &from = m_spectra[at(scale)][at(c)], &image = m_images[at(scale)][at(c)];
            for (int k = 0; k < orientations && scale > 0; ++k)
                m_pyramid.takeBand(scale, k, from.data(), bandAt(scale, c * orientations + k).data(),
                                   m_check);
            std::copy_n(from.data(), from.size(), image.data());
            m_pyramid.limit(scale, image.data(), m_check);
        });
        return;
    }
    m_context.parallel(0, m_components, [&](int c) {
        std::fill_n(m_images[at(scale)][at(c)].data(), m_images[at(scale)][at(c)].size(), Complex(0, 0));
    });
    const auto together = static_cast<int>(m_bands[at(scale)].size());
    for (int first = 0; first < bands(); first += together) {
        const int last = std::min(bands(), first + together);
        m_context.parallel(first, last, [&](int band) {
            m_pyramid.forward(scale, m_reals[at(band)].data(), bandAt(scale, band).data(), m_check);
        });
        m_context.parallel(0, m_components, [&](int c) {
            for (int k = 0; k < orientations; ++k)
                if (const int band = c * orientations + k; band >= first && band < last)
                    m_pyramid.addBand(scale, k, bandAt(scale, band).data(), m_images[at(scale)][at(c)].data(),
                                      m_check);
        });
    }
    m_context.parallel(0, m_components, [&](int c) {
        m_pyramid.limit(scale, m_images[at(scale)][at(c)].data(), m_check);
        m_pyramid.raise(scale, m_images[at(scale + 1)][at(c)].data(), m_images[at(scale)][at(c)].data(),
                        m_check);
    });
}

void Sweep::shapeImage(int scale, int component) {
    Complex* spectrum = m_images[at(scale)][at(component)].data();
    if (scale == m_pyramid.scales()) {
        const Spectrum& low = m_spectra[at(scale)][at(component)];
        std::copy_n(low.data(), low.size(), spectrum);
        m_pyramid.limit(scale, spectrum, m_check);
    }
    const Autocorrelator& autocorrelator = m_autocorrelators[at(scale)];
    const ImageStatistics* wanted = m_wanted ? &m_wanted->images[at(scale)][at(component)] : nullptr;
    ImageStatistics& measured = m_measured.images[at(scale)][at(component)];
    const Eigen::MatrixXd lags = autocorrelator.measure(spectrum, m_check);
    measured.autocorrelation = Autocorrelator::central(lags, autocorrelator.reach());
    const bool clear = wanted && wanted->variance() > kLeastVariance;
    if (wanted && m_settings.autocorrelation)
        autocorrelator.impose(lags, wanted->autocorrelation, spectrum, m_check);
    const PlaneSpan plane = span(m_planes[at(component)], scale);
    m_pyramid.backward(scale, spectrum, plane.data, m_check);
    const Moments moments = momentsOf(plane, m_check);
    measured.skewness = moments.skewness;
    measured.kurtosis = moments.kurtosis;
    if (clear && m_settings.marginals) {
        Moments shape = moments;
        shape.skewness = wanted->skewness;
        shape.kurtosis = wanted->kurtosis;
        shape.smallest = -std::numeric_limits<double>::infinity();
        shape.largest = std::numeric_limits<double>::infinity();
        imposeMoments(plane, moments, shape, m_check);
    }
    m_pyramid.forward(scale, plane.data, spectrum, m_check);
}

/// Adds the high residual, whose variance is lowered if it is too large.
void Sweep::finish(Image& components, int component) {
    const Autocorrelator& autocorrelator = m_autocorrelators.front();
    Complex* spectrum = m_images.front()[at(component)].data();
    const Spectrum& high = m_high[at(component)];
    const double variance = autocorrelator.power(high.data(), m_check);
    m_measured.highVariances[at(component)] = variance;
    if (m_wanted && m_settings.autocorrelation && variance > m_wanted->highVariances[at(component)]) {
        const auto factor = static_cast<float>(std::sqrt(m_wanted->highVariances[at(component)] / variance));
        for (int column = 0; column < m_pyramid.fft(0).columns(); ++column) {
            m_check();
            Complex* bins = high.data() + column * m_pyramid.fft(0).columnStride();
            std::transform(bins, bins + m_pyramid.size(0).height, bins,
                           [factor](Complex bin) { return factor * bin; });
        }
    }
    m_pyramid.addHigh(high.data(), spectrum, m_check);
    const Eigen::MatrixXd lags = autocorrelator.measure(spectrum, m_check);
    m_measured.whole[at(component)].autocorrelation = Autocorrelator::central(lags, autocorrelator.reach());
    if (!m_wanted)
        return;
    if (m_settings.autocorrelation)
        autocorrelator.impose(lags, m_wanted->whole[at(component)].autocorrelation, spectrum, m_check);
    m_pyramid.backward(0, spectrum, components.plane(component).data, m_check);
}

std::uint64_t Sweep::bytesFor(Size size, int scales, int components, const Settings& settings, int threads) {
    const auto channels = static_cast<std::uint64_t>(components);
    const std::uint64_t bands = channels * static_cast<std::uint64_t>(settings.orientations);
    const std::uint64_t plane = RealFft2d(size).imageSize() * sizeof(float);
    const std::uint64_t spectrum = RealFft2d(size).spectrumSize() * sizeof(Complex);
    const std::uint64_t together = std::min<std::uint64_t>(bands, static_cast<std::uint64_t>(threads));
    const std::uint64_t next = std::max<std::uint64_t>(scales > 1 ? 2 * bands : 0,
                                                       static_cast<std::uint64_t>(kNeighbours) * channels);
    // Each thread transforms one complex band.
    const std::uint64_t held = plane * (2 * bands + next + channels) +
                               spectrum * (channels + 2 * channels * 4 / 3 + bands / 3 + 3 + together);
    const std::uint64_t each = 5 * spectrum;
    // A tenth for what the allocator keeps back.
    return (held + static_cast<std::uint64_t>(threads) * each) * 11 / 10 + (std::uint64_t{16} << 20);
}

} // namespace texloom::portilla_simoncelli

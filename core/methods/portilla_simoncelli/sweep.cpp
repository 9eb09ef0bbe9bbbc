#include "core/methods/portilla_simoncelli/sweep.h"

#include "core/base/at.h"
#include "core/methods/portilla_simoncelli/low_residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom::portilla_simoncelli {

namespace {

using Complex = SteerablePyramid::Complex;

} // namespace

Sweep::Sweep(const SteerablePyramid& pyramid, int components, int joint, const std::vector<int>& reaches,
             const Settings& settings, JobContext& context)
    : m_pyramid(pyramid), m_components(components), m_joint(settings.crossChannel ? joint : 0),
      m_settings(settings), m_context(context), m_check([&context] { context.check(); }),
      m_variables(pyramid, components, context) {
    const int scales = pyramid.scales();
    const auto spectra = [&pyramid](int scale, int count) {
        std::vector<Spectrum> made;
        for (int i = 0; i < count; ++i)
            made.emplace_back(pyramid.fft(scale).spectrumSize());
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
    for (int i = 0; i < components; ++i)
        m_planes.emplace_back(pyramid.fft(0).imageSize());
}

std::vector<int> Sweep::reachesFor(Size size, int scales, const Settings& settings) {
    std::vector<int> reaches;
    for (int scale = 0; scale <= scales; ++scale) {
        const int side = (size.shorterSide() + (1 << scale) - 1) >> scale;
        reaches.push_back(std::clamp(side / 4 - 1, 0, settings.reach()));
    }
    return reaches;
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
        planes.push_back(spanOf(m_pyramid, m_planeScale, plane));
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

void Sweep::shapeLow() {
    const std::vector<Spectrum>& low = m_spectra[at(m_pyramid.scales())];
    m_measured.low = lowCovariance(m_pyramid, low, m_check);
    keepFamilies(m_measured.low, kNeighbours, kNeighbours);
    if (m_wanted && m_settings.bandOrientations)
        mixLow(m_pyramid, leastMap(m_measured.low, m_wanted->low).cast<float>(), low, m_check);
}

void Sweep::shapeScale(int scale) {
    const auto component = [&](int band) { return at(band / m_pyramid.orientations()); };
    m_context.parallel(0, bands(), [&](int band) {
        measuredAt(scale).magnitudeMeans[at(band)] =
            m_variables.split(scale, band, m_spectra[at(scale)][component(band)]);
    });
    report(scale, 0.2);
    if (coarsest(scale))
        m_context.parallel(0, m_components,
                           [&](int c) { m_variables.splitLow(scale, c, m_spectra[at(scale + 1)][at(c)]); });
    else
        m_context.parallel(0, bands(),
                           [&](int band) { m_variables.splitNext(scale, band, bandAt(scale + 1, band)); });
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

/// Discards the covariances of components that have no statistics in common.
void Sweep::keepFamilies(Eigen::MatrixXd& matrix, int rowsEach, int columnsEach) const {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
            const Eigen::Index a = i / rowsEach, b = j / columnsEach;
            if (a != b && (a >= m_joint || b >= m_joint))
                matrix(i, j) = 0;
        }
}

/// Measures the covariances of a scale's variables, also with the next scale's, and mixes them as wanted.
void Sweep::relate(int scale, Kind kind) {
    const bool magnitudes = kind == Kind::Magnitudes;
    const int next = m_variables.nextCount(scale, kind), each = m_pyramid.orientations(),
              nextEach = next / m_components;
    const Eigen::MatrixXd whole = m_variables.covariance(scale, kind);
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
            m_variables.mix(scale, kind, mixing);
    }
    ScaleStatistics& measured = measuredAt(scale);
    (magnitudes ? measured.magnitudes : measured.reals) = own;
    (magnitudes ? measured.magnitudesNext : measured.realsNext) = cross;
    (magnitudes ? measured.nextMagnitudes : measured.nextReals) = other;
}

/// Sets a magnitude's autocorrelation and mean, and makes the real band of it and the phase.
void Sweep::shapeMagnitude(int scale, int band) {
    const Autocorrelator& autocorrelator = m_autocorrelators[at(scale)];
    const Spectrum spectrum(m_pyramid.fft(scale).spectrumSize());
    const PlaneSpan magnitude = m_variables.magnitude(scale, band);
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
    const PlaneSpan real = m_variables.real(scale, band);
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
            m_pyramid.forward(scale, m_variables.real(scale, band).data, bandAt(scale, band).data(), m_check);
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
    const PlaneSpan plane = spanOf(m_pyramid, scale, m_planes[at(component)]);
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
    // Each thread transforms one complex band.
    const std::uint64_t held = ScaleVariables::bytesFor(plane, scales, components, settings.orientations) +
                               plane * channels +
                               spectrum * (channels + 2 * channels * 4 / 3 + bands / 3 + 3 + together);
    const std::uint64_t each = 5 * spectrum;
    // A tenth for the allocator's overhead.
    return (held + static_cast<std::uint64_t>(threads) * each) * 11 / 10 + (std::uint64_t{16} << 20);
}

} // namespace texloom::portilla_simoncelli

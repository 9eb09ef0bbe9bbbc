#include "core/methods/portilla_simoncelli/scale_variables.h"

#include "core/base/at.h"
#include "core/methods/portilla_simoncelli/low_residuals.h"

#include <algorithm>
#include <cmath>

namespace texloom::portilla_simoncelli {

namespace {

/// Samples of one variable that are gathered at a time, so that all variables stay in the cache.
constexpr int kBlockSamples = 1024;
/// Parts into which covariances are summed, whatever the number of threads.
constexpr int kParts = 64;

/// Planes of the next scale's variables: two for each band where there is a next scale with bands.
int nextPlanes(int scales, int components, int orientations) {
    return std::max(scales > 1 ? 2 * components * orientations : 0, kNeighbours * components);
}

} // namespace

PlaneSpan spanOf(const SteerablePyramid& pyramid, int scale, const FftBuffer<float>& buffer) {
    const Size size = pyramid.size(scale);
    return {buffer.data(), size.width, size.height, pyramid.fft(scale).rowStride()};
}

ScaleVariables::ScaleVariables(const SteerablePyramid& pyramid, int components, JobContext& context)
    : m_pyramid(pyramid), m_components(components), m_context(context),
      m_check([&context] { context.check(); }), m_means(at(bands())), m_nextMeans(at(bands())) {
    const auto planes = [&pyramid](int count) {
        std::vector<Plane> made;
        for (int i = 0; i < count; ++i)
            made.emplace_back(pyramid.fft(0).imageSize());
        return made;
    };
    m_magnitudes = planes(bands());
    m_reals = planes(bands());
    m_next = planes(nextPlanes(pyramid.scales(), components, pyramid.orientations()));
}

int ScaleVariables::nextCount(int scale, Kind kind) const {
    if (coarsest(scale))
        return kind == Kind::Reals ? kNeighbours * m_components : 0;
    return kind == Kind::Reals ? 2 * bands() : bands();
}

PlaneSpan ScaleVariables::magnitude(int scale, int band) const {
    return spanOf(m_pyramid, scale, m_magnitudes[at(band)]);
}

PlaneSpan ScaleVariables::real(int scale, int band) const {
    return spanOf(m_pyramid, scale, m_reals[at(band)]);
}

double ScaleVariables::split(int scale, int band, const Spectrum& component) {
    const ComplexFft2d& fft = m_pyramid.complexFft(scale);
    const FftBuffer<Complex> image(fft.imageSize());
    m_pyramid.analyticBand(scale, band % m_pyramid.orientations(), component.data(), image.data(), m_check);
    const PlaneSpan magnitudes = magnitude(scale, band), cosines = real(scale, band);
    double sum = 0;
    for (int y = 0; y < magnitudes.height; ++y) {
        const Complex* values = image.data() + y * fft.rowStride();
        float *length = magnitudes.row(y), *cosine = cosines.row(y);
        for (int x = 0; x < magnitudes.width; ++x) {
            const float re = values[x].real(), im = values[x].imag();
            length[x] = std::sqrt(re * re + im * im);
            cosine[x] = length[x] > 0 ? re / length[x] : 0.0F;
        }
        for (int x = 0; x < magnitudes.width; ++x)
            sum += static_cast<double>(length[x]);
    }
    m_means[at(band)] = sum / static_cast<double>(m_pyramid.size(scale).area());
    return m_means[at(band)];
}

void ScaleVariables::splitNext(int scale, int band, const Spectrum& next) {
    const ComplexFft2d& fft = m_pyramid.complexFft(scale);
    const FftBuffer<Complex> image(fft.imageSize());
    m_pyramid.analyticRaised(scale, band % m_pyramid.orientations(), next.data(), image.data(), m_check);
    const PlaneSpan first = spanOf(m_pyramid, scale, m_next[at(2 * band)]);
    const PlaneSpan second = spanOf(m_pyramid, scale, m_next[at(2 * band + 1)]);
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

void ScaleVariables::splitLow(int scale, int component, const Spectrum& low) {
    for (int j = 0; j < kNeighbours; ++j) {
        const Spectrum shifted = shiftedLow(m_pyramid, low, j, m_check), raised = m_pyramid.spectrum(scale);
        m_pyramid.raise(scale, shifted.data(), raised.data(), m_check);
        m_pyramid.backward(scale, raised.data(), m_next[at(kNeighbours * component + j)].data(), m_check);
    }
}

int ScaleVariables::blockCount(int scale) const {
    const Size size = m_pyramid.size(scale);
    const int rows = std::max(1, kBlockSamples / size.width);
    return (size.height + rows - 1) / rows * ((size.width + kBlockSamples - 1) / kBlockSamples);
}

ScaleVariables::Block ScaleVariables::block(int scale, int index) const {
    const Size size = m_pyramid.size(scale);
    const int rows = std::max(1, kBlockSamples / size.width);
    const int across = (size.width + kBlockSamples - 1) / kBlockSamples;
    const int left = index % across * kBlockSamples, top = index / across * rows;
    return {left, top, std::min(size.width, left + kBlockSamples), std::min(size.height, top + rows)};
}

void ScaleVariables::overBlocks(int scale, int part, int parts,
                                const std::function<void(const Block&)>& body) const {
    const int blocks = blockCount(scale);
    const auto first = static_cast<int>(static_cast<std::int64_t>(part) * blocks / parts);
    const auto last = static_cast<int>(static_cast<std::int64_t>(part + 1) * blocks / parts);
    for (int index = first; index < last; ++index) {
        m_check();
        body(block(scale, index));
    }
}

float ScaleVariables::meanOf(Kind kind, int band) const {
    return kind == Kind::Magnitudes ? static_cast<float>(m_means[at(band)]) : 0.0F;
}

const ScaleVariables::Plane& ScaleVariables::plane(Kind kind, int band) const {
    return (kind == Kind::Magnitudes ? m_magnitudes : m_reals)[at(band)];
}

/// One row of `samples` for each variable of this scale, then for each of the next; magnitudes without mean.
void ScaleVariables::gather(int scale, Kind kind, const Block& block, Samples& samples) const {
    const int width = block.right - block.left;
    samples.resize(bands() + nextCount(scale, kind),
                   static_cast<Eigen::Index>(width) * (block.bottom - block.top));
    for (int y = block.top; y < block.bottom; ++y) {
        for (int band = 0; band < bands(); ++band) {
            const float* from = spanOf(m_pyramid, scale, plane(kind, band)).row(y) + block.left;
            const float mean = meanOf(kind, band);
            float* to = &samples(band, static_cast<Eigen::Index>(width) * (y - block.top));
            for (int x = 0; x < width; ++x)
                to[x] = from[x] - mean;
        }
        gatherNext(scale, kind, block, y, samples);
    }
}

void ScaleVariables::gatherNext(int scale, Kind kind, const Block& block, int y, Samples& samples) const {
    const int width = block.right - block.left;
    const auto row = [&](int plane) {
        return spanOf(m_pyramid, scale, m_next[at(plane)]).row(y) + block.left;
    };
    for (int i = 0; i < nextCount(scale, kind); ++i) {
        float* to = &samples(bands() + i, static_cast<Eigen::Index>(width) * (y - block.top));
        if (kind == Kind::Reals) {
            std::copy_n(row(i), width, to);
            continue;
        }
        const float *even = row(2 * i), *odd = row(2 * i + 1);
        const auto mean = static_cast<float>(m_nextMeans[at(i)]);
        for (int x = 0; x < width; ++x)
            to[x] = std::sqrt(even[x] * even[x] + odd[x] * odd[x]) - mean;
    }
}

/// The inverse for this scale's variables.
void ScaleVariables::scatter(int scale, Kind kind, const Block& block, const Samples& samples) {
    const int width = block.right - block.left;
    for (int band = 0; band < bands(); ++band) {
        const PlaneSpan to = spanOf(m_pyramid, scale, plane(kind, band));
        const float mean = meanOf(kind, band);
        for (int y = block.top; y < block.bottom; ++y) {
            const float* from = &samples(band, static_cast<Eigen::Index>(width) * (y - block.top));
            float* row = to.row(y) + block.left;
            for (int x = 0; x < width; ++x)
                row[x] = from[x] + mean;
        }
    }
}

Eigen::MatrixXd ScaleVariables::covariance(int scale, Kind kind) const {
    const int count = bands() + nextCount(scale, kind), parts = std::min(kParts, blockCount(scale));
    std::vector<Eigen::MatrixXd> sums(at(parts), Eigen::MatrixXd::Zero(count, count));
    m_context.parallel(0, parts, [&](int part) {
        Samples samples;
        Eigen::MatrixXf sum(count, count);
        overBlocks(scale, part, parts, [&](const Block& block) {
            gather(scale, kind, block, samples);
            sum.setZero();
            sum.selfadjointView<Eigen::Lower>().rankUpdate(samples);
            sums[at(part)] += sum.cast<double>();
        });
    });
    Eigen::MatrixXd total = Eigen::MatrixXd::Zero(count, count);
    for (const Eigen::MatrixXd& sum : sums)
        total += sum;
    total /= static_cast<double>(m_pyramid.size(scale).area());
    return total.selfadjointView<Eigen::Lower>();
}

void ScaleVariables::mix(int scale, Kind kind, const Mixing& mixing) {
    Eigen::MatrixXf map = Eigen::MatrixXf::Zero(bands(), bands() + nextCount(scale, kind));
    map.leftCols(bands()) = mixing.own.cast<float>();
    if (mixing.other.size() > 0)
        map.rightCols(mixing.other.cols()) = mixing.other.cast<float>();
    const int parts = std::min(kParts, blockCount(scale));
    m_context.parallel(0, parts, [&](int part) {
        Samples samples, mixed;
        overBlocks(scale, part, parts, [&](const Block& block) {
            gather(scale, kind, block, samples);
            mixed.noalias() = map * samples;
            scatter(scale, kind, block, mixed);
        });
    });
}

std::uint64_t ScaleVariables::bytesFor(std::uint64_t plane, int scales, int components, int orientations) {
    return plane * static_cast<std::uint64_t>(2 * components * orientations +
                                              nextPlanes(scales, components, orientations));
}

} // namespace texloom::portilla_simoncelli

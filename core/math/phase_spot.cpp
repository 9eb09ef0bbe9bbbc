#include "core/math/phase_spot.h"

#include "core/math/periodic_component.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

/// 1 inside, falling to 0 along half a cosine over `share` of the length at either end.
std::vector<float> fading(int length, double share) {
    std::vector<float> weights(static_cast<std::size_t>(length), 1.0F);
    const double width = share * length;
    for (int i = 0; i < length; ++i) {
        const double depth = std::min(i, length - 1 - i) + 0.5;
        if (depth < width)
            weights[static_cast<std::size_t>(i)] =
                static_cast<float>(0.5 - 0.5 * std::cos(std::numbers::pi * depth / width));
    }
    return weights;
}

double sumOfSquares(const PlaneView& plane) {
    double sum = 0;
    for (int y = 0; y < plane.height; ++y) {
        const float* row = plane.row(y);
        for (int x = 0; x < plane.width; ++x)
            sum += static_cast<double>(row[x]) * static_cast<double>(row[x]);
    }
    return sum;
}

} // namespace

Size PhaseSpot::torusFor(Size exemplar, Size output, Wrap wrap) {
    return {wrap.x ? output.width : std::max(output.width, exemplar.width),
            wrap.y ? output.height : std::max(output.height, exemplar.height)};
}

PhaseSpot::PhaseSpot(const ImageView& exemplar, Size torus, const SpotOptions& options,
                     const std::function<void()>& check)
    : m_values(options.periodic ? periodicComponent(exemplar, check) : Image(exemplar)), m_torus(torus),
      m_means(channelMeans(exemplar, check)) {
    for (int c = 0; c < m_values.channels(); ++c) {
        check();
        const PlaneSpan plane = m_values.plane(c);
        for (int y = 0; y < plane.height; ++y)
            for (int x = 0; x < plane.width; ++x)
                plane(x, y) = static_cast<float>(static_cast<double>(plane(x, y)) - mean(c));
        m_variance += sumOfSquares(plane) / static_cast<double>(m_values.size().area());
    }
    if (torus == exemplar.size())
        return;
    fade(exemplar, options.transition);
    scaleToVariance(check);
}

void PhaseSpot::fade(const ImageView& exemplar, double share) {
    const auto weightsFor = [share](int length, int torusLength) {
        return fading(length, length == torusLength ? 0 : share);
    };
    const std::vector<float> alongX = weightsFor(exemplar.width, m_torus.width);
    const std::vector<float> alongY = weightsFor(exemplar.height, m_torus.height);
    for (int c = 0; c < m_values.channels(); ++c)
        for (int y = 0; y < m_values.height(); ++y) {
            float* row = m_values.plane(c).row(y);
            for (int x = 0; x < m_values.width(); ++x)
                row[x] *= alongX[static_cast<std::size_t>(x)] * alongY[static_cast<std::size_t>(y)];
        }
}

void PhaseSpot::scaleToVariance(const std::function<void()>& check) {
    double energy = 0;
    const Size folded{std::min(m_torus.width, m_values.width()), std::min(m_torus.height, m_values.height())};
    for (int c = 0; c < m_values.channels(); ++c) {
        check();
        Image laid(folded, 1);
        write(c, laid.plane(0));
        const double mean = channelMeans(laid).front() * static_cast<double>(folded.area()) /
                            static_cast<double>(m_torus.area());
        energy += sumOfSquares(laid.plane(0)) / static_cast<double>(m_torus.area()) - mean * mean;
    }
    if (!(energy > 0))
        return;
    const auto factor = static_cast<float>(std::sqrt(m_variance / energy));
    for (int c = 0; c < m_values.channels(); ++c)
        for (int y = 0; y < m_values.height(); ++y) {
            float* row = m_values.plane(c).row(y);
            std::transform(row, row + m_values.width(), row,
                           [factor](float value) { return factor * value; });
        }
}

int PhaseSpot::rows() const {
    return std::min(m_torus.height, m_values.height());
}

void PhaseSpot::write(int channel, const PlaneSpan& plane) const {
    for (int y = 0; y < m_values.height(); ++y) {
        const float* from = m_values.view().plane(channel).row(y);
        float* to = plane.row(y % plane.height);
        for (int x = 0; x < m_values.width(); ++x)
            to[x % plane.width] += from[x];
    }
}

std::uint64_t PhaseSpot::bytesFor(Size exemplar, int channels) {
    return Image::bytesFor(exemplar, channels) + 3 * Image::bytesFor(exemplar, 1) + (1U << 20);
}

} // namespace texloom

#include "core/match/blend.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/boundary_cut.h"
#include "core/math/pca.h"
#include "core/math/transport.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace texloom {

namespace {

constexpr std::size_t kBetweenChecks = 1 << 14;

/// The value between pixels, interpolated; beyond the border, the value at the border.
float valueAt(const PlaneView& plane, const BlendCurve::Point& point) {
    const double x = std::clamp(point.x - 0.5, 0.0, plane.width - 1.0);
    const double y = std::clamp(point.y - 0.5, 0.0, plane.height - 1.0);
    const int left = std::min(static_cast<int>(x), std::max(0, plane.width - 2));
    const int top = std::min(static_cast<int>(y), std::max(0, plane.height - 2));
    const int right = std::min(left + 1, plane.width - 1), bottom = std::min(top + 1, plane.height - 1);
    const auto u = static_cast<float>(x - left), v = static_cast<float>(y - top);
    const auto mixed = [](float a, float b, float share) { return share == 0 ? a : a + share * (b - a); };
    return mixed(mixed(plane(left, top), plane(right, top), u),
                 mixed(plane(left, bottom), plane(right, bottom), u), v);
}

/// Orthonormal colour axes, one per row.
std::vector<double> cosineAxes(int channels) {
    std::vector<double> axes;
    for (int k = 0; k < channels; ++k)
        for (int c = 0; c < channels; ++c)
            axes.push_back(std::sqrt((k == 0 ? 1.0 : 2.0) / channels) *
                           std::cos(std::numbers::pi * (2 * c + 1) * k / (2.0 * channels)));
    return axes;
}

std::vector<double> plainAxes(int channels) {
    std::vector<double> axes(static_cast<std::size_t>(channels) * static_cast<std::size_t>(channels), 0.0);
    for (int c = 0; c < channels; ++c)
        axes[static_cast<std::size_t>(c) * static_cast<std::size_t>(channels + 1)] = 1;
    return axes;
}

/// to[k] = Σ axes[k][c] from[c], or with the axes transposed: the inverse.
void turn(const std::vector<double>& axes, bool back, int channels, const float* from, float* to,
          std::ptrdiff_t step) {
    for (int k = 0; k < channels; ++k) {
        double sum = 0;
        for (int c = 0; c < channels; ++c)
            sum += axes[static_cast<std::size_t>(back ? c * channels + k : k * channels + c)] *
                   static_cast<double>(from[c * step]);
        to[k] = static_cast<float>(sum);
    }
}

} // namespace

BlendBand::BlendBand(BlendCurve curve, Size size, int width, const Progress& progress)
    : m_curve(std::move(curve)), m_size(size), m_width(width) {
    for (int y = 0; y < size.height; ++y) {
        progress(static_cast<double>(y) / size.height);
        for (int x = 0; x < size.width; ++x) {
            const BlendCurve::Place place = m_curve.placeOf({x + 0.5, y + 0.5});
            if (place.across > 0) {
                if (m_beyond.empty() || m_beyond.back().y != y || m_beyond.back().last != x)
                    m_beyond.push_back({y, x, x});
                ++m_beyond.back().last;
            }
            if (std::abs(place.across) < width)
                m_band.push_back({x, y, place});
        }
    }
}

template <class Visit>
void BlendBand::everyPixel(const std::function<void()>& check, const Visit& visit) const {
    for (std::size_t i = 0; i < m_band.size(); ++i) {
        if (i % kBetweenChecks == 0)
            check();
        visit(m_band[i]);
    }
}

int BlendBand::lineLength() const {
    return std::max(2, static_cast<int>(std::lround(m_curve.length())));
}

BlendBand::Lines BlendBand::sample(const ImageView& image, int side, const Progress& progress) const {
    Lines lines{m_width + 1, image.channels, lineLength(), {}};
    const double step = m_curve.length() / lines.length;
    for (int distance = 0; distance <= m_width; ++distance) {
        progress(static_cast<double>(distance) / lines.count);
        for (int c = 0; c < image.channels; ++c)
            for (int i = 0; i < lines.length; ++i)
                lines.values.push_back(
                    valueAt(image.plane(c), m_curve.pointAt({(i + 0.5) * step, 1.0 * side * distance})));
    }
    return lines;
}

void BlendBand::compose(const ImageView& second, Image& to, const std::function<void()>& check) const {
    for (const auto& [y, first, last] : m_beyond) {
        check();
        for (int c = 0; c < to.channels(); ++c)
            std::copy_n(second.plane(c).row(y) + first, last - first, to.plane(c).row(y) + first);
    }
}

void BlendBand::cut(const ImageView& first, const ImageView& second, Image& to,
                    const Progress& progress) const {
    // The band is straightened, like the top overlap of a patch.
    const int reach = m_width - 1, length = lineLength();
    Image error({length, std::max(length, 2 * reach + 1)}, 1);
    const double step = m_curve.length() / length;
    for (int row = 0; row <= 2 * reach; ++row) {
        progress(static_cast<double>(row) / (2 * reach + 1));
        for (int i = 0; i < length; ++i) {
            const BlendCurve::Point point =
                m_curve.pointAt({(i + 0.5) * step, static_cast<double>(row - reach)});
            for (int c = 0; c < first.channels; ++c) {
                const float difference = valueAt(first.plane(c), point) - valueAt(second.plane(c), point);
                error(i, row, 0) += difference * difference;
            }
        }
    }
    const BoundaryCut path = minimumErrorCut(error.view().plane(0), {0, 2 * reach + 1, 0, 0});
    compose(second, to, [&] { progress(1); });
    everyPixel([&] { progress(1); },
               [&](const Pixel& pixel) {
                   const int i = std::clamp(static_cast<int>(pixel.place.along / step), 0, length - 1);
                   // Pixels at the band's edge may lie up to half a row outside.
                   const int row =
                       std::clamp(static_cast<int>(std::lround(pixel.place.across)), -reach, reach);
                   const ImageView& kept = path.keeps(i, row + reach) ? first : second;
                   for (int c = 0; c < to.channels(); ++c)
                       to(pixel.x, pixel.y, c) = kept(pixel.x, pixel.y, c);
               });
}

void BlendBand::edge(const ImageView& second, Image& to, const Progress& progress) const {
    compose(second, to, [&] { progress(0); });
}

std::vector<std::uint8_t> BlendBand::bandMask() const {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(m_size.area()), 0);
    for (const Pixel& pixel : m_band)
        mask[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(m_size.width) +
             static_cast<std::size_t>(pixel.x)] = 1;
    return mask;
}

std::vector<std::uint8_t> BlendBand::beyondMask() const {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(m_size.area()), 0);
    for (const auto& [y, first, last] : m_beyond)
        std::fill_n(mask.begin() + static_cast<std::ptrdiff_t>(y) * m_size.width + first, last - first, 1);
    return mask;
}

void BlendBand::markFirst(PlaneSpan to) const {
    const std::vector<std::uint8_t> beyond = beyondMask();
    std::size_t at = 0;
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            if (beyond[at++] == 0)
                to(x, y) = 1;
}

void BlendBand::preparePoisson() {
    m_region = std::make_shared<const PoissonRegion>(bandMask(), m_size);
}

std::vector<float> BlendBand::divergence(const ImageView& first, const ImageView& second,
                                         const Progress& progress) const {
    const std::vector<std::uint8_t> mask = beyondMask();
    const auto beyond = [&](int x, int y) {
        return mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                    static_cast<std::size_t>(x)];
    };
    std::vector<float> sums;
    for (int c = 0; c < first.channels; ++c)
        everyPixel([&] { progress(0); },
                   [&](const Pixel& pixel) {
                       const int x = pixel.x, y = pixel.y;
                       float& sum = sums.emplace_back(0.0F);
                       for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                           const int u = x + dx, v = y + dy;
                           if (u < 0 || v < 0 || u >= m_size.width || v >= m_size.height)
                               continue;
                           // Across the curve, the mean of both gradients.
                           const float share = 0.5F * static_cast<float>(beyond(x, y) + beyond(u, v));
                           sum += (1 - share) * (first(u, v, c) - first(x, y, c)) +
                                  share * (second(u, v, c) - second(x, y, c));
                       }
                   });
    return sums;
}

void BlendBand::poisson(const ImageView& first, const ImageView& second, Image& to,
                        const Progress& progress) const {
    const std::vector<float> sums = divergence(first, second, progress);
    compose(second, to, [&] { progress(0); });
    if (!m_region)
        return solvePoisson(bandMask(), sums, to, progress);
    for (int c = 0; c < to.channels(); ++c)
        m_region->solve(std::span(sums).subspan(static_cast<std::size_t>(c) * m_band.size(), m_band.size()),
                        to.plane(c));
}

void BlendBand::change(Lines& lines, const std::vector<double>& places, const std::vector<float>& middle,
                       int channel, Propagation propagation, const Progress& progress) {
    const auto length = static_cast<std::size_t>(lines.length);
    // The source pulls every line's mass to that of the middle (eq. 4.8), which shows as a band of uniform
    // brightness; here all lines change in the same proportion as the one on the curve.
    const double edge = massOf({lines.line(0, channel), length});
    const double gain = edge > 0 ? massOf(middle) / edge : 1;
    const int last = lines.count - 1;
    const std::vector<float> border(lines.line(last, channel), lines.line(last, channel) + length);
    for (int distance = 0; distance <= last; ++distance) {
        const double fade = static_cast<double>(distance) / last;
        progress(fade);
        float* line = lines.line(distance, channel);
        const std::span<const float> old(line, length);
        std::vector<float> fresh;
        if (distance == 0) {
            fresh = middle;
        } else if (propagation == Propagation::Progressive) {
            fresh = Midway(middle, border, fade).signal();
        } else {
            std::vector<double> faded;
            for (std::size_t i = 0; i <= length; ++i)
                faded.push_back(fade * static_cast<double>(i) + (1 - fade) * places[i]);
            fresh = deformed(old, faded, massOf(old) * (fade + (1 - fade) * gain));
        }
        for (std::size_t i = 0; i < length; ++i)
            line[i] = distance == last ? 0 : fresh[i] - line[i];
    }
}

float BlendBand::change(Lines& changes, const BlendCurve::Place& place, int channel) const {
    const double across = std::abs(place.across);
    const int near = std::min(static_cast<int>(across), m_width - 1);
    const double along =
        std::clamp(place.along * changes.length / m_curve.length() - 0.5, 0.0, changes.length - 1.0);
    const int before = std::min(static_cast<int>(along), changes.length - 2);
    const auto u = static_cast<float>(along - before), v = static_cast<float>(across - near);
    const float* a = changes.line(near, channel) + before;
    const float* b = changes.line(near + 1, channel) + before;
    return (1 - v) * ((1 - u) * a[0] + u * a[1]) + v * ((1 - u) * b[0] + u * b[1]);
}

void BlendBand::midway(const ImageView& first, const ImageView& second, const MidwayOptions& options,
                       Image& to, const Progress& progress) const {
    const int channels = to.channels();
    double begin = 0;
    const double part = 1.0 / (2 + 2 * channels);
    const Progress within = [&](double share) { progress(begin + part * share); };
    Lines sides[2];
    for (const int side : {0, 1}) {
        sides[side] = sample(side == 0 ? first : second, 2 * side - 1, within);
        begin += part;
    }
    const std::ptrdiff_t length = sides[0].length;
    std::vector<float> colour(static_cast<std::size_t>(channels));
    std::vector<double> axes = options.color == BlendColor::Dct ? cosineAxes(channels) : plainAxes(channels);
    const auto everyColour = [&](const auto& visit) {
        for (Lines& side : sides)
            for (int distance = 0; distance < side.count; ++distance) {
                progress(begin);
                for (std::ptrdiff_t i = 0; i < length; ++i)
                    visit(side.line(distance, 0) + i);
            }
    };
    if (options.color == BlendColor::Pca) {
        std::vector<double> colours;
        everyColour([&](const float* at) {
            for (int c = 0; c < channels; ++c)
                colours.push_back(static_cast<double>(at[c * length]));
        });
        axes = principalAxes(colours, channels, channels).axes;
    }
    const auto turnAll = [&](bool back) {
        everyColour([&](float* at) {
            turn(axes, back, channels, at, colour.data(), length);
            for (int c = 0; c < channels; ++c)
                at[c * length] = colour[static_cast<std::size_t>(c)];
        });
    };
    turnAll(false);
    for (int c = 0; c < channels; ++c) {
        float smallest = HUGE_VALF;
        everyColour([&](const float* at) { smallest = std::min(smallest, at[c * length]); });
        everyColour([&](float* at) { at[c * length] -= smallest; });
        const auto count = static_cast<std::size_t>(length);
        const Midway between(std::span<const float>(sides[0].line(0, c), count),
                             std::span<const float>(sides[1].line(0, c), count));
        const std::vector<float> middle = between.signal();
        change(sides[0], between.firstPlaces(), middle, c, options.propagation, within);
        begin += part;
        change(sides[1], between.secondPlaces(), middle, c, options.propagation, within);
        begin += part;
    }
    turnAll(true);
    compose(second, to, [&] { progress(1); });
    everyPixel([&] { progress(1); },
               [&](const Pixel& pixel) {
                   for (int c = 0; c < channels; ++c)
                       to(pixel.x, pixel.y, c) +=
                           change(sides[pixel.place.across > 0 ? 1 : 0], pixel.place, c);
               });
}

void checkBlend(Size first, Size second, const BlendOptions& options) {
    if (first != second)
        failUsage("The first image is {} × {} px, the second {} × {} px; crop one to the size of the other.",
                  first.width, first.height, second.width, second.height);
    if (options.band < 2 || 2 * options.band > first.shorterSide())
        failUsage("The band of {} px must be from 2 px to half the images' shorter side, {} px.",
                  options.band, first.shorterSide() / 2);
}

Image blendAlong(const ImageView& first, const ImageView& second, const BlendCurve& curve,
                 const BlendOptions& options, JobContext& context) {
    checkBlend(first.size(), second.size(), options);
    const auto stage = [&](double weight, const char* name) {
        context.stage(weight, name);
        return [&context](double share) {
            context.check();
            context.progress(share);
        };
    };
    const BlendBand band(curve, first.size(), options.band, stage(0.2, TR("Laying out the band")));
    Image result(first);
    const BlendBand::Progress progress = stage(0.8, TR("Blending"));
    switch (options.method) {
    case BlendMethod::Cut:
        band.cut(first, second, result, progress);
        break;
    case BlendMethod::Poisson:
        band.poisson(first, second, result, progress);
        break;
    case BlendMethod::Midway:
        band.midway(first, second, options.midway, result, progress);
        break;
    case BlendMethod::Edge:
        band.edge(second, result, progress);
        break;
    }
    context.progress(1);
    return result;
}

std::uint64_t blendBytesFor(Size size, int channels, const BlendOptions& options) {
    // Lists may have grown to twice what they hold.
    constexpr std::uint64_t kPixel = 2 * 24;
    const auto area = static_cast<std::uint64_t>(size.area());
    const auto deep = static_cast<std::uint64_t>(channels);
    // Curves are no longer than the longer side, or a quarter of a circle of the shorter one's radius.
    const std::uint64_t length = 2 * static_cast<std::uint64_t>(size.longerSide());
    const std::uint64_t lines =
        2 * length * static_cast<std::uint64_t>(options.band + 1) * deep * sizeof(float);
    const std::uint64_t band = std::min(area, length * 2 * static_cast<std::uint64_t>(options.band));
    std::uint64_t bytes = 2 * Image::bytesFor(size, channels) + band * kPixel +
                          static_cast<std::uint64_t>(size.height) * sizeof(std::uint64_t) * 4;
    if (options.method == BlendMethod::Cut)
        bytes += length * length * 2 * sizeof(float);
    else if (options.method == BlendMethod::Poisson)
        bytes += 2 * area + regionPoissonBytes(band, channels);
    else if (options.method == BlendMethod::Midway)
        bytes += lines + (options.midway.color == BlendColor::Pca ? 2 * lines : 0);
    return bytes;
}

} // namespace texloom

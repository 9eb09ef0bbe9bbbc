#include "core/analysis/derived_maps.h"

#include "core/math/poisson.h"
#include "core/math/zoom.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace texloom {

namespace {

constexpr double kSteepest = 10;

/// Half the difference of the neighbours on both sides along one axis; at a border that does not wrap the
/// whole difference to the one neighbour. @param at, count the place and the number of pixels along the axis.
template <class ValueAt> double slopeAt(int at, int count, bool wraps, const ValueAt& value) {
    if (count == 1)
        return 0;
    const int before = at > 0 ? at - 1 : wraps ? count - 1 : at;
    const int after = at + 1 < count ? at + 1 : wraps ? 0 : at;
    const double share = !wraps && (at == 0 || at + 1 == count) ? 1 : 0.5;
    return share * (value(after) - value(before));
}

/// The slopes of the surface, right and down, as two channels.
Image slopesOf(const ImageView& normals, MapRole role, const std::function<void()>& check) {
    const bool raw = valueRange(normals.channelRange(0, 3)).smallest < 0;
    const auto read = [&](int x, int y, int c) {
        const double stored = normals(x, y, c);
        return raw ? stored : 2 * stored - 1;
    };
    const double up = role == MapRole::NormalDx ? -1 : 1;
    Image slopes(normals.size(), 2);
    for (int y = 0; y < slopes.height(); ++y) {
        check();
        for (int x = 0; x < slopes.width(); ++x) {
            const double steep = std::max(read(x, y, 2), 1 / kSteepest);
            slopes(x, y, 0) = static_cast<float>(std::clamp(-read(x, y, 0) / steep, -kSteepest, kSteepest));
            slopes(x, y, 1) =
                static_cast<float>(std::clamp(up * read(x, y, 1) / steep, -kSteepest, kSteepest));
        }
    }
    return slopes;
}

/// The divergence of slopes, each taken halfway between two pixels as the mean of both.
Image divergenceOf(const Image& slopes, bool wraps) {
    const int width = slopes.width(), height = slopes.height();
    const auto between = [&](int a, int b, int count, const auto& value) -> double {
        const bool beyond = a < 0 || b >= count;
        if (beyond && (!wraps || count == 1))
            return 0;
        return 0.5 * (value((a + count) % count) + value(b % count));
    };
    Image divergence(slopes.size(), 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto right = [&](int at) { return slopes(at, y, 0); };
            const auto down = [&](int at) { return slopes(x, at, 1); };
            divergence(x, y, 0) =
                static_cast<float>(between(x, x + 1, width, right) - between(x - 1, x, width, right) +
                                   between(y, y + 1, height, down) - between(y - 1, y, height, down));
        }
    return divergence;
}

void stretch(Image& image) {
    const ValueRange range = valueRange(image);
    const float span = range.largest - range.smallest;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image(x, y, 0) = span > 0 ? (image(x, y, 0) - range.smallest) / span : 0.5F;
}

} // namespace

Image normalsFromHeight(const ImageView& height, double depth, Wrap wrap,
                        const std::function<void()>& check) {
    Image normals(height.size(), 3);
    for (int y = 0; y < height.height; ++y) {
        check();
        for (int x = 0; x < height.width; ++x) {
            const double right =
                depth * slopeAt(x, height.width, wrap.x, [&](int at) -> double { return height(at, y, 0); });
            const double down =
                depth * slopeAt(y, height.height, wrap.y, [&](int at) -> double { return height(x, at, 0); });
            const double length = std::sqrt(right * right + down * down + 1);
            normals(x, y, 0) = static_cast<float>(0.5 - 0.5 * right / length);
            normals(x, y, 1) = static_cast<float>(0.5 + 0.5 * down / length);
            normals(x, y, 2) = static_cast<float>(0.5 + 0.5 / length);
        }
    }
    return normals;
}

Relief reliefOf(const ImageView& height, const ImageView& normals, MapRole role, Wrap wrap,
                const std::function<void()>& check) {
    const Image slopes = slopesOf(normals, role, check);
    double both = 0, heights = 0, vectors = 0;
    for (int y = 0; y < height.height; ++y) {
        check();
        for (int x = 0; x < height.width; ++x) {
            const double right =
                slopeAt(x, height.width, wrap.x, [&](int at) -> double { return height(at, y, 0); });
            const double down =
                slopeAt(y, height.height, wrap.y, [&](int at) -> double { return height(x, at, 0); });
            const double ownRight = slopes(x, y, 0), ownDown = slopes(x, y, 1);
            both += right * ownRight + down * ownDown;
            heights += right * right + down * down;
            vectors += ownRight * ownRight + ownDown * ownDown;
        }
    }
    if (heights <= 0 || vectors <= 0)
        return {};
    return {both / heights, both / std::sqrt(heights * vectors)};
}

Image heightFromNormals(const ImageView& normals, MapRole role, bool wraps,
                        const std::function<void()>& check) {
    const Image divergence = divergenceOf(slopesOf(normals, role, check), wraps);
    check();
    Image height = solvePoisson(divergence, {0.0}, wraps ? PoissonBorder::Wraps : PoissonBorder::NoFlux,
                                [&](double) { check(); });
    stretch(height);
    return height;
}

Image roughnessGuess(const ImageView& colors, const std::function<void()>& check) {
    constexpr double kDull = 0.9, kSmooth = 0.35;
    const int count = std::min(3, colors.channels);
    Image rough(colors.size(), 1);
    for (int y = 0; y < colors.height; ++y) {
        check();
        for (int x = 0; x < colors.width; ++x) {
            double least = 1, most = 0;
            for (int c = 0; c < count; ++c) {
                const double value = std::clamp(static_cast<double>(colors(x, y, c)), 0.0, 1.0);
                least = std::min(least, value);
                most = std::max(most, value);
            }
            // The least of the channels is high where a colour is both bright and pale.
            const double shine = 0.5 * (least + most) * (1 - 0.5 * (most - least));
            rough(x, y, 0) = static_cast<float>(kDull - (kDull - kSmooth) * shine);
        }
    }
    return rough;
}

Image occlusionGuess(const ImageView& height, Wrap wrap, const std::function<void()>& check) {
    constexpr double kStrength = 6;
    const ImageView first = height.channelRange(0, 1);
    const int shorter = std::min(height.width, height.height);
    Image sum(height.size(), 1);
    int scales = 0;
    for (int sigma = 2; sigma <= std::max(2, shorter / 16); sigma *= 2, ++scales) {
        const Image around = blurred(first, sigma, wrap, check);
        for (int y = 0; y < height.height; ++y)
            for (int x = 0; x < height.width; ++x)
                sum(x, y, 0) += std::max(0.0F, around(x, y, 0) - first(x, y, 0));
    }
    for (int y = 0; y < height.height; ++y)
        for (int x = 0; x < height.width; ++x)
            sum(x, y, 0) =
                static_cast<float>(std::max(0.0, 1 - kStrength * static_cast<double>(sum(x, y, 0)) / scales));
    return sum;
}

} // namespace texloom

#include "core/image/stmap.h"

#include "core/base/error.h"
#include "core/image/cubic_taps.h"
#include "core/image/mirror.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr float kValid = 0.5F;

/// A pixel's place, in pixels of its exemplar.
Eigen::Vector2d placeAt(const ImageView& stmap, Size exemplar, int x, int y) {
    return {static_cast<double>(stmap(x, y, 0)) * exemplar.width,
            (1 - static_cast<double>(stmap(x, y, 1))) * exemplar.height};
}

bool valid(const ImageView& stmap, int x, int y) {
    return stmap.channels < 4 || stmap(x, y, 3) >= kValid;
}

/// A difference of places, each the shorter way round.
Eigen::Vector2d shorter(Eigen::Vector2d difference, Size exemplar) {
    difference.x() -= exemplar.width * std::round(difference.x() / exemplar.width);
    difference.y() -= exemplar.height * std::round(difference.y() / exemplar.height);
    return difference;
}

/// The derivative along one axis, per component the larger of the two differences: where the map turns round
/// between two pixels, theirs is too small.
Eigen::Vector2d derivative(const ImageView& stmap, Size exemplar, int x, int y, int dx, int dy) {
    const Eigen::Vector2d here = placeAt(stmap, exemplar, x, y);
    Eigen::Vector2d largest(0, 0);
    for (const int sign : {1, -1}) {
        const int u = x + sign * dx, v = y + sign * dy;
        if (u < 0 || v < 0 || u >= stmap.width || v >= stmap.height || !valid(stmap, u, v))
            continue;
        const Eigen::Vector2d step = sign * shorter(placeAt(stmap, exemplar, u, v) - here, exemplar);
        for (int i = 0; i < 2; ++i)
            if (std::abs(step[i]) > std::abs(largest[i]))
                largest[i] = step[i];
    }
    return largest;
}

std::size_t exemplarOf(const ImageView& stmap, int x, int y) {
    return stmap.channels < 3 ? 0 : static_cast<std::size_t>(std::max(0.0F, std::round(stmap(x, y, 2))));
}

/// Adds up samples of one output pixel.
void applyAt(const ImageView& stmap, const ImageView& source, int x, int y, Image& result) {
    const Eigen::Vector2d place = placeAt(stmap, source.size(), x, y);
    const Eigen::Matrix2d step = stMapJacobian(stmap, source.size(), x, y);
    const int across = samplesFor(step.col(0).norm()), down = samplesFor(step.col(1).norm());
    for (int j = 0; j < down; ++j)
        for (int i = 0; i < across; ++i) {
            const Eigen::Vector2d at =
                place + step * Eigen::Vector2d((i + 0.5) / across - 0.5, (j + 0.5) / down - 0.5);
            const auto columns = cubicTaps(at.x() - 0.5, [&](int n) { return mirrored(n, source.width); });
            const auto rows = cubicTaps(at.y() - 0.5, [&](int n) { return mirrored(n, source.height); });
            for (int c = 0; c < source.channels; ++c)
                result(x, y, c) += sampleAt(source.plane(c), columns, rows);
        }
    for (int c = 0; across * down > 1 && c < source.channels; ++c)
        result(x, y, c) /= static_cast<float>(across * down);
}

} // namespace

Eigen::Matrix2d stMapJacobian(const ImageView& stmap, Size exemplar, int x, int y) {
    Eigen::Matrix2d jacobian;
    jacobian.col(0) = derivative(stmap, exemplar, x, y, 1, 0);
    jacobian.col(1) = derivative(stmap, exemplar, x, y, 0, 1);
    if (jacobian.determinant() == 0)
        return Eigen::Matrix2d::Identity();
    return jacobian;
}

bool addressesPixels(const ImageView& stmap, const std::vector<Size>& exemplars) {
    constexpr double kWhole = 1.0 / 32;
    for (int y = 0; y < stmap.height; ++y)
        for (int x = 0; x < stmap.width; ++x) {
            const std::size_t exemplar = exemplarOf(stmap, x, y);
            if (!valid(stmap, x, y) || exemplar >= exemplars.size())
                continue;
            const Eigen::Vector2d index =
                placeAt(stmap, exemplars[exemplar], x, y) - Eigen::Vector2d(0.5, 0.5);
            if (!(std::abs(index.x() - std::round(index.x())) <= kWhole &&
                  std::abs(index.y() - std::round(index.y())) <= kWhole))
                return false;
        }
    return true;
}

Image appliedStMap(const ImageView& stmap, std::span<const ImageView> exemplars,
                   const std::function<void()>& check) {
    Image result(stmap.size(), exemplars.front().channels);
    for (int y = 0; y < stmap.height; ++y) {
        check();
        for (int x = 0; x < stmap.width; ++x) {
            if (!valid(stmap, x, y))
                continue;
            const std::size_t exemplar = exemplarOf(stmap, x, y);
            if (exemplar >= exemplars.size())
                fail("The map's pixel ({}, {}) comes from exemplar {}, but there are {}.", x, y, exemplar + 1,
                     exemplars.size());
            applyAt(stmap, exemplars[exemplar], x, y, result);
        }
    }
    return result;
}

} // namespace texloom

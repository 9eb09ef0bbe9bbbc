#include "core/methods/portilla_simoncelli/marginals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom::portilla_simoncelli {

namespace {

/// Means over a plane of the N numbers that `terms` makes of each sample.
template <std::size_t N, class Terms>
std::array<double, N> meansOf(const PlaneView& plane, const Check& check, const Terms& terms) {
    std::array<double, N> sums{};
    for (int y = 0; y < plane.height; ++y) {
        check();
        std::array<double, N> row{};
        const float* values = plane.row(y);
        for (int x = 0; x < plane.width; ++x) {
            const std::array<double, N> added = terms(static_cast<double>(values[x]));
            for (std::size_t i = 0; i < N; ++i)
                row[i] += added[i];
        }
        for (std::size_t i = 0; i < N; ++i)
            sums[i] += row[i];
    }
    for (double& sum : sums)
        sum /= static_cast<double>(plane.width) * plane.height;
    return sums;
}

template <class Map> void apply(const PlaneSpan& plane, const Check& check, const Map& map) {
    for (int y = 0; y < plane.height; ++y) {
        check();
        float* values = plane.row(y);
        for (int x = 0; x < plane.width; ++x)
            values[x] = static_cast<float>(map(static_cast<double>(values[x])));
    }
}

/// The λ nearest 0 at which `value` reaches `target`, or where it turns before that. `value` starts at
/// `current` for λ = 0 and grows with λ there.
template <class Function> double stepTo(double target, double current, const Function& value) {
    constexpr double kFirst = 1e-5, kLargest = 1e3, kGrowth = 1.25;
    constexpr int kHalvings = 50;
    if (target == current || !std::isfinite(target))
        return 0;
    const double sign = target > current ? 1 : -1;
    double inside = 0, best = current;
    for (double size = kFirst; size < kLargest; size *= kGrowth) {
        const double here = value(sign * size);
        if (sign * (here - target) >= 0) {
            double outside = sign * size;
            for (int i = 0; i < kHalvings; ++i) {
                const double middle = (inside + outside) / 2;
                (sign * (value(middle) - target) >= 0 ? outside : inside) = middle;
            }
            return outside;
        }
        if (sign * (here - best) < 0)
            break;
        best = here;
        inside = sign * size;
    }
    return inside;
}

struct Centre {
    double mean, deviation;
};

Centre centreOf(const PlaneView& plane, const Check& check) {
    const double mean = meansOf<1>(plane, check, [](double v) { return std::array{v}; })[0];
    const double variance =
        meansOf<1>(plane, check, [mean](double v) { return std::array{(v - mean) * (v - mean)}; })[0];
    return {mean, std::sqrt(variance)};
}

} // namespace

Moments momentsOf(const PlaneView& plane, const Check& check) {
    const auto [mean, deviation] = centreOf(plane, check);
    Moments moments;
    moments.mean = mean;
    moments.variance = deviation * deviation;
    float smallest = plane(0, 0), largest = smallest;
    for (int y = 0; y < plane.height; ++y) {
        const auto [least, most] = std::minmax_element(plane.row(y), plane.row(y) + plane.width);
        smallest = std::min(smallest, *least);
        largest = std::max(largest, *most);
    }
    moments.smallest = static_cast<double>(smallest);
    moments.largest = static_cast<double>(largest);
    if (!(deviation > 0))
        return moments;
    const auto means = meansOf<2>(plane, check, [centre = mean, scale = 1 / deviation](double v) {
        const double x = (v - centre) * scale;
        return std::array{x * x * x, x * x * x * x};
    });
    moments.skewness = means[0];
    moments.kurtosis = means[1];
    return moments;
}

void adjustVariance(const PlaneSpan& plane, double mean, double variance, const Check& check) {
    const Centre centre = centreOf(plane, check);
    const double scale = centre.deviation > 0 ? std::sqrt(variance) / centre.deviation : 0;
    apply(plane, check, [&](double v) { return (v - centre.mean) * scale + mean; });
}

void adjustSkewness(const PlaneSpan& plane, double skewness, const Check& check) {
    const auto [mean, deviation] = centreOf(plane, check);
    if (!(deviation > 0))
        return;
    const double centre = mean, scale = 1 / deviation;
    const auto third = meansOf<1>(plane, check, [=](double v) {
        const double x = (v - centre) * scale;
        return std::array{x * x * x};
    });
    const double s = third[0];
    // With g = x² − 1 − s x, which is uncorrelated with x: moments of x + λ g.
    const auto m = meansOf<4>(plane, check, [=](double v) {
        const double x = (v - centre) * scale, g = x * x - 1 - s * x;
        return std::array{x * x * g, x * g * g, g * g * g, g * g};
    });
    const double lambda = stepTo(skewness, s, [&](double l) {
        return (s + l * (3 * m[0] + l * (3 * m[1] + l * m[2]))) / std::pow(1 + l * l * m[3], 1.5);
    });
    const double back = deviation / std::sqrt(1 + lambda * lambda * m[3]);
    apply(plane, check, [=](double v) {
        const double x = (v - centre) * scale;
        return centre + back * (x + lambda * (x * x - 1 - s * x));
    });
}

void adjustKurtosis(const PlaneSpan& plane, double kurtosis, const Check& check) {
    const auto [mean, deviation] = centreOf(plane, check);
    if (!(deviation > 0))
        return;
    const double centre = mean, scale = 1 / deviation;
    const auto powers = meansOf<2>(plane, check, [=](double v) {
        const double x = (v - centre) * scale;
        return std::array{x * x * x, x * x * x * x};
    });
    const double s = powers[0], k = powers[1];
    // With g = x³ − k x − s, which is uncorrelated with x: moments of x + λ g.
    const auto m = meansOf<5>(plane, check, [=](double v) {
        const double x = (v - centre) * scale, g = x * x * x - k * x - s;
        return std::array{x * x * x * g, x * x * g * g, x * g * g * g, g * g * g * g, g * g};
    });
    const double lambda = stepTo(kurtosis, k, [&](double l) {
        const double variance = 1 + l * l * m[4];
        return (k + l * (4 * m[0] + l * (6 * m[1] + l * (4 * m[2] + l * m[3])))) / (variance * variance);
    });
    const double back = deviation / std::sqrt(1 + lambda * lambda * m[4]);
    apply(plane, check, [=](double v) {
        const double x = (v - centre) * scale;
        return centre + back * (x + lambda * (x * x * x - k * x - s));
    });
}

void clampTo(const PlaneSpan& plane, double smallest, double largest, const Check& check) {
    apply(plane, check, [=](double v) { return std::clamp(v, smallest, largest); });
}

} // namespace texloom::portilla_simoncelli

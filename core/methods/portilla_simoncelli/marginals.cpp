#include "core/methods/portilla_simoncelli/marginals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace texloom::portilla_simoncelli {

namespace {

/// Means over a plane of the N numbers that `terms` makes of each sample. Sums are kept in lanes because
/// single running ones do not vectorise.
template <std::size_t N, class Terms>
std::array<double, N> meansOf(const PlaneView& plane, const Check& check, const Terms& terms) {
    constexpr int kLanes = 8;
    std::array<std::array<double, kLanes>, N> lanes{};
    for (int y = 0; y < plane.height; ++y) {
        check();
        const float* values = plane.row(y);
        int x = 0;
        for (; x + kLanes <= plane.width; x += kLanes)
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const std::array<double, N> added =
                    terms(static_cast<double>(values[x + static_cast<int>(lane)]));
                for (std::size_t i = 0; i < N; ++i)
                    lanes[i][lane] += added[i];
            }
        for (; x < plane.width; ++x) {
            const std::array<double, N> added = terms(static_cast<double>(values[x]));
            for (std::size_t i = 0; i < N; ++i)
                lanes[i][0] += added[i];
        }
    }
    std::array<double, N> means{};
    for (std::size_t i = 0; i < N; ++i)
        means[i] = std::accumulate(lanes[i].begin(), lanes[i].end(), 0.0) /
                   (static_cast<double>(plane.width) * plane.height);
    return means;
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

/// λ for x + λ g with g = x² − 1 − s x, which is uncorrelated with x, of mean 0 and variance 1; and the
/// variance of the sum.
struct Step {
    double lambda = 0;
    double variance = 1;
};

Step skewnessStep(const PlaneView& plane, double mean, double scale, double s, double wanted,
                  const Check& check) {
    const auto m = meansOf<4>(plane, check, [=](double v) {
        const double x = (v - mean) * scale, g = x * x - 1 - s * x;
        return std::array{x * x * g, x * g * g, g * g * g, g * g};
    });
    const double lambda = stepTo(wanted, s, [&](double l) {
        return (s + l * (3 * m[0] + l * (3 * m[1] + l * m[2]))) / std::pow(1 + l * l * m[3], 1.5);
    });
    return {lambda, 1 + lambda * lambda * m[3]};
}

/// The same for g = x³ − k x − s, on samples x themselves.
Step kurtosisStep(const PlaneView& plane, double s, double k, double wanted, const Check& check) {
    const auto m = meansOf<5>(plane, check, [=](double x) {
        const double g = x * x * x - k * x - s;
        return std::array{x * x * x * g, x * x * g * g, x * g * g * g, g * g * g * g, g * g};
    });
    const double lambda = stepTo(wanted, k, [&](double l) {
        const double variance = 1 + l * l * m[4];
        return (k + l * (4 * m[0] + l * (6 * m[1] + l * (4 * m[2] + l * m[3])))) / (variance * variance);
    });
    return {lambda, 1 + lambda * lambda * m[4]};
}

} // namespace

Moments momentsOf(const PlaneView& plane, const Check& check) {
    Moments moments;
    moments.mean = meansOf<1>(plane, check, [](double v) { return std::array{v}; })[0];
    const auto means = meansOf<3>(plane, check, [mean = moments.mean](double v) {
        const double x = v - mean;
        return std::array{x * x, x * x * x, x * x * x * x};
    });
    float smallest = plane(0, 0), largest = smallest;
    for (int y = 0; y < plane.height; ++y) {
        const float* row = plane.row(y);
        for (int x = 0; x < plane.width; ++x) {
            smallest = row[x] < smallest ? row[x] : smallest;
            largest = row[x] > largest ? row[x] : largest;
        }
    }
    moments.smallest = static_cast<double>(smallest);
    moments.largest = static_cast<double>(largest);
    moments.variance = means[0];
    if (!(means[0] > 0))
        return moments;
    moments.skewness = means[1] / std::pow(means[0], 1.5);
    moments.kurtosis = means[2] / (means[0] * means[0]);
    return moments;
}

void imposeMoments(const PlaneSpan& plane, const Moments& current, const Moments& wanted,
                   const Check& check) {
    if (!(current.variance > 0))
        return apply(plane, check, [&](double v) { return v - current.mean + wanted.mean; });
    const double mean = current.mean, scale = 1 / std::sqrt(current.variance), s = current.skewness;
    const Step skew = skewnessStep(plane, mean, scale, s, wanted.skewness, check);
    const double shrunk = 1 / std::sqrt(skew.variance);
    apply(plane, check, [=](double v) {
        const double x = (v - mean) * scale;
        return shrunk * (x + skew.lambda * (x * x - 1 - s * x));
    });
    const auto powers = meansOf<2>(plane, check, [](double x) {
        return std::array{x * x * x, x * x * x * x};
    });
    const double third = powers[0], fourth = powers[1];
    const Step kurt = kurtosisStep(plane, third, fourth, wanted.kurtosis, check);
    const double deviation = std::sqrt(wanted.variance / kurt.variance);
    apply(plane, check, [=, &wanted](double x) {
        const double moved = wanted.mean + deviation * (x + kurt.lambda * (x * x * x - fourth * x - third));
        return std::min(std::max(moved, wanted.smallest), wanted.largest);
    });
}

} // namespace texloom::portilla_simoncelli

#include "core/math/geometric_median.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom {

namespace {

constexpr int kMostDimensions = 16;
constexpr int kMostPoints = 64;
/// An iteration that moves by less than this share of the spread ends the search.
constexpr double kNear = 1e-6;
constexpr int kMostRounds = 200;

using Point = std::array<double, kMostDimensions>;

std::size_t place(int index) {
    return static_cast<std::size_t>(index);
}

double distance(const Point& a, const float* b, int dimension) {
    double sum = 0;
    for (int d = 0; d < dimension; ++d) {
        const double difference = a[place(d)] - static_cast<double>(b[d]);
        sum += difference * difference;
    }
    return std::sqrt(sum);
}

double spread(const Point& from, const float* points, int count, int dimension) {
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += distance(from, points + i * dimension, dimension);
    return sum / count;
}

/// One step from `x`; returns how far it went.
double step(Point& x, const float* points, const float* weights, int count, int dimension, double touching) {
    Point sum{}, pull{};
    double whole = 0, here = 0;
    for (int i = 0; i < count; ++i) {
        const float* point = points + i * dimension;
        const auto weight = static_cast<double>(weights[i]);
        const double away = distance(x, point, dimension);
        if (away <= touching) {
            here += weight;
            continue;
        }
        whole += weight / away;
        for (int d = 0; d < dimension; ++d) {
            sum[place(d)] += weight / away * static_cast<double>(point[d]);
            pull[place(d)] += weight / away * (static_cast<double>(point[d]) - x[place(d)]);
        }
    }
    if (whole <= 0)
        return 0;
    double force = 0;
    for (int d = 0; d < dimension; ++d)
        force += pull[place(d)] * pull[place(d)];
    force = std::sqrt(force);
    const double stay = force > 0 ? std::min(1.0, here / force) : 1;
    double moved = 0;
    for (int d = 0; d < dimension; ++d) {
        const double to = (1 - stay) * sum[place(d)] / whole + stay * x[place(d)];
        moved += (to - x[place(d)]) * (to - x[place(d)]);
        x[place(d)] = to;
    }
    return std::sqrt(moved);
}

} // namespace

void geometricMedian(const float* points, const float* weights, int count, int dimension, float* result,
                     double tolerance) {
    Point x{};
    std::copy_n(result, dimension, x.begin());
    const double size = spread(x, points, count, dimension);
    for (int i = 0; i < kMostRounds; ++i)
        if (step(x, points, weights, count, dimension, 1e-9 * size) <= tolerance * size)
            break;
    for (int d = 0; d < dimension; ++d)
        result[d] = static_cast<float>(x[place(d)]);
}

void geometricMedianByDouglasRachford(const float* points, const float* weights, int count, int dimension,
                                      float* result) {
    Point mean{}, last{};
    std::copy_n(result, dimension, mean.begin());
    const double size = spread(mean, points, count, dimension);
    if (size <= 0)
        return;
    std::array<Point, kMostPoints> y{}, p{};
    y.fill(mean);
    double whole = 0;
    for (int i = 0; i < count; ++i)
        whole += static_cast<double>(weights[i]);
    for (int round = 0; round < 10 * kMostRounds; ++round) {
        last = mean;
        mean = {};
        for (int i = 0; i < count; ++i) {
            // prox of γ·w‖· − q‖: towards q by γ·w, and no further than q.
            const float* point = points + i * dimension;
            const double reach = 0.25 * size * static_cast<double>(weights[i]) * count / whole;
            const double away = distance(y[place(i)], point, dimension);
            const double share = away > reach ? reach / away : 1;
            for (int d = 0; d < dimension; ++d) {
                p[place(i)][place(d)] =
                    y[place(i)][place(d)] + share * (static_cast<double>(point[d]) - y[place(i)][place(d)]);
                mean[place(d)] += p[place(i)][place(d)] / count;
            }
        }
        double moved = 0;
        for (int d = 0; d < dimension; ++d) {
            const double change = mean[place(d)] - last[place(d)];
            moved += change * change;
            for (int i = 0; i < count; ++i)
                y[place(i)][place(d)] += mean[place(d)] - p[place(i)][place(d)] + change;
        }
        if (round > 2 && std::sqrt(moved) <= kNear * size)
            break;
    }
    for (int d = 0; d < dimension; ++d)
        result[d] = static_cast<float>(mean[place(d)]);
}

} // namespace texloom

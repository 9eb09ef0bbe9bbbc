#include "core/analysis/lattice_views.h"

#include "core/math/zoom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace texloom {

namespace {

/// Polynomials of degree 0 to 2 on `length` points, orthonormal.
std::array<std::vector<double>, 3> polynomials(int length) {
    std::array<std::vector<double>, 3> basis;
    for (std::size_t degree = 0; degree < basis.size(); ++degree) {
        std::vector<double>& own = basis[degree];
        for (int i = 0; i < length; ++i)
            own.push_back(std::pow(2 * (i + 0.5) / length - 1, static_cast<double>(degree)));
        for (std::size_t lower = 0; lower < degree; ++lower) {
            double shared = 0;
            for (std::size_t i = 0; i < own.size(); ++i)
                shared += own[i] * basis[lower][i];
            for (std::size_t i = 0; i < own.size(); ++i)
                own[i] -= shared * basis[lower][i];
        }
        double norm = 0;
        for (const double value : own)
            norm += value * value;
        for (double& value : own)
            value = norm > 0 ? value / std::sqrt(norm) : 0;
    }
    return basis;
}

/// Subtracts from a channel the quadratic surface that fits it best.
void flatten(PlaneSpan plane) {
    const auto across = polynomials(plane.width), down = polynomials(plane.height);
    std::array<std::array<double, 3>, 3> weights{};
    for (int y = 0; y < plane.height; ++y) {
        std::array<double, 3> row{};
        for (int x = 0; x < plane.width; ++x)
            for (std::size_t i = 0; i < 3; ++i)
                row[i] += static_cast<double>(plane(x, y)) * across[i][static_cast<std::size_t>(x)];
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i + j < 3; ++i)
                weights[j][i] += row[i] * down[j][static_cast<std::size_t>(y)];
    }
    for (int y = 0; y < plane.height; ++y) {
        std::array<double, 3> row{};
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i + j < 3; ++i)
                row[i] += weights[j][i] * down[j][static_cast<std::size_t>(y)];
        for (int x = 0; x < plane.width; ++x)
            for (std::size_t i = 0; i < 3; ++i)
                plane(x, y) -= static_cast<float>(row[i] * across[i][static_cast<std::size_t>(x)]);
    }
}

} // namespace

Image withoutLight(const ImageView& exemplar, const std::function<void()>& check) {
    Image flat(exemplar);
    for (int c = 0; c < flat.channels(); ++c) {
        check();
        flatten(flat.plane(c));
    }
    return flat;
}

Image edgesOf(const ImageView& exemplar, const std::function<void()>& check) {
    constexpr double kFine = 1; // px: finer grain is no edge
    // How far joints may lie from where the lattice has them.
    const double loose = std::max(2.0, exemplar.size().shorterSide() / 160.0);
    const Image soft = blurred(exemplar, kFine, {}, check);
    Image edges(exemplar.size(), 1);
    const int right = exemplar.width - 1, bottom = exemplar.height - 1;
    for (int y = 0; y <= bottom; ++y) {
        check();
        for (int x = 0; x <= right; ++x) {
            double sum = 0;
            for (int c = 0; c < exemplar.channels; ++c) {
                const auto across =
                    static_cast<double>(soft(std::min(x + 1, right), y, c) - soft(std::max(x - 1, 0), y, c));
                const auto down =
                    static_cast<double>(soft(x, std::min(y + 1, bottom), c) - soft(x, std::max(y - 1, 0), c));
                sum += across * across + down * down;
            }
            edges(x, y, 0) = static_cast<float>(std::sqrt(sum));
        }
    }
    return withoutLight(blurred(edges, loose, {}, check), check);
}

} // namespace texloom

#include "core/match/gaussian_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom {

std::vector<double> gaussianWeights(std::span<const double> coefficients) {
    const auto count = static_cast<double>(coefficients.size());
    if (coefficients.size() == 1)
        return {1.0};
    const double scale = 1 / std::sqrt(count - 1);
    const double sum = std::accumulate(coefficients.begin(), coefficients.end(), 0.0);
    std::vector<double> weights;
    for (const double coefficient : coefficients)
        weights.push_back(coefficient * scale + (1 - sum * scale) / count);
    return weights;
}

void combinePatches(std::span<const ImageView> patches, std::span<const double> weights, Image& to) {
    for (int c = 0; c < to.channels(); ++c)
        for (int y = 0; y < to.height(); ++y) {
            float* row = to.plane(c).row(y);
            std::fill_n(row, to.width(), 0.0F);
            for (std::size_t i = 0; i < patches.size(); ++i) {
                const float* from = patches[i].plane(c).row(y);
                const auto weight = static_cast<float>(weights[i]);
                for (int x = 0; x < to.width(); ++x)
                    row[x] += weight * from[x];
            }
        }
}

std::vector<double> normalNumbers(const Random& random, const PatchCell& cell, std::size_t count,
                                  std::uint32_t first) {
    std::vector<double> numbers;
    numbers.reserve(count);
    for (std::uint32_t n = 0; n < count; ++n)
        numbers.push_back(random.normal(cell.column, cell.row, first + n));
    return numbers;
}

void drawPatch(std::span<const ImageView> patches, const Random& random, const PatchCell& cell,
               std::uint32_t first, Image& to) {
    combinePatches(patches, gaussianWeights(normalNumbers(random, cell, patches.size(), first)), to);
}

double meanPatchDeviation(std::span<const ImageView> patches) {
    if (patches.size() < 2)
        return 0;
    const ImageView& one = patches.front();
    const auto count = static_cast<double>(patches.size());
    double total = 0;
    for (int c = 0; c < one.channels; ++c)
        for (int y = 0; y < one.height; ++y)
            for (int x = 0; x < one.width; ++x) {
                double sum = 0, squares = 0;
                const auto origin = static_cast<double>(one(x, y, c));
                for (const ImageView& patch : patches) {
                    const double value = static_cast<double>(patch(x, y, c)) - origin;
                    sum += value;
                    squares += value * value;
                }
                total += std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1));
            }
    return total / (static_cast<double>(one.size().area()) * one.channels);
}

} // namespace texloom

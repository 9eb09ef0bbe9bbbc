#include "core/match/gaussian_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom {

namespace {

/// What patches have at the pixels of a row: one property, such as lightness.
struct RowRange {
    explicit RowRange(int width)
        : low(static_cast<std::size_t>(width), HUGE_VALF), high(low.size(), -HUGE_VALF),
          mean(low.size(), 0.0F) {}

    void add(const std::vector<float>& values, float share) {
        for (std::size_t x = 0; x < low.size(); ++x) {
            low[x] = std::min(low[x], values[x]);
            high[x] = std::max(high[x], values[x]);
            mean[x] += share * values[x];
        }
    }
    /// How much of a difference from the mean stays within, 0 to 1.
    float share(std::size_t x, float difference) const {
        // Rounding may put the mean of equal values beyond them.
        const float room = std::max(0.0F, difference > 0 ? high[x] - mean[x] : mean[x] - low[x]);
        const float size = std::abs(difference);
        return size > room ? room / size : 1.0F;
    }

    std::vector<float> low, high, mean;
};

/// The mean over the channels of a row.
void lightnessOf(const ImageView& patch, int y, std::vector<float>& to) {
    std::fill(to.begin(), to.end(), 0.0F);
    for (int c = 0; c < patch.channels; ++c)
        for (std::size_t x = 0; x < to.size(); ++x)
            to[x] += patch.plane(c).row(y)[x] / static_cast<float>(patch.channels);
}

/// What a channel of a row differs by from its lightness.
void colorOf(const ImageView& patch, int y, int c, const std::vector<float>& lightness,
             std::vector<float>& to) {
    for (std::size_t x = 0; x < to.size(); ++x)
        to[x] = patch.plane(c).row(y)[x] - lightness[x];
}

} // namespace

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

void boundPatch(std::span<const ImageView> patches, Image& to) {
    const int width = to.width(), channels = to.channels();
    const auto share = 1 / static_cast<float>(patches.size());
    std::vector<float> lightness(static_cast<std::size_t>(width)), color(lightness.size());
    for (int y = 0; y < to.height(); ++y) {
        RowRange light(width);
        std::vector<RowRange> colors(static_cast<std::size_t>(channels), RowRange(width));
        for (const ImageView& patch : patches) {
            lightnessOf(patch, y, lightness);
            light.add(lightness, share);
            for (int c = 0; c < channels; ++c) {
                colorOf(patch, y, c, lightness, color);
                colors[static_cast<std::size_t>(c)].add(color, share);
            }
        }
        lightnessOf(to.view(), y, lightness);
        for (std::size_t x = 0; x < lightness.size(); ++x) {
            float kept = 1;
            for (int c = 0; c < channels; ++c) {
                const RowRange& range = colors[static_cast<std::size_t>(c)];
                kept = std::min(kept, range.share(x, to.plane(c).row(y)[x] - lightness[x] - range.mean[x]));
            }
            const float away = lightness[x] - light.mean[x];
            const float bounded = light.mean[x] + light.share(x, away) * away;
            for (int c = 0; c < channels; ++c) {
                const float mean = colors[static_cast<std::size_t>(c)].mean[x];
                float& value = to.plane(c).row(y)[x];
                value = bounded + mean + kept * (value - lightness[x] - mean);
            }
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
               std::uint32_t first, bool bounded, Image& to) {
    combinePatches(patches, gaussianWeights(normalNumbers(random, cell, patches.size(), first)), to);
    if (bounded)
        boundPatch(patches, to);
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

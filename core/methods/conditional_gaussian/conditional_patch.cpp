#include "core/methods/conditional_gaussian/conditional_patch.h"

#include "core/match/gaussian_patches.h"
#include "core/match/patch_stitch.h"
#include "core/math/conditional_gaussian.h"

#include <algorithm>
#include <cmath>

namespace texloom::conditional_gaussian {

namespace {

/// The pixels of an overlap that a patch is drawn to continue.
struct Given {
    Overlap overlap;
    int border; ///< only those at most so many pixels away from what is drawn; 0: all

    bool contains(int x, int y, int patch) const {
        if (!overlap.contains(x, y, patch))
            return false;
        const auto away = [&](int at, int before, int after) {
            return std::max(before - at, at - (patch - after - 1));
        };
        return border == 0 ||
               std::max(away(x, overlap.left, overlap.right), away(y, overlap.top, overlap.bottom)) <= border;
    }
};

/// The values of a patch on what is given, channel by channel.
std::vector<double> valuesOn(const ImageView& patch, const Given& given) {
    std::vector<double> values;
    for (int c = 0; c < patch.channels; ++c)
        for (int y = 0; y < patch.height; ++y)
            for (int x = 0; x < patch.width; ++x)
                if (given.contains(x, y, patch.width))
                    values.push_back(static_cast<double>(patch(x, y, c)));
    return values;
}

/// The known rows of Q = P/√(m − 1) by columns, and their mean.
struct Known {
    std::vector<double> rows;
    std::vector<double> mean;
};

Known knownPart(std::span<const ImageView> patches, const Given& given) {
    Known known;
    for (const ImageView& patch : patches) {
        const std::vector<double> values = valuesOn(patch, given);
        known.rows.insert(known.rows.end(), values.begin(), values.end());
    }
    const std::size_t count = known.rows.size() / patches.size();
    known.mean.assign(count, 0.0);
    for (std::size_t i = 0; i < known.rows.size(); ++i)
        known.mean[i % count] += known.rows[i] / static_cast<double>(patches.size());
    const double scale = 1 / std::sqrt(std::max<double>(1, static_cast<double>(patches.size()) - 1));
    for (std::size_t i = 0; i < known.rows.size(); ++i)
        known.rows[i] = (known.rows[i] - known.mean[i % count]) * scale;
    return known;
}

/// Coefficients with the norm that those of a Gaussian have, √m, as far as `share` says, 0 to 1.
std::vector<double> withNorm(std::vector<double> coefficients, double share) {
    double squares = 0;
    for (const double one : coefficients)
        squares += one * one;
    if (squares > 0)
        for (double& one : coefficients)
            one *= std::pow(static_cast<double>(coefficients.size()) / squares, share / 2);
    return coefficients;
}

void keepWeights(const Overlap& overlap, PlaneSpan weight) {
    for (int y = 0; y < weight.height; ++y)
        for (int x = 0; x < weight.width; ++x)
            weight(x, y) = overlap.contains(x, y, weight.width) ? 1.0F : 0.0F;
}

} // namespace

void conditionPatch(std::span<const ImageView> patches, const Image& known, const Overlap& overlap,
                    const Drawing& drawing, std::span<const double> normals, Image& fresh) {
    const bool closes = overlap.right > 0 || overlap.bottom > 0;
    const Given given{overlap, closes ? 0 : drawing.border};
    const Known model = knownPart(patches, given);
    std::vector<double> difference = valuesOn(known, given);
    double largest = 0;
    for (std::size_t i = 0; i < difference.size(); ++i) {
        largest = std::max(largest, std::abs(difference[i]));
        difference[i] -= model.mean[i];
    }
    // Keeps the factorisation well-defined where all patches are identical.
    const double least = std::max(1e-9 * largest, 1e-30);
    const ConditionalGaussian gaussian(model.rows, static_cast<int>(difference.size()), difference,
                                       std::max(drawing.sigma, least));
    const std::vector<double> drawn =
        normals.empty() ? gaussian.mean() : withNorm(gaussian.sample(normals), drawing.contrast);
    combinePatches(patches, gaussianWeights(drawn), fresh);
    if (drawing.bounded)
        boundPatch(patches, fresh);
    Image weight(fresh.size(), 1);
    if (closes)
        rampWeights(overlap, weight.plane(0));
    else
        keepWeights(overlap, weight.plane(0));
    mixPatches(known, weight.view().plane(0), fresh);
}

} // namespace texloom::conditional_gaussian

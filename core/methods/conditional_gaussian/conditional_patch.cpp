#include "core/methods/conditional_gaussian/conditional_patch.h"

#include "core/match/gaussian_patches.h"
#include "core/match/patch_stitch.h"
#include "core/math/conditional_gaussian.h"

#include <algorithm>
#include <cmath>

namespace texloom::conditional_gaussian {

namespace {

/// The values of a patch on the overlap, channel by channel.
std::vector<double> valuesOn(const ImageView& patch, const Overlap& overlap) {
    std::vector<double> values;
    for (int c = 0; c < patch.channels; ++c)
        for (int y = 0; y < patch.height; ++y)
            for (int x = 0; x < patch.width; ++x)
                if (overlap.contains(x, y, patch.width))
                    values.push_back(static_cast<double>(patch(x, y, c)));
    return values;
}

/// The known rows of Q = P/√(m − 1) by columns, and their mean.
struct Known {
    std::vector<double> rows;
    std::vector<double> mean;
};

Known knownPart(std::span<const ImageView> patches, const Overlap& overlap) {
    Known known;
    for (const ImageView& patch : patches) {
        const std::vector<double> values = valuesOn(patch, overlap);
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

void keepWeights(const Overlap& overlap, PlaneSpan weight) {
    for (int y = 0; y < weight.height; ++y)
        for (int x = 0; x < weight.width; ++x)
            weight(x, y) = overlap.contains(x, y, weight.width) ? 1.0F : 0.0F;
}

} // namespace

void conditionPatch(std::span<const ImageView> patches, const Image& known, const Overlap& overlap,
                    double sigma, std::span<const double> normals, Image& fresh) {
    const Known model = knownPart(patches, overlap);
    std::vector<double> difference = valuesOn(known, overlap);
    double largest = 0;
    for (std::size_t i = 0; i < difference.size(); ++i) {
        largest = std::max(largest, std::abs(difference[i]));
        difference[i] -= model.mean[i];
    }
    // Keeps the factorisation well-defined where all patches are identical.
    const double least = std::max(1e-9 * largest, 1e-30);
    const ConditionalGaussian gaussian(model.rows, static_cast<int>(difference.size()), difference,
                                       std::max(sigma, least));
    combinePatches(patches, gaussianWeights(normals.empty() ? gaussian.mean() : gaussian.sample(normals)),
                   fresh);
    Image weight(fresh.size(), 1);
    if (overlap.right > 0 || overlap.bottom > 0)
        rampWeights(overlap, weight.plane(0));
    else
        keepWeights(overlap, weight.plane(0));
    mixPatches(known, weight.view().plane(0), fresh);
}

} // namespace texloom::conditional_gaussian

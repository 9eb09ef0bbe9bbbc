#include "core/network/colour_tap.h"

#include "core/job/random.h"
#include "core/math/pca.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr int kDirections = 12;
constexpr double kQuantiles[] = {0.05, 0.2, 0.4, 0.6, 0.8, 0.95};
/// Directions are always drawn alike: what is compared does not depend on the seed of a run.
constexpr std::uint64_t kSeed = 20261129;
constexpr std::size_t kMostSamples = 1U << 16;

/// Colours of pixels spread evenly over all pictures, one a column.
Eigen::MatrixXd samplesOf(std::span<const Tensor* const> pictures) {
    std::size_t count = 0;
    for (const Tensor* picture : pictures)
        count += picture->area();
    const std::size_t step = count / kMostSamples + 1;
    std::vector<double> values;
    std::size_t number = 0;
    const int channels = pictures.front()->channels();
    for (const Tensor* picture : pictures)
        for (std::size_t i = 0; i < picture->area(); ++i)
            if (number++ % step == 0)
                for (int c = 0; c < channels; ++c)
                    values.push_back(static_cast<double>(picture->channel(c)[i]));
    return Eigen::Map<const Eigen::MatrixXd>(values.data(), channels,
                                             static_cast<Eigen::Index>(values.size()) / channels);
}

/// Rows that make uncorrelated coordinates of variance 1 of colours; as many as there is variance for.
Eigen::MatrixXd whitening(const Eigen::MatrixXd& samples) {
    const Eigen::VectorXd mean = samples.rowwise().mean();
    const Eigen::MatrixXd centred = samples.colwise() - mean;
    const CovarianceAxes axes =
        covarianceAxes(centred * centred.transpose() / static_cast<double>(samples.cols()));
    Eigen::Index kept = 0;
    while (kept < axes.variances.size() && axes.variances[kept] > 1e-5 * axes.variances.sum() &&
           axes.variances[kept] > 1e-12)
        ++kept;
    return axes.variances.head(kept).cwiseSqrt().cwiseInverse().asDiagonal() *
           axes.directions.leftCols(kept).transpose();
}

/// The coordinates themselves, then directions between them.
Eigen::MatrixXd directionsIn(const Eigen::MatrixXd& coordinates) {
    const Eigen::Index own = coordinates.rows();
    const Eigen::Index count = own <= 1 ? own : std::max<Eigen::Index>(own, kDirections);
    Eigen::MatrixXd mix = Eigen::MatrixXd::Zero(count, own);
    const Random random(kSeed);
    for (Eigen::Index k = 0; k < count; ++k) {
        if (k < own) {
            mix(k, k) = 1;
            continue;
        }
        for (Eigen::Index i = 0; i < own; ++i)
            mix(k, i) = random.normal(static_cast<int>(i), static_cast<int>(k));
        mix.row(k) /= std::sqrt(mix.row(k).squaredNorm());
    }
    return mix * coordinates;
}

} // namespace

Descriptor colourDescriptor(std::span<const Tensor* const> pictures) {
    const Eigen::MatrixXd samples = samplesOf(pictures);
    const Eigen::MatrixXd directions = directionsIn(whitening(samples));
    Descriptor descriptor;
    descriptor.name = "colours";
    descriptor.channels = static_cast<int>(samples.rows());
    descriptor.levels = 1;
    if (directions.rows() == 0)
        return descriptor;
    const int quantiles = static_cast<int>(std::size(kQuantiles));
    Filters filters = Filters::zero(static_cast<int>(directions.rows()) * quantiles, descriptor.channels, 1);
    for (int k = 0; k < static_cast<int>(directions.rows()); ++k) {
        const Eigen::VectorXd along = (directions.row(k) * samples).transpose();
        std::vector<double> sorted(along.data(), along.data() + along.size());
        std::sort(sorted.begin(), sorted.end());
        for (int q = 0; q < quantiles; ++q) {
            const int output = k * quantiles + q;
            const auto rank =
                static_cast<std::size_t>(kQuantiles[q] * static_cast<double>(sorted.size() - 1));
            filters.bias[at(output)] = static_cast<float>(-sorted[rank]);
            for (int c = 0; c < descriptor.channels; ++c)
                filters.at(output, c, 0, 0) = static_cast<float>(directions(k, c));
        }
    }
    using Kind = DescriptorLayer::Kind;
    descriptor.chains = {
        {{Kind::Convolution, "colours", filters}, {Kind::Rectifier, "", {}}, {Kind::Tap, "colours", {}}}};
    return descriptor;
}

} // namespace texloom

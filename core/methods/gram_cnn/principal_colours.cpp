#include "core/methods/gram_cnn/principal_colours.h"

#include "core/math/channel_pca.h"
#include "core/math/pca.h"

#include <algorithm>
#include <cmath>

namespace texloom::gram_cnn {

namespace {

/// Axes along which colours deviate less than this share of the values' range are left out.
constexpr double kLeastDeviation = 0.004;

} // namespace

PrincipalColours::PrincipalColours(const Request& request, JobContext& context)
    : m_means(at(request.channels()), 0.0) {
    const int channels = request.channels();
    double whole = 0, range = 1;
    for (const Exemplar& exemplar : request.exemplars)
        whole += exemplar.weight;
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(channels, channels);
    const auto check = [&] { context.check(); };
    for (const Exemplar& exemplar : request.exemplars) {
        const double weight = exemplar.weight / whole;
        const std::vector<double> own = channelMeans(*exemplar.image, check);
        const Eigen::Map<const Eigen::VectorXd> means(own.data(), channels);
        products += weight * (channelCovariance(*exemplar.image, check) + means * means.transpose());
        for (int c = 0; c < channels; ++c)
            m_means[at(c)] += weight * own[at(c)];
        const ValueRange values = valueRange(*exemplar.image);
        range = std::max<double>(range,
                                 static_cast<double>(values.largest) - static_cast<double>(values.smallest));
    }
    const Eigen::Map<const Eigen::VectorXd> mean(m_means.data(), channels);
    const CovarianceAxes axes = covarianceAxes(products - mean * mean.transpose());
    const double least = kLeastDeviation * kLeastDeviation * range * range;
    // Where all is faint, what there is still counts.
    while (
        m_components < channels && axes.variances[m_components] > 1e-10 * range * range &&
        (axes.variances[m_components] > least || axes.variances[m_components] > 0.05 * axes.variances.sum()))
        ++m_components;
    if (m_components == 0)
        return;
    Filters mix = Filters::zero(channels, m_components, 1), split = Filters::zero(m_components, channels, 1);
    for (int k = 0; k < m_components; ++k) {
        const double deviation = std::sqrt(axes.variances[k]);
        double offset = 0;
        for (int c = 0; c < channels; ++c) {
            mix.at(c, k, 0, 0) = static_cast<float>(axes.directions(c, k) * deviation);
            split.at(k, c, 0, 0) = static_cast<float>(axes.directions(c, k) / deviation);
            offset -= axes.directions(c, k) / deviation * m_means[at(c)];
        }
        split.bias[at(k)] = static_cast<float>(offset);
    }
    for (int c = 0; c < channels; ++c)
        mix.bias[at(c)] = static_cast<float>(m_means[at(c)]);
    m_mix.emplace(std::move(mix));
    m_split.emplace(std::move(split));
}

void PrincipalColours::toValues(const Tensor& components, Tensor& values, JobContext& context) {
    m_mix->forward(components, Edges{}, false, values, m_buffers, context);
}

void PrincipalColours::toComponents(const Tensor& valueGradient, Tensor& componentGradient,
                                    JobContext& context) {
    componentGradient.resize(m_components, valueGradient.height(), valueGradient.width());
    componentGradient.clear();
    m_mix->addGradient(valueGradient, Edges{}, componentGradient, m_buffers, context);
}

Tensor PrincipalColours::componentsOf(const Tensor& values, JobContext& context) {
    Tensor components;
    m_split->forward(values, Edges{}, false, components, m_buffers, context);
    return components;
}

} // namespace texloom::gram_cnn

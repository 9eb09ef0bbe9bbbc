#include "core/math/channel_pca.h"

#include "core/math/pca.h"

#include <algorithm>

namespace texloom {

namespace {

/// Components with less than this share of the largest variance are rounding errors.
constexpr double kLeastShare = 1e-9;

/// to_i = offset_i + Σ_j matrix(i, j) (from_j − shift_j) along one row.
void mixRow(const ImageView& from, std::span<const double> shifts, const Eigen::MatrixXd& matrix,
            std::span<const double> offsets, int y, Image& to) {
    for (int i = 0; i < to.channels(); ++i) {
        double constant = offsets.empty() ? 0 : offsets[static_cast<std::size_t>(i)];
        for (int j = 0; j < from.channels && !shifts.empty(); ++j)
            constant -= matrix(i, j) * shifts[static_cast<std::size_t>(j)];
        float* out = to.plane(i).row(y);
        std::fill_n(out, from.width, static_cast<float>(constant));
        for (int j = 0; j < from.channels; ++j) {
            const auto weight = static_cast<float>(matrix(i, j));
            const float* in = from.plane(j).row(y);
            for (int x = 0; x < from.width; ++x)
                out[x] += weight * in[x];
        }
    }
}

struct Axes {
    Eigen::MatrixXd toComponents, toChannels;
};

/// The principal axes of a covariance, strongest first, scaled to variance 1.
Axes axesOf(const Eigen::MatrixXd& covariance) {
    const Eigen::Index channels = covariance.rows();
    if (channels == 0)
        return {Eigen::MatrixXd(0, 0), Eigen::MatrixXd(0, 0)};
    const CovarianceAxes all = covarianceAxes(covariance);
    const double least = kLeastShare * std::max(0.0, all.variances(0));
    Eigen::Index count = 0;
    while (count < channels && all.variances(count) > least)
        ++count;
    Axes axes{Eigen::MatrixXd(count, channels), Eigen::MatrixXd(channels, count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const double deviation = std::sqrt(all.variances(i));
        axes.toComponents.row(i) = all.directions.col(i).transpose() / deviation;
        axes.toChannels.col(i) = all.directions.col(i) * deviation;
    }
    return axes;
}

} // namespace

Eigen::MatrixXd channelCovariance(const ImageView& image, const std::function<void()>& check) {
    const std::vector<double> means = channelMeans(image, check);
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(image.channels, image.channels);
    for (int y = 0; y < image.height; ++y) {
        check();
        for (int i = 0; i < image.channels; ++i)
            for (int j = 0; j <= i; ++j) {
                const float *a = image.plane(i).row(y), *b = image.plane(j).row(y);
                const double meanA = means[static_cast<std::size_t>(i)];
                const double meanB = means[static_cast<std::size_t>(j)];
                double sum = 0;
                for (int x = 0; x < image.width; ++x)
                    sum += (static_cast<double>(a[x]) - meanA) * (static_cast<double>(b[x]) - meanB);
                sums(i, j) += sum;
            }
    }
    sums /= static_cast<double>(image.size().area());
    return sums.selfadjointView<Eigen::Lower>();
}

ChannelPca::ChannelPca(const Eigen::MatrixXd& covariance, int leading) {
    const Eigen::Index channels = covariance.rows();
    const Eigen::Index first = leading > 0 ? std::min<Eigen::Index>(leading, channels) : channels;
    const Eigen::Index rest = channels - first;
    const Axes main = axesOf(covariance.topLeftCorner(first, first));
    // The regression is computed from the components, which contain the inverse of the covariance.
    const Eigen::MatrixXd slope = covariance.bottomLeftCorner(rest, first) * main.toComponents.transpose();
    const Eigen::MatrixXd beyond = covariance.bottomRightCorner(rest, rest) - slope * slope.transpose();
    const Axes other = axesOf(beyond);
    m_leadingComponents = static_cast<int>(main.toComponents.rows());
    const Eigen::Index count = m_leadingComponents, others = other.toComponents.rows();
    m_toComponents = Eigen::MatrixXd::Zero(count + others, channels);
    m_toComponents.topLeftCorner(count, first) = main.toComponents;
    m_toComponents.bottomLeftCorner(others, first) = -other.toComponents * slope * main.toComponents;
    m_toComponents.bottomRightCorner(others, rest) = other.toComponents;
    m_toChannels = Eigen::MatrixXd::Zero(channels, count + others);
    m_toChannels.topLeftCorner(first, count) = main.toChannels;
    m_toChannels.bottomLeftCorner(rest, count) = slope;
    m_toChannels.bottomRightCorner(rest, others) = other.toChannels;
}

void ChannelPca::project(const ImageView& from, std::span<const double> means, int first, int last,
                         Image& to) const {
    for (int y = first; y < last; ++y)
        mixRow(from, means, m_toComponents, {}, y, to);
}

void ChannelPca::unproject(const ImageView& from, std::span<const double> means, int first, int last,
                           Image& to) const {
    for (int y = first; y < last; ++y)
        mixRow(from, {}, m_toChannels, means, y, to);
}

} // namespace texloom

#include "core/network/tap_statistics.h"

#include "core/network/kernels.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr double kGainFloor = 0.1; ///< of the mean deviation, so that what hardly varies does not weigh most
constexpr int kRowsATask = 12;
constexpr std::size_t kPositionsBetweenChecks = 32 * kRowPiece;

} // namespace

void TapMoments::add(const TapMoments& other, double weight) {
    if (means.size() == 0) {
        means = Eigen::VectorXd::Zero(other.means.size());
        products = Eigen::MatrixXd::Zero(other.products.rows(), other.products.cols());
    }
    means += weight * other.means;
    products += weight * other.products;
}

TapMoments momentsOf(const Tensor& features, TapWorkspace& work, JobContext& context) {
    const int channels = features.channels();
    const auto plane = static_cast<std::ptrdiff_t>(features.area());
    const auto positions = static_cast<double>(features.area());
    TapMoments moments;
    moments.means.resize(channels);
    work.sums.assign(at(channels) * at(channels), 0.0);
    context.parallel(0, (channels + kRowsATask - 1) / kRowsATask, [&](int task) {
        const int first = task * kRowsATask, rows = std::min(kRowsATask, channels - first);
        // The matrix is symmetric: columns before the task's rows are those of other tasks.
        for (std::size_t begin = 0; begin < features.area(); begin += kPositionsBetweenChecks) {
            context.check();
            const float* const from = features.channel(first) + begin;
            addRowProducts({from, plane, rows, from, plane, channels - first,
                            std::min(kPositionsBetweenChecks, features.area() - begin),
                            work.sums.data() + at(first) * at(channels) + at(first), channels});
        }
        for (int c = first; c < first + rows; ++c) {
            double sum = 0;
            for (std::size_t begin = 0; begin < features.area(); begin += kRowPiece) {
                const std::size_t end = std::min(features.area(), begin + kRowPiece);
                float lanes[8] = {};
                std::size_t i = begin;
                for (; i + 8 <= end; i += 8)
                    for (std::size_t lane = 0; lane < 8; ++lane)
                        lanes[lane] += features.channel(c)[i + lane];
                for (; i < end; ++i)
                    lanes[0] += features.channel(c)[i];
                for (const float lane : lanes)
                    sum += static_cast<double>(lane);
            }
            moments.means[c] = sum / positions;
        }
    });
    moments.products.resize(channels, channels);
    for (int i = 0; i < channels; ++i)
        for (int j = i; j < channels; ++j)
            moments.products(i, j) = moments.products(j, i) =
                work.sums[at(i) * at(channels) + at(j)] / positions;
    return moments;
}

TapTarget::TapTarget(const TapMoments& exemplar, Statistic statistic) : m_statistic(statistic) {
    const Eigen::Index channels = exemplar.means.size();
    m_means = Eigen::VectorXd::Zero(channels);
    m_gains = Eigen::VectorXd::Ones(channels);
    if (statistic == Statistic::Normalised) {
        m_means = exemplar.means;
        const Eigen::VectorXd deviations =
            (exemplar.products.diagonal().array() - exemplar.means.array().square()).max(0.0).sqrt();
        const double typical = deviations.mean(), scale = exemplar.products.diagonal().maxCoeff();
        // Rounding alone leaves no more than this.
        if (typical <= 1e-4 * std::sqrt(scale))
            return;
        m_gains = 1 / (deviations.array() + kGainFloor * typical);
        m_meanUnit = 1 / static_cast<double>(channels);
    }
    m_wanted = Eigen::MatrixXd::Zero(channels, channels);
    m_wanted = difference(exemplar);
    const double square = m_wanted.squaredNorm();
    if (square > 0)
        m_unit = statistic == Statistic::Gram ? 1 / static_cast<double>(channels * channels) : 1 / square;
}

/// S − S* (or G − G*).
Eigen::MatrixXd TapTarget::difference(const TapMoments& moments) const {
    Eigen::MatrixXd moved = moments.products;
    moved.noalias() -= m_means * moments.means.transpose();
    moved.noalias() -= moments.means * m_means.transpose();
    moved.noalias() += m_means * m_means.transpose();
    return m_gains.asDiagonal() * moved * m_gains.asDiagonal() - m_wanted;
}

/// The mean of n.
Eigen::VectorXd TapTarget::shift(const TapMoments& moments) const {
    return m_gains.array() * (moments.means - m_means).array();
}

double TapTarget::distance(const TapMoments& moments) const {
    if (m_unit == 0)
        return 0;
    const double means = m_meanUnit == 0 ? 0 : m_meanUnit * shift(moments).squaredNorm();
    return m_unit * difference(moments).squaredNorm() + means;
}

Filters TapTarget::gradientFilters(const TapMoments& moments, std::size_t positions, double weight) const {
    const int channels = static_cast<int>(m_means.size());
    Filters filters = Filters::zero(channels, channels, 1);
    if (m_unit == 0)
        return filters;
    const double share = weight / static_cast<double>(positions);
    const Eigen::MatrixXd mix =
        m_gains.asDiagonal() * (4 * share * m_unit * difference(moments)) * m_gains.asDiagonal();
    Eigen::VectorXd bias = -mix * m_means;
    if (m_meanUnit != 0)
        bias.array() += 2 * share * m_meanUnit * m_gains.array() * shift(moments).array();
    for (int i = 0; i < channels; ++i) {
        filters.bias[at(i)] = static_cast<float>(bias[i]);
        for (int j = 0; j < channels; ++j)
            filters.at(i, j, 0, 0) = static_cast<float>(mix(i, j));
    }
    return filters;
}

} // namespace texloom

#include "core/math/conditional_gaussian.h"

#include <Eigen/Cholesky>

namespace texloom {

struct ConditionalGaussian::Factors {
    Eigen::LLT<Eigen::MatrixXd> gram; ///< of G + σ²I
    Eigen::VectorXd mean;
    double sigma;
};

ConditionalGaussian::ConditionalGaussian(std::span<const double> rows, int known,
                                         std::span<const double> difference, double sigma)
    : m_factors(std::make_unique<Factors>()) {
    const auto count = static_cast<Eigen::Index>(rows.size()) / known;
    const Eigen::Map<const Eigen::MatrixXd> columns(rows.data(), known, count);
    const Eigen::Map<const Eigen::VectorXd> offset(difference.data(), known);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
    gram.diagonal().array() += sigma * sigma;
    m_factors->gram.compute(gram);
    m_factors->mean = m_factors->gram.solve(columns.transpose() * offset);
    m_factors->sigma = sigma;
}

ConditionalGaussian::~ConditionalGaussian() = default;

std::vector<double> ConditionalGaussian::mean() const {
    return {m_factors->mean.data(), m_factors->mean.data() + m_factors->mean.size()};
}

std::vector<double> ConditionalGaussian::sample(std::span<const double> normals) const {
    Eigen::VectorXd drawn =
        Eigen::Map<const Eigen::VectorXd>(normals.data(), static_cast<Eigen::Index>(normals.size()));
    m_factors->gram.matrixU().solveInPlace(drawn);
    drawn = m_factors->mean + m_factors->sigma * drawn;
    return {drawn.data(), drawn.data() + drawn.size()};
}

} // namespace texloom

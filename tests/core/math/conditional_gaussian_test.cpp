#include "core/job/random.h"
#include "core/math/conditional_gaussian.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace texloom::test {
namespace {

Eigen::MatrixXd normalMatrix(int rows, int columns, std::uint64_t seed) {
    const Random random(seed);
    Eigen::MatrixXd matrix(rows, columns);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            matrix(i, j) = random.normal(i, j);
    return matrix;
}

std::span<const double> values(const Eigen::MatrixXd& matrix) {
    return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

Eigen::VectorXd vector(const std::vector<double>& from) {
    return Eigen::Map<const Eigen::VectorXd>(from.data(), static_cast<Eigen::Index>(from.size()));
}

/// A model with `known` entries given and `unknown` ones wanted.
struct Conditioned {
    Conditioned(int known, int unknown, int m, double deviation)
        : given(normalMatrix(known, m, 1)), wanted(normalMatrix(unknown, m, 2)),
          difference(normalMatrix(known, 1, 3)), sigma(deviation) {}

    /// (SΓRᵗ)(RΓRᵗ)⁻¹ by a dense Cholesky factor, with Γ = QQᵗ + σ²I.
    Eigen::MatrixXd gain() const {
        Eigen::MatrixXd gamma = given * given.transpose();
        gamma.diagonal().array() += sigma * sigma;
        return gamma.llt().solve(given * wanted.transpose()).transpose();
    }

    Eigen::MatrixXd given, wanted, difference;
    double sigma;
};

TEST(ConditionalGaussian, meanIsThatOfTheDenseSolution) {
    for (const int m : {1, 4, 12, 40})
        for (const double sigma : {0.03, 1.0}) {
            const Conditioned model(25, 18, m, sigma);
            const ConditionalGaussian conditional(values(model.given), 25, values(model.difference), sigma);
            const Eigen::VectorXd found = model.wanted * vector(conditional.mean());
            const Eigen::VectorXd dense = model.gain() * model.difference;
            EXPECT_LE((found - dense).cwiseAbs().maxCoeff(), 1e-8) << m << " coefficients, σ " << sigma;
        }
}

TEST(ConditionalGaussian, covarianceIsThatOfTheDenseSolution) {
    for (const int m : {1, 4, 12, 40})
        for (const double sigma : {0.03, 1.0}) {
            const Conditioned model(25, 18, m, sigma);
            const ConditionalGaussian conditional(values(model.given), 25, values(model.difference), sigma);
            const Eigen::VectorXd mean = vector(conditional.mean());
            Eigen::MatrixXd spread(m, m);
            for (int i = 0; i < m; ++i) {
                std::vector<double> unit(static_cast<std::size_t>(m), 0.0);
                unit[static_cast<std::size_t>(i)] = 1;
                spread.col(i) = vector(conditional.sample(unit)) - mean;
            }
            const Eigen::MatrixXd found = model.wanted * spread * (model.wanted * spread).transpose();
            const Eigen::MatrixXd dense = model.wanted * model.wanted.transpose() -
                                          model.gain() * model.given * model.wanted.transpose();
            EXPECT_LE((found - dense).cwiseAbs().maxCoeff(), 1e-8) << m << " coefficients, σ " << sigma;
        }
}

TEST(ConditionalGaussian, aVectorOfTheModelIsReproducedAsSigmaFalls) {
    const Conditioned model(30, 10, 8, 1);
    const Eigen::VectorXd coefficients = normalMatrix(8, 1, 7);
    const Eigen::VectorXd difference = model.given * coefficients;
    double last = 1e9;
    for (const double sigma : {1.0, 0.1, 0.001, 1e-6}) {
        const ConditionalGaussian conditional(values(model.given), 30, values(difference), sigma);
        const double error = (vector(conditional.mean()) - coefficients).cwiseAbs().maxCoeff();
        EXPECT_LT(error, last);
        last = error;
    }
    EXPECT_LE(last, 1e-9);
}

} // namespace
} // namespace texloom::test

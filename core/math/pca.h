#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace texloom {

/// The eigenvectors of a covariance, one per column, by decreasing variance, and the variances. Each
/// direction's largest component is positive, so that its sign does not depend on the solver.
struct CovarianceAxes {
    Eigen::MatrixXd directions;
    Eigen::VectorXd variances; ///< rounding may leave some a little below 0
};
CovarianceAxes covarianceAxes(const Eigen::MatrixXd& covariance);

/// The directions in which vectors vary most: the leading principal axes of their covariance.
struct PrincipalAxes {
    int dimension = 0;
    std::vector<double> mean;      ///< dimension
    std::vector<double> axes;      ///< count × dimension, one direction per row, orthonormal
    std::vector<double> variances; ///< count

    int count() const { return static_cast<int>(variances.size()); }
    std::span<const double> axis(int index) const {
        const auto length = static_cast<std::size_t>(dimension);
        return {axes.data() + static_cast<std::size_t>(index) * length, length};
    }
};

/// @param vectors one after another, each of `dimension` values; at least one. @param count of directions
/// wanted, at most `dimension`.
PrincipalAxes principalAxes(std::span<const double> vectors, int dimension, int count);

} // namespace texloom

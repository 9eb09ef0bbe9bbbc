#include "core/math/pca.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace texloom {

CovarianceAxes covarianceAxes(const Eigen::MatrixXd& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    CovarianceAxes axes{solver.eigenvectors().rowwise().reverse(), solver.eigenvalues().reverse()};
    for (Eigen::Index i = 0; i < axes.directions.cols(); ++i) {
        Eigen::Index largest = 0;
        axes.directions.col(i).cwiseAbs().maxCoeff(&largest);
        if (axes.directions(largest, i) < 0)
            axes.directions.col(i) *= -1;
    }
    return axes;
}

PrincipalAxes principalAxes(std::span<const double> vectors, int dimension, int count) {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto samples = static_cast<Eigen::Index>(vectors.size()) / dimension;
    const Eigen::Map<const Rows> data(vectors.data(), samples, dimension);
    const Eigen::RowVectorXd mean = data.colwise().mean();
    const Rows centred = data.rowwise() - mean;
    const Eigen::MatrixXd covariance = centred.transpose() * centred / static_cast<double>(samples);
    const CovarianceAxes all = covarianceAxes(covariance);

    PrincipalAxes result;
    result.dimension = dimension;
    result.mean.assign(mean.data(), mean.data() + dimension);
    for (int i = 0; i < count; ++i) {
        const double* axis = all.directions.col(i).data();
        result.axes.insert(result.axes.end(), axis, axis + dimension);
        result.variances.push_back(std::max(0.0, all.variances[i]));
    }
    return result;
}

} // namespace texloom

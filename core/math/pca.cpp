#include "core/math/pca.h"

#include <Eigen/Eigenvalues>

namespace texloom {

PrincipalAxes principalAxes(std::span<const double> vectors, int dimension, int count) {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto samples = static_cast<Eigen::Index>(vectors.size()) / dimension;
    const Eigen::Map<const Rows> data(vectors.data(), samples, dimension);
    const Eigen::RowVectorXd mean = data.colwise().mean();
    const Rows centred = data.rowwise() - mean;
    const Eigen::MatrixXd covariance = centred.transpose() * centred / static_cast<double>(samples);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);

    PrincipalAxes result;
    result.dimension = dimension;
    result.mean.assign(mean.data(), mean.data() + dimension);
    for (int i = 0; i < count; ++i) {
        const Eigen::Index column = dimension - 1 - i;
        Eigen::VectorXd axis = solver.eigenvectors().col(column);
        Eigen::Index largest = 0;
        axis.cwiseAbs().maxCoeff(&largest);
        if (axis[largest] < 0)
            axis = -axis;
        result.axes.insert(result.axes.end(), axis.data(), axis.data() + dimension);
        result.variances.push_back(std::max(0.0, solver.eigenvalues()[column]));
    }
    return result;
}

} // namespace texloom

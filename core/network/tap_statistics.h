#pragma once

#include "core/job/job_context.h"
#include "core/network/convolution.h"
#include "core/network/tensor.h"

#include <Eigen/Core>

namespace texloom {

/// How the feature maps F (channels × positions) of a tap are compared.
enum class Statistic {
    /// Mean and second moments of n = (F − μ*) / (σ* + 0.1 mean σ*), where * is of the exemplar:
    /// ‖S − S*‖² / ‖S*‖² + mean over channels of (mean n)², with S = n nᵀ / N.
    Normalised,
    Gram, ///< ‖G − G*‖² / M², with G = F Fᵀ / N and M channels (Gutierrez 2020, eqs. 4.1 and 4.2)
    Relative, ///< ‖G − G*‖² / ‖G*‖²
};

/// Means of the channels and of their products.
struct TapMoments {
    Eigen::VectorXd means;    ///< channels
    Eigen::MatrixXd products; ///< channels × channels: F Fᵀ / N

    void add(const TapMoments& other, double weight);
};

/// Working memory of comparing taps.
struct TapWorkspace {
    std::vector<double> sums;
    ConvolutionBuffers buffers;
    Tensor gradient;
};

/// The moments of feature maps; sums have a fixed order.
TapMoments momentsOf(const Tensor& features, TapWorkspace& work, JobContext& context);

/// What a tap of the exemplar is, and how far others are from it.
class TapTarget {
public:
    TapTarget() = default;
    TapTarget(const TapMoments& exemplar, Statistic statistic);

    /// The distance of feature maps with these moments. 0 where the exemplar has nothing there to compare.
    double distance(const TapMoments& moments) const;
    /// The distance's derivative by the feature maps that have these moments, times `weight`, is
    /// weights · F + bias: a convolution of side 1.
    Filters gradientFilters(const TapMoments& moments, std::size_t positions, double weight) const;

private:
    Eigen::MatrixXd difference(const TapMoments& moments) const;
    Eigen::VectorXd shift(const TapMoments& moments) const;

    Statistic m_statistic = Statistic::Normalised;
    Eigen::VectorXd m_means;  ///< μ*, or 0
    Eigen::VectorXd m_gains;  ///< 1 / (σ* + 0.1 mean σ*), or 1
    Eigen::MatrixXd m_wanted; ///< S* or G*
    double m_unit = 0;        ///< 1 / ‖S*‖², 1 / M² …; 0: nothing to compare
    double m_meanUnit = 0;    ///< 1 / M, or 0
};

} // namespace texloom

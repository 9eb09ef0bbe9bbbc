#pragma once

#include "core/math/steerable_pyramid.h"

#include <Eigen/Core>

#include <vector>

namespace texloom::portilla_simoncelli {

/// How to change variables X, given fixed variables Y, so that they have the wanted covariances:
/// X' = own X + other Y.
struct Mixing {
    Eigen::MatrixXd own;
    Eigen::MatrixXd other; ///< without columns where there is no Y
};

/// The symmetric map that takes one covariance to another and moves samples least (the optimal transport
/// between two Gaussians); this is the choice of the free orthogonal matrix in Portilla & Simoncelli 2000,
/// appendix A.3 that changes least.
Eigen::MatrixXd leastMap(const Eigen::MatrixXd& current, const Eigen::MatrixXd& wanted);

/// Gives X, of covariance xx and cross-covariance xy with Y, of covariance yy, the covariances wantedXx and
/// wantedXy (appendix A.4). Where both cannot be attained at once, the cross-covariance is kept.
Mixing mixingTo(const Eigen::MatrixXd& xx, const Eigen::MatrixXd& xy, const Eigen::MatrixXd& yy,
                const Eigen::MatrixXd& wantedXx, const Eigen::MatrixXd& wantedXy);

/// Autocorrelations of images of one scale of a pyramid, from and by their spectra. `check` is called every
/// few milliseconds and may throw. Lags are in units of 2^scale pixels whatever the sampling. A matrix of
/// reach r has (r + 1) rows for dy = 0 … r and 2r + 1 columns for dx = −r … r.
class Autocorrelator {
public:
    using Complex = SteerablePyramid::Complex;
    using Check = SteerablePyramid::Check;

    /// @param reach largest lag that is set; twice that is measured.
    Autocorrelator(const SteerablePyramid& pyramid, int scale, int reach);

    int reach() const { return m_reach; }
    /// Σ |X|² cos(ω · lag) for all lags up to 2 × reach.
    Eigen::MatrixXd measure(const Complex* spectrum, const Check& check) const;
    /// The central part for lags up to `reach`.
    static Eigen::MatrixXd central(const Eigen::MatrixXd& lags, int reach);
    /// Convolves with the zero-phase filter that gives the image the wanted autocorrelation (appendix A.5).
    /// @param current as returned by measure(). @param wanted of this reach or more.
    void impose(const Eigen::MatrixXd& current, const Eigen::MatrixXd& wanted, Complex* spectrum,
                const Check& check) const;
    /// Mean square of the image.
    double power(const Complex* spectrum, const Check& check) const;

private:
    double weight(int column) const;
    Eigen::MatrixXd filterFor(const Eigen::MatrixXd& current, const Eigen::MatrixXd& wanted) const;

    const SteerablePyramid& m_pyramid;
    int m_scale;
    int m_reach;
    std::vector<std::vector<float>> m_cosines, m_sines; ///< of dy × frequency, by dy and row
    Eigen::MatrixXd m_cosinesX, m_sinesX;               ///< of dx × frequency, by dx from 0 and column
};

} // namespace texloom::portilla_simoncelli

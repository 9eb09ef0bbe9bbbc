#pragma once

#include "core/base/message.h"
#include "core/methods/portilla_simoncelli/marginals.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace texloom::portilla_simoncelli {

/// The groups of statistics that can be imposed or left out, and are reported separately.
enum class Group {
    Marginals,                ///< moments and range of channels, components and low-pass images
    Autocorrelation,          ///< of components and low-pass images
    MagnitudeAutocorrelation, ///< of each band's magnitude, and its mean
    MagnitudeOrientations,    ///< magnitudes across orientations and channels
    MagnitudeScales,          ///< magnitudes with those one scale coarser
    BandOrientations,         ///< real parts across orientations and channels
    Phases,                   ///< real parts with the phase-doubled bands one scale coarser
};
inline constexpr std::size_t kGroups = 7;
Message titleOf(Group group);

/// Statistics of a low-pass image, or of a whole component.
struct ImageStatistics {
    Eigen::MatrixXd autocorrelation; ///< as Autocorrelator::central() gives it
    double skewness = 0;
    double kurtosis = 3;

    double variance() const { return autocorrelation(0, autocorrelation.rows() - 1); }
};

/// Statistics of the bands of one scale. Bands are ordered by component, then orientation; so are the
/// variables of the next scale, except at the coarsest scale, where they are each component's low-pass image
/// and its four neighbours (colour extension of the authors' code).
struct ScaleStatistics {
    std::vector<double> magnitudeMeans;
    std::vector<Eigen::MatrixXd> magnitudeAutocorrelations;
    Eigen::MatrixXd magnitudes, magnitudesNext, nextMagnitudes; ///< with themselves, with the next scale's,
                                                                ///< and of the next scale's
    Eigen::MatrixXd reals, realsNext, nextReals;                ///< the same for real parts
};

/// All that the method knows of a texture (Portilla & Simoncelli 2000, section 2; with several channels as in
/// the authors' colour extension and Vacher & Briand, IPOL 2021, appendix B). Components are those of a
/// ChannelPca and have variance 1.
struct Statistics {
    std::vector<Moments> channels;
    std::vector<Moments> components;
    std::vector<ImageStatistics> whole;               ///< by component
    std::vector<double> highVariances;                ///< of the high residuals
    std::vector<std::vector<ImageStatistics>> images; ///< low-pass images by scale, 0 to S, and component
    Eigen::MatrixXd low; ///< covariance of the low residuals and their neighbours, five for each component
    std::vector<ScaleStatistics> scales;

    /// Goes `share` of the way to other statistics of the same shape.
    void mix(const Statistics& other, double share);
};

/// Low-pass images whose variance is at most this, of 1 for the component, are too faint to be adjusted.
inline constexpr double kLeastVariance = 1e-4;

using Deviations = std::array<double, kGroups>;

/// How far statistics are from wanted ones, by group: the root mean square over its statistics of the
/// relative deviation. A matrix counts as one statistic, by its norm; covariances with another scale are
/// relative to the norms of both scales' own; skewness is relative to 1 + its modulus, means to standard
/// deviations.
Deviations deviations(const Statistics& measured, const Statistics& wanted);

} // namespace texloom::portilla_simoncelli

#pragma once

#include "core/image/image.h"

#include <Eigen/Core>

#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// The covariance of the channels of an image, normalised by the number of pixels. @param check called for
/// every row.
Eigen::MatrixXd channelCovariance(
    const ImageView& image, const std::function<void()>& check = [] {});

/// Principal components of an image's channels: uncorrelated, each with variance 1 where the image has the
/// covariance that they were made from. Directions in which there is next to no variance are left out, so
/// that a grey picture in three equal channels has one component, and a constant picture none.
class ChannelPca {
public:
    /// @param leading if not 0, this many of the first channels come first: the first leadingComponents()
    /// components are those of these channels alone, the others those of the other channels' residuals after
    /// linear regression on these.
    explicit ChannelPca(const Eigen::MatrixXd& covariance, int leading = 0);

    /// Number of components, at most the number of channels; the first has the most variance.
    int components() const { return static_cast<int>(m_toComponents.rows()); }
    /// components() where all channels lead.
    int leadingComponents() const { return m_leadingComponents; }

    /// Components of the rows [first, last) of `from`: those of (pixel − mean). Rows may be done by several
    /// threads. @param means one per channel. @param to has components() channels and the size of `from`.
    void project(const ImageView& from, std::span<const double> means, int first, int last, Image& to) const;
    /// The inverse: mean + mix of the components. @param to has one channel per mean.
    void unproject(const ImageView& from, std::span<const double> means, int first, int last,
                   Image& to) const;

private:
    int m_leadingComponents = 0;
    Eigen::MatrixXd m_toComponents; ///< components × channels
    Eigen::MatrixXd m_toChannels;   ///< channels × components
};

} // namespace texloom

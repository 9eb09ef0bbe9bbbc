#pragma once

#include "core/image/image.h"

#include <functional>
#include <vector>

namespace texloom {

/// How an exemplar becomes a spot.
struct SpotOptions {
    bool periodic = true;    ///< take the exemplar's periodic component instead of the exemplar itself
    double transition = 0.1; ///< share of each side over which an extended spot fades out
};

/// The exemplar as a spot that is laid on a torus of any size (Galerne, Gousseau & Morel 2011, section V):
/// its mean is subtracted, and along every axis on which the torus has another length its borders fade out.
/// On a smaller torus the spot is folded: pixels a whole number of periods apart add up. Values are scaled by
/// one factor for all channels, so that the sum of the channels' variances on the torus is the exemplar's.
class PhaseSpot {
public:
    /// The torus to draw on for an output. One that is smaller than the exemplar and need not wrap is cut
    /// from a torus of the exemplar's size, because folding the spot would let it meet itself.
    static Size torusFor(Size exemplar, Size output, Wrap wrap);

    /// @param check called every few milliseconds; may throw.
    PhaseSpot(const ImageView& exemplar, Size torus, const SpotOptions& options,
              const std::function<void()>& check);

    /// The exemplar's mean of a channel, which the spot lacks.
    double mean(int channel) const { return m_means[static_cast<std::size_t>(channel)]; }
    /// Rows of the torus on which the spot lies; the rest is 0.
    int rows() const;
    /// Writes a channel of the spot to a plane of the torus's size whose samples are 0.
    void write(int channel, const PlaneSpan& plane) const;

    /// Bytes that a PhaseSpot takes, at most, while it is made.
    static std::uint64_t bytesFor(Size exemplar, int channels);

private:
    void fade(const ImageView& exemplar, double share);
    void scaleToVariance(const std::function<void()>& check);

    Image m_values; ///< of the exemplar's size, without mean, faded and scaled
    Size m_torus;
    std::vector<double> m_means;
    double m_variance = 0; ///< sum over channels, before fading
};

} // namespace texloom

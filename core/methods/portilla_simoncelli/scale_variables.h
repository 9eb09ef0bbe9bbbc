#pragma once

#include "core/job/job_context.h"
#include "core/math/steerable_pyramid.h"
#include "core/methods/portilla_simoncelli/correlations.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace texloom::portilla_simoncelli {

/// Which variables of a scale are considered together with those of the next one.
enum class Kind { Magnitudes, Reals };

/// The first samples of a buffer as an image of a scale of a pyramid.
PlaneSpan spanOf(const SteerablePyramid& pyramid, int scale, const FftBuffer<float>& buffer);

/// The variables of one scale whose covariances count: the magnitudes and real parts of its bands, and those
/// of the next scale, interpolated to it, which serve only for comparison. Bands are ordered by component,
/// then orientation. Below the coarsest bands lie the low residuals: their magnitudes have no next ones,
/// their real parts each component's low residual and its neighbours. Its memory is reused for one scale
/// after the other.
class ScaleVariables {
public:
    using Complex = SteerablePyramid::Complex;
    using Spectrum = FftBuffer<Complex>;

    ScaleVariables(const SteerablePyramid& pyramid, int components, JobContext& context);

    int bands() const { return m_components * m_pyramid.orientations(); }
    /// Variables of the next scale that go with one kind of a scale's.
    int nextCount(int scale, Kind kind) const;
    PlaneSpan magnitude(int scale, int band) const;
    /// The cosines of a band's phase, until they are multiplied by its magnitude.
    PlaneSpan real(int scale, int band) const;

    /// Sets a band's magnitude and the cosine of its phase from the spectrum of its component.
    /// @return the mean of the magnitude.
    double split(int scale, int band, const Spectrum& component);
    /// Interpolates a band of the next scale and doubles its phase, so that it turns as fast as this scale's.
    void splitNext(int scale, int band, const Spectrum& next);
    /// Interpolates a component's low residual and its neighbours.
    void splitLow(int scale, int component, const Spectrum& low);

    /// Of this scale's variables, then of the next one's. Magnitudes count without their means.
    Eigen::MatrixXd covariance(int scale, Kind kind) const;
    /// Changes this scale's variables, using those of the next one as well.
    void mix(int scale, Kind kind, const Mixing& mixing);

    /// Bytes that an object takes for a pyramid whose finest scale has planes of this many bytes.
    static std::uint64_t bytesFor(std::uint64_t plane, int scales, int components, int orientations);

private:
    using Plane = FftBuffer<float>;
    using Samples = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    /// Pixels that are read at a time: a rectangle in one scale.
    struct Block {
        int left, top, right, bottom;
    };

    bool coarsest(int scale) const { return scale + 1 == m_pyramid.scales(); }
    int blockCount(int scale) const;
    Block block(int scale, int index) const;
    void overBlocks(int scale, int part, int parts, const std::function<void(const Block&)>& body) const;
    float meanOf(Kind kind, int band) const;
    const Plane& plane(Kind kind, int band) const;
    void gather(int scale, Kind kind, const Block& block, Samples& samples) const;
    void gatherNext(int scale, Kind kind, const Block& block, int y, Samples& samples) const;
    void scatter(int scale, Kind kind, const Block& block, const Samples& samples);

    const SteerablePyramid& m_pyramid;
    int m_components;
    JobContext& m_context;
    std::function<void()> m_check;
    std::vector<Plane> m_magnitudes;          ///< by band
    std::vector<Plane> m_reals;               ///< the same; cosines of the phase before
    std::vector<Plane> m_next;                ///< two for each band, or the low residuals' neighbours
    std::vector<double> m_means, m_nextMeans; ///< of magnitudes
};

} // namespace texloom::portilla_simoncelli

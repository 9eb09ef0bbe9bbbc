#pragma once

#include "core/job/job_context.h"
#include "core/math/histogram.h"
#include "core/math/steerable_pyramid.h"

#include <functional>
#include <vector>

namespace texloom::heeger_bergen {

/// All parts of one channel's pyramid, decomposed and put together again on the job's threads: the high
/// residual, every oriented band, the low residual.
class BandStack {
public:
    BandStack(const SteerablePyramid& pyramid, JobContext& context);

    /// Number of parts.
    int parts() const { return static_cast<int>(m_parts.size()); }
    /// Calls visit(part, plane) for every part of `image`, on several threads. With `keep`, what visit makes
    /// of the plane is kept for synthesise().
    void analyse(const PlaneView& image, bool keep,
                 const std::function<void(int part, const PlaneSpan& plane)>& visit);
    /// Reconstructs the image from the kept parts.
    void synthesise(const PlaneSpan& image);

    static std::uint64_t bytesFor(Size size, int scales, int orientations, int threads);

private:
    using Spectrum = FftBuffer<SteerablePyramid::Complex>;
    struct Part {
        int scale;
        int orientation; ///< or kHigh or kLow
        Spectrum spectrum;
    };
    static constexpr int kHigh = -1, kLow = -2;

    void decompose(const PlaneView& image);

    const SteerablePyramid& m_pyramid;
    JobContext& m_context;
    std::vector<Part> m_parts;       ///< large ones first
    std::vector<Spectrum> m_spectra; ///< input of each scale
};

} // namespace texloom::heeger_bergen

#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/match/patch_source.h"
#include "core/math/fft.h"
#include "core/math/histogram.h"

#include <Eigen/Core>

#include <complex>
#include <cstdint>
#include <vector>

namespace texloom::sparse {

/// The terms of the energy of Tartavel, Gousseau & Peyré (2013), eq. 3, that concern the image alone. Each
/// adds half its gradient times a weight to an image, and says its energy.

/// α W₂²(μ_u, μ_u0): the distance between the distributions of colours, along orthogonal axes (eq. 5).
class HistogramTerm {
public:
    /// @param exemplar whose pixels count where the mask leaves them. @param principal along the principal
    /// axes of its colours, rather than its channels.
    HistogramTerm(const PatchSource& exemplar, bool principal, JobContext& context);

    /// gradient += weight × (u − T(u)), where T gives u the exemplar's distribution along each axis.
    /// @return W₂².
    double add(const Image& image, double weight, JobContext& context, Image& gradient);

    static std::uint64_t bytesFor(Size exemplar, Size output, int channels, int threads);

private:
    Image alongAxes(const ImageView& image, JobContext& context) const;

    Eigen::MatrixXf m_axes; ///< one per column
    std::vector<Histogram> m_wanted;
};

/// β |h ⋆ (u − v)|² with the box h of τ × τ pixels. Beyond borders that do not wrap, u is v.
class LowPassTerm {
public:
    /// @param target v, of the output's size at this scale.
    LowPassTerm(Image target, Wrap wrap, int patch)
        : m_target(std::move(target)), m_wrap(wrap), m_patch(patch) {}

    /// gradient += weight × h̄ ⋆ h ⋆ (u − v), h̄(x) = h(−x). @return |h ⋆ (u − v)|².
    double add(const Image& image, double weight, JobContext& context, Image& gradient) const;

    static std::uint64_t bytesFor(Size output, int channels, int patch);

private:
    Image m_target;
    Wrap m_wrap;
    int m_patch;
};

/// γ |u − S(u)|²: the distance to the nearest image that has the exemplar's Fourier moduli and its phase
/// differences between channels (Tartavel, Gousseau & Peyré, "Variational texture synthesis with sparsity and
/// spectrum constraints", JMIV 2015).
class SpectrumTerm {
public:
    /// @param size of the output at this scale; the exemplar is laid on a torus of it (see PhaseSpot).
    SpectrumTerm(const ImageView& exemplar, Size size, JobContext& context);

    /// gradient += weight × (u − S(u)). @return |u − S(u)|².
    double add(const Image& image, double weight, JobContext& context, Image& gradient);

    static std::uint64_t bytesFor(Size exemplar, Size output, int channels);

private:
    using Complex = std::complex<float>;

    void nearest(int column);

    RealFft2d m_fft;
    Image m_image;
    std::vector<FftBuffer<Complex>> m_wanted, m_spectra; ///< one per channel
};

/// The exemplar with random phases (Galerne, Gousseau & Morel 2011), the same in all channels, at any size.
/// @param random draws the phases.
Image randomPhaseOf(const ImageView& exemplar, Size size, Wrap wrap, const Random& random,
                    JobContext& context);
std::uint64_t randomPhaseBytes(Size exemplar, Size size, Wrap wrap, int channels);

} // namespace texloom::sparse

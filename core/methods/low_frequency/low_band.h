#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/math/fft.h"
#include "core/math/phase_spot.h"
#include "core/math/smooth_spectrum.h"
#include "core/methods/low_frequency/settings.h"

#include <complex>
#include <vector>

namespace texloom::low_frequency {

/// Changes the low band of an image on a torus: takes its own off and puts one of random phases in its place,
/// u − (s + p ∗ G_θ) + (spot ∗ G_θ) turned by random phases (Raad, thesis 2016, section 5.7). What is taken
/// off is smooth, so that the high band stays to the last bits.
class LowBand {
public:
    /// @param size of the image and the torus.
    LowBand(Size size, const Settings& settings, JobContext& context);

    /// Changes every channel of `image`. @param spot what the new band is made from; null: the image itself.
    /// @param visible the part that previews show. @param weight of the stages.
    void change(Image& image, const PhaseSpot* spot, Size visible, double weight);

    static std::uint64_t bytesFor(Size size, bool spot);

private:
    using Complex = RealFft2d::Complex;

    void drawFactors();
    void forward(const PlaneView& plane, Complex* spectrum);
    void transformSpot(const PhaseSpot& spot, int channel);
    void changeColumn(int column, const SmoothSpectrum* smooth, const PhaseSpot* spot, int channel);
    void subtract(const PlaneSpan& plane);

    const Settings& m_settings;
    JobContext& m_context;
    RealFft2d m_fft;
    std::vector<float> m_alongX, m_alongY; ///< the Gaussian's transform along each axis
    FftBuffer<Complex> m_factors, m_spectrum, m_spot;
    Image m_plane;
};

} // namespace texloom::low_frequency

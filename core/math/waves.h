#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"

#include <complex>
#include <functional>
#include <vector>

namespace texloom {

/// A plane wave: Re(F_c e^(2πi b·x)) in channel c, pixels x counted from the image's top left.
struct Wave {
    double x = 0, y = 0;                         ///< b in cycles per pixel
    std::vector<std::complex<double>> strengths; ///< F, by channel
    double uncertainty = 0;                      ///< standard error of b, in cycles per pixel
};

/// A picture as its means and a few waves: its regular part, of any size (Nicoll, Meseth, Müller & Klein,
/// "Fractional Fourier texture masks", 2005).
struct WaveModel {
    std::vector<double> means; ///< by channel
    std::vector<Wave> waves;   ///< the strongest first
    double share = 0;          ///< of the variance that the waves are
};

/// Which waves are looked for.
struct WaveOptions {
    double threshold = 0.25; ///< least height of a peak of the spectrum, over the highest
    int most = 24;           ///< waves
};

/// Finds the waves in an image: peaks of the spectrum of the windowed and zero-padded image, refined by
/// Gauss–Newton steps on the sum of squared differences until no frequency moves by more than 1e-4 cycles per
/// side, with strengths by joint least squares and the mean of what the waves leave; then again in what is
/// left. Waves of less than one cycle per side are shading, and left out.
/// @param mask one channel of the image's size, or {}: pixels where it is 0 do not count.
/// @param check called every few milliseconds; may throw.
WaveModel findWaves(const ImageView& image, const PlaneView& mask, const WaveOptions& options,
                    const std::function<void()>& check);

/// The model with frequencies moved to whole numbers of cycles per side on the axes that wrap.
/// @param largestMove how far one was moved at most, in cycles per side.
WaveModel closed(const WaveModel& model, Size size, Wrap wrap, double& largestMove);

/// The picture that a model makes of pixels (x, y) to (x + width − 1, y + height − 1).
Image drawn(const WaveModel& model, const Region& region, JobContext& context);

/// Bytes that findWaves() takes.
std::uint64_t findWavesBytes(Size size, int channels, const WaveOptions& options);

} // namespace texloom

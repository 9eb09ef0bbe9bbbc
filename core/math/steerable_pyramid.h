#pragma once

#include "core/image/size.h"
#include "core/math/fft.h"

#include <complex>
#include <functional>
#include <vector>

namespace texloom {

/// The steerable pyramid in the Fourier domain (Simoncelli & Freeman, ICIP 1995; Portilla & Simoncelli, IJCV
/// 40, 2000, section 1.1): the filters of one image size, and the steps from which analysis and synthesis are
/// made.
///
///     image ─┬─ H₀ ─ high residual (scale 0)
///            └─ L₀ ─┬─ oriented bands 0 … K−1 (scale 0)
///                   └─ L, every second pixel ─┬─ oriented bands (scale 1)
///                                             └─ … low residual (scale S)
///
/// Radial filters are raised cosines of one octave; the angular ones are |cos|^(K−1). The filters are
/// self-inverting, so that synthesis applies the same filters once more, and tight: the mean square of an
/// image is the sum of the mean squares of its high residual, its bands and its low residual. Reconstruction
/// is exact to rounding.
///
/// Images of any size are taken as periodic. Filters are defined by frequency in cycles per pixel of the
/// image and not by index, so that bands of images of different sizes can be compared. Scale s has ⌈width /
/// 2^s⌉ × ⌈height / 2^s⌉ samples: on sides that 2^s does not divide its samples lie a little closer than 2^s
/// pixels, so that no frequency that passes the filters is lost or aliased, and nothing is padded.
///
/// A spectrum is in the layout of fft(scale) and divided by the number of samples: bin 0 holds the mean. All
/// members are thread-safe. `check` is called every few milliseconds and may throw.
class SteerablePyramid {
public:
    using Complex = std::complex<float>;
    using Check = std::function<void()>;

    /// @param scales at most largestScales(). @param orientations from 1 up. @param check called every few
    /// milliseconds; may throw.
    SteerablePyramid(
        Size size, int scales, int orientations, const Check& check = [] {});

    /// The most scales for which the low residual still has 4 samples along the shorter side; at least 1.
    static int largestScales(Size size);

    int scales() const { return static_cast<int>(m_levels.size()) - 1; }
    int orientations() const { return m_orientations; }
    /// Size of the bands of a scale; of the low residual for scale = scales().
    Size size(int scale) const { return fft(scale).size(); }
    const RealFft2d& fft(int scale) const { return m_levels[static_cast<std::size_t>(scale)].fft; }
    const ComplexFft2d& complexFft(int scale) const {
        return m_levels[static_cast<std::size_t>(scale)].complexFft;
    }
    /// A new spectrum of a scale, all 0.
    FftBuffer<Complex> spectrum(int scale) const;
    /// Frequency of a column or a row of a scale's spectrum in radians per 2^scale pixels, between −π and π
    /// except on sides that 2^scale does not divide, where the outermost ones lie just beyond.
    double frequencyX(int scale, int column) const;
    double frequencyY(int scale, int row) const;

    /// The spectrum of a real image of a scale's size, rows fft(scale).rowStride() apart.
    void forward(int scale, const float* image, Complex* spectrum, const Check& check) const;
    /// The image of a spectrum, which is destroyed.
    void backward(int scale, Complex* spectrum, float* image, const Check& check) const;

    /// spectrum × H₀, for the high residual of the whole image.
    void takeHigh(const Complex* whole, Complex* high, const Check& check) const;
    /// whole += high × H₀.
    void addHigh(const Complex* high, Complex* whole, const Check& check) const;
    /// In place × the low-pass filter that a scale's image went through: L₀ for scale 0, L for the others.
    void limit(int scale, Complex* spectrum, const Check& check) const;
    /// The spectrum of the next scale: × L, and without what is beyond its reach.
    void lower(int scale, const Complex* spectrum, Complex* next, const Check& check) const;
    /// spectrum += next unchanged, which belongs to the next scale: interpolation by zero padding.
    void raise(int scale, const Complex* next, Complex* spectrum, const Check& check) const;
    /// The spectrum of a real oriented band. Orientation k responds most to frequencies at the angle πk / K,
    /// measured from the x axis to the y axis.
    void takeBand(int scale, int orientation, const Complex* spectrum, Complex* band,
                  const Check& check) const;
    /// spectrum += band through the same filter backwards.
    void addBand(int scale, int orientation, const Complex* band, Complex* spectrum,
                 const Check& check) const;
    /// The complex band whose real part is the real band and whose imaginary part is its Hilbert transform
    /// along the orientation, as an image of complexFft(scale).
    void analyticBand(int scale, int orientation, const Complex* spectrum, Complex* image,
                      const Check& check) const;
    /// The complex image whose real part has this spectrum of scale + 1, interpolated to `scale`, and whose
    /// imaginary part is its Hilbert transform along the orientation.
    void analyticRaised(int scale, int orientation, const Complex* next, Complex* image,
                        const Check& check) const;

    /// Bytes that an object takes.
    static std::uint64_t bytesFor(Size size, int scales, int orientations);

private:
    struct Level {
        RealFft2d fft;
        ComplexFft2d complexFft;
        std::vector<float> limit;
        std::vector<std::vector<float>> bands; ///< by orientation, without their power of −i
    };

    void makeFilters(int scale, bool last, const Check& check);
    void addFiltered(int scale, int orientation, const Complex* from, bool backwards, Complex* to,
                     const Check& check) const;
    void layOneSided(int scale, int orientation, const Complex* half, int halfScale, Complex* image,
                     const Check& check) const;
    std::size_t at(int scale, int column) const {
        return static_cast<std::size_t>(column * fft(scale).columnStride());
    }

    Size m_size;
    int m_orientations;
    std::vector<Level> m_levels;
    std::vector<float> m_high;
};

/// The size to synthesise at for an output: on an axis that wraps the output's own, on others the next size
/// that 2^scales divides and FFTW transforms fast, with room for a low residual; the excess is cropped
/// afterwards.
Size pyramidCanvas(Size output, bool wrapX, bool wrapY, int scales);

/// The most scales, up to `wanted`, that an exemplar allows, and an output on the axes on which it wraps.
int commonScales(int wanted, Size exemplar, Size output, bool wrapX, bool wrapY);

} // namespace texloom

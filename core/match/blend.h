#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/match/blend_curve.h"
#include "core/math/poisson.h"

#include <functional>
#include <memory>
#include <vector>

namespace texloom {

/// How two pictures meet along a curve.
enum class BlendMethod {
    Cut,     ///< along the path of least error within the band (Efros & Freeman 2001)
    Poisson, ///< with the gradients of both (Pérez, Gangnet & Blake 2003)
    Midway,  ///< both deformed until they agree (Raad, thesis 2016, chapter 4)
    Edge     ///< not at all: as they are on either side of the curve, to compare with
};

/// How midway blending fades the deformation out towards the border of the band: the deformation itself falls
/// off (eq. 4.7), or lines pass from the middle signal to that on the border (eq. 4.9).
enum class Propagation { Linear, Progressive };

/// The colour axes that midway blending treats one by one: as they are, the cosine axes of section 4.3.4, or
/// the principal axes of both pictures near the curve.
enum class BlendColor { Rgb, Dct, Pca };

struct MidwayOptions {
    Propagation propagation = Propagation::Linear;
    BlendColor color = BlendColor::Dct;
};

/// A curve through two pictures of the same size with the band around it in which they may change. Beyond the
/// band each picture stays as it is, bit for bit. One object may be used by any number of threads.
class BlendBand {
public:
    /// Called every few milliseconds with the share done; may throw.
    using Progress = std::function<void(double)>;

    /// @param width to either side of the curve, in pixels.
    BlendBand(
        BlendCurve curve, Size size, int width, const Progress& progress = [](double) {});

    /// Blends `first` and `second` into `to`. All three have the band's size and the same channels; pixels
    /// are written on and beyond the curve's right side and within the band only, the others must be the
    /// first's already.
    void cut(
        const ImageView& first, const ImageView& second, Image& to,
        const Progress& progress = [](double) {}) const;
    void edge(
        const ImageView& second, Image& to, const Progress& progress = [](double) {}) const;
    void poisson(
        const ImageView& first, const ImageView& second, Image& to,
        const Progress& progress = [](double) {}) const;
    void midway(
        const ImageView& first, const ImageView& second, const MidwayOptions& options, Image& to,
        const Progress& progress = [](double) {}) const;

    /// Sets to 1 what lies on the first picture's side of the curve. @param to of the band's size.
    void markFirst(PlaneSpan to) const;
    /// Factors the equations that poisson() solves, for a small band that is used often; otherwise it
    /// iterates. Not to be called while other threads use the band.
    void preparePoisson();

private:
    struct Pixel {
        int x, y;
        BlendCurve::Place place;
    };
    /// Pixels [first, last) of a row.
    struct Run {
        int y, first, last;
    };
    /// Lines along the curve at distances 0 … width on one side, by distance, channel and length.
    struct Lines {
        int count = 0, channels = 0, length = 0;
        std::vector<float> values;
        float* line(int distance, int channel) {
            return values.data() + (static_cast<std::size_t>(distance) * static_cast<std::size_t>(channels) +
                                    static_cast<std::size_t>(channel)) *
                                       static_cast<std::size_t>(length);
        }
    };

    int lineLength() const;
    Lines sample(const ImageView& image, int side, const Progress& progress) const;
    std::vector<std::uint8_t> bandMask() const;
    std::vector<std::uint8_t> beyondMask() const;
    /// Visits the pixels of the band.
    template <class Visit> void everyPixel(const std::function<void()>& check, const Visit& visit) const;
    void compose(const ImageView& second, Image& to, const std::function<void()>& check) const;
    std::vector<float> divergence(const ImageView& first, const ImageView& second,
                                  const Progress& progress) const;
    float change(Lines& changes, const BlendCurve::Place& place, int channel) const;
    static void change(Lines& lines, const std::vector<double>& places, const std::vector<float>& middle,
                       int channel, Propagation propagation, const Progress& progress);

    BlendCurve m_curve;
    Size m_size;
    int m_width;
    std::vector<Pixel> m_band; ///< pixels nearer to the curve than the width, by rows
    std::vector<Run> m_beyond; ///< pixels on the second side, by rows
    std::shared_ptr<const PoissonRegion> m_region;
};

/// How two whole pictures are to meet.
struct BlendOptions {
    BlendMethod method = BlendMethod::Midway;
    int band = 32;
    MidwayOptions midway;
};

/// Blends whole pictures along a curve. @param context its stage and progress are set.
/// @throws UsageError if the pictures differ in size, or the band is wider than they allow.
Image blendAlong(const ImageView& first, const ImageView& second, const BlendCurve& curve,
                 const BlendOptions& options, JobContext& context);
/// What blendAlong() refuses. @throws UsageError that names the value and the limit
void checkBlend(Size first, Size second, const BlendOptions& options);

/// Upper bound of the memory that blendAlong() takes.
std::uint64_t blendBytesFor(Size size, int channels, const BlendOptions& options);

} // namespace texloom

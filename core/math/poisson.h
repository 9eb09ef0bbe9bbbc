#pragma once

#include "core/image/image.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace texloom {

/// Poisson's equation Δf = g on some pixels of an image, the other pixels being given (Pérez, Gangnet &
/// Blake, SIGGRAPH 2003). Δ is the sum of the differences to the neighbours above, below, left and right that
/// the image has: there is no flux across its border. The equations are factored once and serve any number of
/// images and threads.
class PoissonRegion {
public:
    /// @param unknown by rows, not 0 where f is wanted. Every connected part must touch a given pixel.
    PoissonRegion(const std::vector<std::uint8_t>& unknown, Size size);
    ~PoissonRegion();
    PoissonRegion(PoissonRegion&&) noexcept;
    PoissonRegion& operator=(PoissonRegion&&) noexcept;

    /// Replaces the unknown pixels of `values`; the others stay, bit for bit.
    /// @param divergence g at the unknown pixels, by rows.
    void solve(std::span<const float> divergence, PlaneSpan values) const;

private:
    struct Factors;
    std::unique_ptr<Factors> m_factors;
};

/// The same for a region that is solved once, and may be large: by conjugate gradients preconditioned by
/// multigrid (see Multigrid), in a number of steps that hardly depends on the size, until no residual is
/// above 1e-7 of the values' range. The unknown pixels of `values` are the starting point.
/// @param divergence g at the unknown pixels by rows, one channel after another. @param progress called with
/// 0 to 1 every few milliseconds; may throw.
void solvePoisson(
    const std::vector<std::uint8_t>& unknown, std::span<const float> divergence, Image& values,
    const std::function<void(double)>& progress = [](double) {});

/// Upper bound of the memory that this solvePoisson() takes beside its values, for so many unknown pixels,
/// with a divergence that has grown value by value.
std::uint64_t regionPoissonBytes(std::uint64_t unknown, int channels);

/// What lies beyond the border of a picture all of whose pixels are unknown.
enum class PoissonBorder {
    NoFlux, ///< nothing: differences over the border are 0
    Wraps   ///< the opposite border
};

/// The same with every pixel unknown, by cosine transforms, or where the picture wraps by Fourier transforms:
/// f is known up to a constant, and gets the means given, one a channel. The divergence's own mean, which no
/// f can have, is subtracted. No residual is above 1e-6 of the largest divergence or of f's range.
/// @param progress called with 0 to 1 every few milliseconds; may throw.
Image solvePoisson(
    const ImageView& divergence, const std::vector<double>& means,
    PoissonBorder border = PoissonBorder::NoFlux,
    const std::function<void(double)>& progress = [](double) {});

/// Upper bound of the memory that this solvePoisson() takes beside its result.
std::uint64_t wholePoissonBytes(Size size, PoissonBorder border);

} // namespace texloom

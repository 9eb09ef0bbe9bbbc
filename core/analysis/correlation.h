#pragma once

#include "core/image/image.h"

#include <functional>
#include <vector>

namespace texloom {

/// The generalised normalised cross-correlation γ of two images f and g at every displacement at which they
/// overlap (López Recas 2011, section 3.1): −1 to 1, 0 where the overlap of one of them is constant.
class Correlation {
public:
    Correlation() = default;
    Correlation(Size f, Size g);

    /// Displacements go from (−left(), −top()) to (right(), bottom()): pixel (x, y) of f lies on
    /// (x − dx, y − dy) of g.
    int left() const { return m_g.width - 1; }
    int top() const { return m_g.height - 1; }
    int right() const { return m_f.width - 1; }
    int bottom() const { return m_f.height - 1; }
    bool contains(int dx, int dy) const {
        return dx >= -left() && dx <= right() && dy >= -top() && dy <= bottom();
    }
    float at(int dx, int dy) const { return m_values[index(dx, dy)]; }
    float& at(int dx, int dy) { return m_values[index(dx, dy)]; }
    /// γ between displacements, interpolated bilinearly; the four around it must be in range.
    double between(double dx, double dy) const;
    /// The part of f that g covers.
    Size overlap(int dx, int dy) const;
    const Size& size() const { return m_f; }

    /// γ as one channel, −1 to 1, displacement (0, 0) at column left() and row top().
    Image picture() const;

private:
    std::size_t index(int dx, int dy) const {
        return static_cast<std::size_t>(dy + top()) * m_stride + static_cast<std::size_t>(dx + left());
    }

    Size m_f, m_g;
    std::size_t m_stride = 0;
    std::vector<float> m_values;
};

/// γ of `f` and `g`, which need not have the same size. Channels are combined as the sum of their numerators
/// over the sum of their denominators (eq. 3.13), so that a channel without structure has no weight. The
/// correlation is computed with one Fourier transform per channel, all other sums with integral images.
/// @param check called every few milliseconds; may throw.
Correlation correlate(
    const ImageView& f, const ImageView& g, const std::function<void()>& check = [] {});

/// γ of an image with itself: 1 at (0, 0), and γ(x) = γ(−x).
Correlation autocorrelation(
    const ImageView& image, const std::function<void()>& check = [] {});

} // namespace texloom

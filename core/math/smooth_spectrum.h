#pragma once

#include "core/image/image.h"

#include <complex>
#include <vector>

namespace texloom {

/// The spectrum of the smooth component s of an image u = p + s (see periodicComponent()), one frequency at a
/// time: s solves Poisson's equation for the jumps across the borders, whose transform is that of two lines.
/// So p can be obtained from the spectrum of u without an image of s.
class SmoothSpectrum {
public:
    explicit SmoothSpectrum(const PlaneView& image);

    /// Unnormalised, column 0 … width / 2, row 0 … height − 1.
    std::complex<float> at(int column, int row) const {
        const auto k = static_cast<std::size_t>(column), l = static_cast<std::size_t>(row);
        if (k + l == 0)
            return 0;
        return (m_below[k] * m_stepsY[l] + m_beside[l] * m_stepsX[k]) / (m_laplacianX[k] + m_laplacianY[l]);
    }

private:
    using Values = std::vector<std::complex<float>>;
    Values m_below;  ///< transform along x of the jumps from the bottom to the top
    Values m_beside; ///< transform along y of the jumps from the right to the left
    Values m_stepsX, m_stepsY;
    std::vector<float> m_laplacianX, m_laplacianY;
};

} // namespace texloom

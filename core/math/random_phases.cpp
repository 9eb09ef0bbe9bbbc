#include "core/math/random_phases.h"

#include <cmath>
#include <numbers>

namespace texloom {

/// A phase of modulus 1, or white Gaussian noise's transform of mean square 1.
std::complex<float> RandomPhases::factor(int column, int row, bool real) const {
    if (m_model == PhaseModel::SpotNoise) {
        const auto first = static_cast<float>(m_random.normal(column, row, 0));
        const auto second = static_cast<float>(m_random.normal(column, row, 1));
        return real ? std::complex<float>(first, 0)
                    : std::complex<float>(first, second) * std::numbers::sqrt2_v<float> * 0.5F;
    }
    if (real)
        return m_random.below(2, column, row) == 0 ? std::complex<float>(1, 0) : std::complex<float>(-1, 0);
    const auto angle = static_cast<float>(2 * std::numbers::pi * m_random.uniform(column, row));
    return {std::cos(angle), std::sin(angle)};
}

/// The first column, and the last one of an even width, hold both of each pair of conjugate frequencies.
void RandomPhases::draw(int column, std::complex<float>* factors) const {
    const bool paired = column == 0 || 2 * column == m_size.width;
    for (int row = 0; row < m_size.height; ++row) {
        const int opposite = (m_size.height - row) % m_size.height;
        factors[row] = paired && opposite < row ? std::conj(factors[opposite])
                                                : factor(column, row, paired && opposite == row);
    }
    if (column == 0)
        factors[0] = 0;
}

} // namespace texloom

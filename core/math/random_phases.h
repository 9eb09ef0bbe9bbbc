#pragma once

#include "core/image/size.h"
#include "core/job/random.h"

#include <complex>

namespace texloom {

/// Which random field a spectrum is turned into.
enum class PhaseModel {
    PhaseNoise, ///< every frequency keeps its strength
    SpotNoise   ///< asymptotic spot noise: strengths vary as in a Gaussian field
};

/// The random factors by which the spectrum of a real image becomes that of a random phase texture (Galerne,
/// Gousseau & Morel 2011), drawn by frequency. The same factors serve all channels, so that their relations
/// are preserved. The mean's factor is 0: it is not random.
class RandomPhases {
public:
    RandomPhases(PhaseModel model, Size size, const Random& random)
        : m_model(model), m_size(size), m_random(random) {}

    /// Writes the factors of the frequencies (column, 0 … height − 1), column at most width / 2: such that an
    /// image stays real, those of opposite frequencies are conjugate. Columns may be drawn by several
    /// threads.
    void draw(int column, std::complex<float>* factors) const;

private:
    std::complex<float> factor(int column, int row, bool real) const;

    PhaseModel m_model;
    Size m_size;
    Random m_random;
};

} // namespace texloom

#pragma once

#include <span>
#include <vector>

namespace texloom {

/// Midway between two signals that are taken as distributions of mass along a line (Delon 2004; Raad, thesis
/// 2016, section 4.3): the point half-way on the geodesic of optimal transport. Cumulative sums are piecewise
/// linear, so that their inverses, the harmonic mean of eq. 4.3 and the deformations of a line are exact,
/// where the source's algorithms 6 and 7 sample them.
class Midway {
public:
    /// @param first, second signals of one length, not negative. A signal without any mass counts as uniform.
    /// @param share 0 for the first, 1 for the second, 0.5 for the middle.
    Midway(std::span<const float> first, std::span<const float> second, double share = 0.5);

    /// The signal between: its mass is (1 − share) m₁ + share m₂ (algorithm 8).
    std::vector<float> signal() const;
    /// φ₁ and φ₂ at the pixels' borders 0 … n: the place in each signal that the place in the middle comes
    /// from, so that H₁ ∘ φ₁ = H₂ ∘ φ₂ = H.
    std::vector<double> firstPlaces() const { return placesOf(&Knot::first); }
    std::vector<double> secondPlaces() const { return placesOf(&Knot::second); }

private:
    struct Knot {
        double mass, first, second, between;
    };
    std::vector<double> placesOf(double Knot::*which) const;

    int m_length;
    double m_mass;
    std::vector<Knot> m_knots; ///< increasing in every member
};

/// A signal with its mass moved: the cumulative sum of `signal` read at the given places (n + 1 of them, from
/// 0 to n, non-decreasing), differentiated and scaled to `mass`.
std::vector<float> deformed(std::span<const float> signal, std::span<const double> places, double mass);

/// Sum of a signal.
double massOf(std::span<const float> signal);

} // namespace texloom

#pragma once

#include "core/image/image.h"

#include <functional>

namespace texloom::portilla_simoncelli {

/// Moments of a plane's samples. Skewness is μ₃ / σ³ and kurtosis μ₄ / σ⁴ (3 for a normal distribution); a
/// constant plane counts as normal.
struct Moments {
    double mean = 0;
    double variance = 0;
    double skewness = 0;
    double kurtosis = 3;
    double smallest = 0;
    double largest = 0;
};

using Check = std::function<void()>;

Moments momentsOf(const PlaneView& plane, const Check& check);

/// Gives a plane the wanted mean, variance, skewness, kurtosis and range, one after the other: the shape by
/// moving the samples along the gradient of skewness, then of kurtosis, until the value is reached as nearly
/// as possible (Portilla & Simoncelli 2000, appendix A.1 and A.2); samples beyond the range are moved to its
/// ends.
/// @param current the plane's moments; those of a constant plane only get the mean.
void imposeMoments(const PlaneSpan& plane, const Moments& current, const Moments& wanted, const Check& check);

} // namespace texloom::portilla_simoncelli

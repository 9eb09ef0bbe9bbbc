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

/// plane = (plane − its mean) × scale + mean, so that it has this mean and variance.
void adjustVariance(const PlaneSpan& plane, double mean, double variance, const Check& check);

/// Moves the samples along the gradient of the skewness until it is `skewness`, or as near as it gets, and
/// keeps mean and variance (Portilla & Simoncelli 2000, appendix A.1).
void adjustSkewness(const PlaneSpan& plane, double skewness, const Check& check);
/// The same for the kurtosis; the skewness changes a little (appendix A.2).
void adjustKurtosis(const PlaneSpan& plane, double kurtosis, const Check& check);

/// Moves samples beyond the limits onto them.
void clampTo(const PlaneSpan& plane, double smallest, double largest, const Check& check);

} // namespace texloom::portilla_simoncelli

#pragma once

#include <vector>

namespace texloom {

/// The overlap of two pictures that are to be joined along a path: `along` steps of the path, `across` pixels
/// from the first picture's side to the second's. Values lie step by step, pixel by pixel, channel by
/// channel.
struct SeamOverlap {
    SeamOverlap(int steps, int pixels, int values)
        : along(steps), across(pixels), channels(values), first(size()), second(size()) {}

    int along, across, channels;
    std::vector<float> first, second;

    std::size_t at(int step, int pixel) const {
        return (static_cast<std::size_t>(step) * static_cast<std::size_t>(across) +
                static_cast<std::size_t>(pixel)) *
               static_cast<std::size_t>(channels);
    }

private:
    std::size_t size() const {
        return static_cast<std::size_t>(along) * static_cast<std::size_t>(across) *
               static_cast<std::size_t>(channels);
    }
};

/// The path along which two pictures show least that they are joined (Tartavel, Gousseau & Peyré 2013, eq. 8,
/// after Kwatra et al. 2003): it minimises the sum, over all pairs of neighbours (a, b) that it parts, of
///     (|p1(a) − p2(a)|² + |p1(b) − p2(b)|²) / (|p1(a) − p1(b)|² + |p2(a) − p2(b)|² + δ).
/// The source has no δ, and its denominator vanishes on flat pieces.
/// @param closes whether the last step neighbours the first. @return for each step the first pixel of the
/// second picture, from 1 to across − 1; where the overlap is one pixel wide, 1.
std::vector<int> seamPath(const SeamOverlap& overlap, float delta, bool closes);

/// The cost of a path, as seamPath() minimises it.
double seamCost(const SeamOverlap& overlap, float delta, bool closes, const std::vector<int>& path);

} // namespace texloom

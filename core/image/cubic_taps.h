#pragma once

#include "core/image/image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom {

/// The pixels along one axis that a sample is made of, and how much each counts.
struct SampleTaps {
    int count = 0;
    std::array<int, 4> at{};
    std::array<float, 4> weight{};
};

/// No image has pixels this far out.
inline constexpr double kFarthest = 1e9;

/// How many samples a pixel takes along an axis that a step of this length crosses; one of little more than 1
/// does not justify a second.
inline int samplesFor(double step) {
    constexpr double kSlack = 0.25;
    constexpr double kMost = 8;
    return static_cast<int>(std::clamp(std::ceil(step - kSlack), 1.0, kMost));
}

/// Catmull and Rom's cubic (1974), which interpolates: a place in the middle of a pixel is that pixel alone.
/// @param position counted from the first pixel's middle. @param pixel gives the index within the image of
/// one that may lie beyond its ends.
template <class Pixel> SampleTaps cubicTaps(double position, const Pixel& pixel) {
    const double floor = std::floor(position), t = position - floor;
    const int first = static_cast<int>(std::clamp(floor, -kFarthest, kFarthest));
    if (t == 0)
        return {1, {pixel(first)}, {1}};
    return {4,
            {pixel(first - 1), pixel(first), pixel(first + 1), pixel(first + 2)},
            {static_cast<float>(((2 - t) * t - 1) * t / 2), static_cast<float>(((3 * t - 5) * t * t + 2) / 2),
             static_cast<float>(((4 - 3 * t) * t + 1) * t / 2), static_cast<float>((t - 1) * t * t / 2)}};
}

/// The straight line between two pixels.
template <class Pixel> SampleTaps linearTaps(double position, const Pixel& pixel) {
    const double floor = std::floor(position), t = position - floor;
    const int first = static_cast<int>(std::clamp(floor, -kFarthest, kFarthest));
    if (t == 0)
        return {1, {pixel(first)}, {1}};
    return {2, {pixel(first), pixel(first + 1)}, {static_cast<float>(1 - t), static_cast<float>(t)}};
}

/// The pixel nearest to a position.
template <class Pixel> SampleTaps nearestTaps(double position, const Pixel& pixel) {
    return {1, {pixel(static_cast<int>(std::clamp(std::floor(position + 0.5), -kFarthest, kFarthest)))}, {1}};
}

inline float sampleAt(const PlaneView& plane, const SampleTaps& columns, const SampleTaps& rows) {
    if (columns.count == 1 && rows.count == 1)
        return plane(columns.at[0], rows.at[0]);
    float sum = 0;
    for (int j = 0; j < rows.count; ++j) {
        const float* row = plane.row(rows.at[static_cast<std::size_t>(j)]);
        float across = 0;
        for (int i = 0; i < columns.count; ++i)
            across +=
                columns.weight[static_cast<std::size_t>(i)] * row[columns.at[static_cast<std::size_t>(i)]];
        sum += rows.weight[static_cast<std::size_t>(j)] * across;
    }
    return sum;
}

} // namespace texloom

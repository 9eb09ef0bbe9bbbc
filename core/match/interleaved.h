#pragma once

#include "core/base/large_memory.h"
#include "core/image/image.h"

#include <cstddef>
#include <cstdint>

namespace texloom {

/// Pixels with their channels side by side, padded with zeros to whole vectors where there are many.
struct Interleaved {
    static constexpr int kLanes = 4;

    Interleaved(Size extent, int channels)
        : size(extent), pixel(pixelFor(channels)),
          data(static_cast<std::size_t>(extent.area()) * static_cast<std::size_t>(pixel)) {}

    static int pixelFor(int channels) {
        return channels <= 2 ? channels : (channels + kLanes - 1) / kLanes * kLanes;
    }
    static std::uint64_t bytesFor(Size size, int channels) {
        return static_cast<std::uint64_t>(size.area()) * static_cast<std::uint64_t>(pixelFor(channels)) *
               sizeof(float);
    }

    std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(size.width) * pixel; }
    const float* at(int x, int y) const { return data.data() + y * stride() + x * pixel; }

    /// Takes the rectangle of `extent` pixels at (x, y), wrapping around the borders of the image.
    void load(const ImageView& image, int x, int y, Size extent) {
        for (int c = 0; c < image.channels; ++c)
            for (int row = 0; row < extent.height; ++row) {
                const float* from = image.plane(c).row((y + row) % image.height);
                float* to = data.data() + row * stride() + c;
                for (int column = 0; column < extent.width; ++column)
                    to[column * pixel] = from[(x + column) % image.width];
            }
    }

    Size size;
    int pixel; ///< floats from one pixel to the next
    ZeroedBuffer<float> data;
};

/// Sum of squared differences over `rows` rows of `length` floats, abandoned once it exceeds `limit`.
/// Written in lanes, since a single running sum does not vectorise.
inline float squaredDistance(const float* a, std::ptrdiff_t aStride, const float* b, std::ptrdiff_t bStride,
                             int rows, int length, float limit) {
    float lanes[Interleaved::kLanes] = {};
    float rest = 0;
    float sum = 0;
    for (int row = 0; row < rows && sum <= limit; ++row, a += aStride, b += bStride) {
        int i = 0;
        for (; i + Interleaved::kLanes <= length; i += Interleaved::kLanes)
            for (int lane = 0; lane < Interleaved::kLanes; ++lane) {
                const float difference = a[i + lane] - b[i + lane];
                lanes[lane] += difference * difference;
            }
        for (; i < length; ++i)
            rest += (a[i] - b[i]) * (a[i] - b[i]);
        sum = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]) + rest;
    }
    return sum;
}

} // namespace texloom

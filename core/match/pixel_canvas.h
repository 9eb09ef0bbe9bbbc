#pragma once

#include "core/image/position_map.h"
#include "core/match/interleaved.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace texloom {

/// An output whose pixels are copied from exemplars one by one: the pixels, and where each comes from.
struct PixelCanvas {
    PixelCanvas(Size size, int channels, std::vector<Size> exemplars)
        : pixels(size, channels), map(size, std::move(exemplars)) {}

    Size size() const { return pixels.size; }
    void put(int x, int y, const Source& source, const Interleaved& exemplar) {
        map.at(x, y) = source;
        std::copy_n(exemplar.at(source.x, source.y), pixels.pixel,
                    pixels.data.data() + y * pixels.stride() + x * pixels.pixel);
    }
    static std::uint64_t bytesFor(Size size, int channels) {
        return PositionMap::bytesFor(size) + Interleaved::bytesFor(size, channels);
    }

    Interleaved pixels;
    PositionMap map;
};

/// The exemplar's pixel that would continue the copy which `from` belongs to, if it lies there at all.
/// @param dx, dy from the output's pixel with this source to the one that is asked for.
struct Continuation {
    int x, y, exemplar; ///< x and y may lie outside

    Continuation(const Source& from, int dx, int dy)
        : x(from.x + dx), y(from.y + dy), exemplar(from.exemplar) {}
    friend bool operator==(const Continuation&, const Continuation&) = default;
    Source source() const {
        return {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                static_cast<std::uint16_t>(exemplar)};
    }
};

} // namespace texloom

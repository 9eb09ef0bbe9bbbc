#pragma once

#include <algorithm>
#include <cstdint>

namespace texloom {

/// Width and height in pixels.
struct Size {
    int width = 0;
    int height = 0;

    std::int64_t area() const { return static_cast<std::int64_t>(width) * height; }
    int shorterSide() const { return std::min(width, height); }
    int longerSide() const { return std::max(width, height); }
    bool empty() const { return width <= 0 || height <= 0; }
    friend bool operator==(const Size&, const Size&) = default;
};

/// The axes on which an output closes on itself, so that repeated copies join without a seam.
struct Wrap {
    bool x = false;
    bool y = false;

    friend bool operator==(const Wrap&, const Wrap&) = default;
};

/// A rectangle of pixels: its top left and its size.
struct Region {
    int x = 0;
    int y = 0;
    Size size;

    int right() const { return x + size.width; }
    int bottom() const { return y + size.height; }
    /// Whether it has pixels, all of them in an image of this size.
    bool within(Size whole) const {
        return !size.empty() && x >= 0 && y >= 0 && size.width <= whole.width - x &&
               size.height <= whole.height - y;
    }
    friend bool operator==(const Region&, const Region&) = default;
};

} // namespace texloom

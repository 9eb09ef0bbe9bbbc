#pragma once

#include "core/match/interleaved.h"

namespace texloom::test {

/// All of an image.
inline Interleaved interleaved(const Image& image) {
    Interleaved pixels(image.size(), image.channels());
    pixels.load(image, 0, 0, image.size());
    return pixels;
}

} // namespace texloom::test

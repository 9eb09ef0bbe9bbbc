#pragma once

#include "core/match/patch_source.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace texloom {

/// An output some of whose pixels were copied.
struct CopiedPixels {
    std::span<const PatchSource> exemplars;
    const std::vector<std::uint8_t>& made; ///< of the picture by rows, 1 where a pixel is a copy
    Wrap wrap;

    bool isMade(int x, int y, int width) const {
        return made[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)] != 0;
    }
};

} // namespace texloom

#pragma once

#include "core/image/image.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace texloom {

/// Calls visit(x, y) for the top left of every square of `patch` pixels in which a mask is nowhere 0, row by
/// row, until it returns true. Takes a few operations per pixel, whatever the size of the patch, by growing
/// squares from their lower right corner. @param check called for every row; may throw.
/// @return whether a visit returned true.
template <class Visit>
bool anyWholePatch(
    const PlaneView& mask, int patch, const Visit& visit, const std::function<void()>& check = [] {}) {
    std::vector<int> above(static_cast<std::size_t>(mask.width) + 1, 0), row = above;
    for (int y = 0; y < mask.height; ++y) {
        check();
        const float* pixels = mask.row(y);
        for (int x = 0; x < mask.width; ++x) {
            const auto at = static_cast<std::size_t>(x) + 1;
            row[at] = pixels[x] != 0 ? 1 + std::min({row[at - 1], above[at], above[at - 1]}) : 0;
            if (row[at] >= patch && visit(x - patch + 1, y - patch + 1))
                return true;
        }
        above.swap(row);
    }
    return false;
}

/// Whether there is such a square.
inline bool leavesWholePatch(const PlaneView& mask, int patch) {
    return anyWholePatch(mask, patch, [](int, int) { return true; });
}

} // namespace texloom

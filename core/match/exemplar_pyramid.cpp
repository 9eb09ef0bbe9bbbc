#include "core/match/exemplar_pyramid.h"

#include "core/image/half_scale.h"

#include <algorithm>

namespace texloom {

namespace {

/// Whether the mask leaves a whole square of `patch` pixels, by growing squares from their lower right
/// corner.
bool leavesPatch(const PatchSource& source, int patch) {
    if (source.image.size().shorterSide() < patch)
        return false;
    if (!source.mask.data)
        return true;
    std::vector<int> above(static_cast<std::size_t>(source.mask.width) + 1, 0), row = above;
    for (int y = 0; y < source.mask.height; ++y) {
        for (std::size_t x = 1; x < row.size(); ++x) {
            const bool free = source.mask(static_cast<int>(x) - 1, y) != 0;
            row[x] = free ? 1 + std::min({row[x - 1], above[x], above[x - 1]}) : 0;
            if (row[x] >= patch)
                return true;
        }
        above.swap(row);
    }
    return false;
}

} // namespace

ExemplarPyramid::ExemplarPyramid(std::span<const PatchSource> exemplars, int levels, int patch,
                                 const std::function<void()>& check)
    : m_levels{{exemplars.begin(), exemplars.end()}} {
    m_images.reserve(exemplars.size() * static_cast<std::size_t>(2 * levels));
    while (static_cast<int>(m_levels.size()) < levels) {
        std::vector<PatchSource> next;
        for (const PatchSource& source : m_levels.back()) {
            check();
            PatchSource& half = next.emplace_back();
            half.image = m_images.emplace_back(halved(source.image));
            if (source.mask.data)
                half.mask = m_images.emplace_back(halvedMask(source.mask)).view().plane(0);
        }
        const bool small = std::any_of(next.begin(), next.end(), [&](const PatchSource& source) {
            return source.image.size().shorterSide() < patch;
        });
        if (small || std::none_of(next.begin(), next.end(),
                                  [&](const PatchSource& source) { return leavesPatch(source, patch); }))
            break;
        m_levels.push_back(std::move(next));
    }
}

std::vector<Size> ExemplarPyramid::sizes(int number) const {
    std::vector<Size> sizes;
    for (const PatchSource& source : level(number))
        sizes.push_back(source.image.size());
    return sizes;
}

int ExemplarPyramid::levelsFor(std::span<const Size> exemplars, int side) {
    int shortest = exemplars.front().shorterSide();
    for (const Size& size : exemplars)
        shortest = std::min(shortest, size.shorterSide());
    int levels = 1;
    for (; shortest / 2 >= side; shortest /= 2)
        ++levels;
    return levels;
}

std::uint64_t ExemplarPyramid::bytesFor(std::span<const Size> exemplars, int channels) {
    std::uint64_t bytes = 0;
    for (const Size& size : exemplars)
        bytes += Image::bytesFor(size, channels + 1) / 2 + 65536;
    return bytes;
}

} // namespace texloom

#include "core/match/exemplar_pyramid.h"

#include "core/image/half_scale.h"
#include "core/match/whole_patches.h"

#include <algorithm>

namespace texloom {

namespace {

bool leavesPatch(const PatchSource& source, int patch) {
    return source.image.size().shorterSide() >= patch &&
           (!source.mask.data || leavesWholePatch(source.mask, patch));
}

} // namespace

ExemplarPyramid::ExemplarPyramid(std::span<const PatchSource> exemplars, int levels, int patch,
                                 const std::function<void()>& check)
    : m_levels{{exemplars.begin(), exemplars.end()}} {
    m_images.reserve(exemplars.size() * static_cast<std::size_t>(2 * levels));
    while (static_cast<int>(m_levels.size()) < levels) {
        std::vector<PatchSource> next;
        for (const PatchSource& source : m_levels.back()) {
            PatchSource& half = next.emplace_back();
            half.image = m_images.emplace_back(halved(source.image, check));
            if (source.mask.data)
                half.mask = m_images.emplace_back(halvedMask(source.mask, check)).view().plane(0);
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

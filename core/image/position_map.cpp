#include "core/image/position_map.h"

#include "core/base/error.h"

#include <algorithm>
#include <utility>

namespace texloom {

PositionMap::PositionMap(Size size, std::vector<Size> exemplarSizes)
    : m_size(size), m_exemplarSizes(std::move(exemplarSizes)),
      m_sources(static_cast<std::size_t>(size.area())) {}

PositionMap PositionMap::identity(Size size) {
    PositionMap map(size, {size});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            map.at(x, y) = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0};
    return map;
}

namespace {

void checkImages(std::span<const ImageView> exemplars, const std::vector<Size>& sizes) {
    if (exemplars.size() != sizes.size())
        fail("The map needs one image for each exemplar that it was made from: {}, not {}.", sizes.size(),
             exemplars.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (exemplars[i].size() != sizes[i])
            fail("The image is {} × {} px, but the map was made from an exemplar of {} × {} px.",
                 exemplars[i].width, exemplars[i].height, sizes[i].width, sizes[i].height);
        if (exemplars[i].channels != exemplars[0].channels)
            fail("The images have {} and {} channels; a map needs the same number in each.",
                 exemplars[0].channels, exemplars[i].channels);
    }
}

} // namespace

Image PositionMap::apply(std::span<const ImageView> exemplars) const {
    if (exemplars.empty())
        fail("The map needs the images that it was made from, but none was given.");
    checkImages(exemplars, m_exemplarSizes);
    Image result(m_size, exemplars[0].channels);
    for (int y = 0; y < m_size.height; ++y) {
        const Source* sources = &at(0, y);
        for (int x = 0; x < m_size.width; ++x) {
            if (!sources[x].valid())
                continue;
            const ImageView& exemplar = exemplars[sources[x].exemplar];
            for (int c = 0; c < exemplar.channels; ++c)
                result(x, y, c) = exemplar(sources[x].x, sources[x].y, c);
        }
    }
    return result;
}

void PositionMap::shrink(Size size) {
    size = {std::min(size.width, width()), std::min(size.height, height())};
    for (int y = 0; y < size.height; ++y)
        std::copy_n(m_sources.begin() + static_cast<std::ptrdiff_t>(index(0, y)), size.width,
                    m_sources.begin() + static_cast<std::ptrdiff_t>(y) * size.width);
    m_sources.resize(static_cast<std::size_t>(size.area()));
    m_size = size;
}

} // namespace texloom

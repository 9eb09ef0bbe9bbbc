#include "core/analysis/copy_index.h"

#include <algorithm>

namespace texloom {

namespace {

std::int64_t sampled(int length, int step) {
    return (static_cast<std::int64_t>(length) + step - 1) / step;
}

} // namespace

CopyIndex::CopyIndex(const PositionMap& map, std::int64_t most, const std::function<void()>& check)
    : m_size(map.size()), m_exemplars(map.exemplarSizes()) {
    while (sampled(m_size.width, m_step) * sampled(m_size.height, m_step) > most)
        ++m_step;
    std::size_t pixels = 0;
    for (const Size& size : m_exemplars)
        pixels += static_cast<std::size_t>(size.area());
    m_begin.assign(pixels + 1, 0);
    const auto each = [&](const auto& visit) {
        for (int y = 0; y < m_size.height; y += m_step) {
            check();
            for (int x = 0; x < m_size.width; x += m_step)
                if (const Source& source = map.at(x, y); source.valid())
                    visit(x, y, cellOf(source));
        }
    };
    each([&](int, int, std::size_t cell) { ++m_begin[cell + 1]; });
    for (std::size_t i = 1; i < m_begin.size(); ++i)
        m_begin[i] += m_begin[i - 1];
    m_copies.resize(m_begin.back());
    std::vector<std::uint32_t> next(m_begin.begin(), m_begin.end() - 1);
    each([&](int x, int y, std::size_t cell) {
        m_copies[next[cell]++] = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(m_size.width) +
                                 static_cast<std::uint32_t>(x);
    });
}

std::size_t CopyIndex::cellOf(const Source& source) const {
    std::size_t before = 0;
    for (std::size_t e = 0; e < source.exemplar; ++e)
        before += static_cast<std::size_t>(m_exemplars[e].area());
    return before +
           static_cast<std::size_t>(source.y) * static_cast<std::size_t>(m_exemplars[source.exemplar].width) +
           source.x;
}

std::vector<CopyIndex::Place> CopyIndex::copiesOf(const Source& source, std::size_t most) const {
    std::vector<Place> places;
    if (!source.valid() || source.exemplar >= m_exemplars.size())
        return places;
    const Size exemplar = m_exemplars[source.exemplar];
    // Of each copied piece, one pixel per square of this side is recorded.
    for (int dy = 0; dy < m_step; ++dy)
        for (int dx = 0; dx < m_step; ++dx) {
            const int x = source.x - dx, y = source.y - dy;
            if (x < 0 || y < 0 || x >= exemplar.width || y >= exemplar.height)
                continue;
            const std::size_t cell =
                cellOf({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), source.exemplar});
            for (std::uint32_t i = m_begin[cell]; i < m_begin[cell + 1]; ++i) {
                const auto width = static_cast<std::uint32_t>(m_size.width);
                const Place place{static_cast<int>(m_copies[i] % width) + dx,
                                  static_cast<int>(m_copies[i] / width) + dy};
                if (place.x < m_size.width && place.y < m_size.height)
                    places.push_back(place);
            }
        }
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); });
    places.resize(std::min(places.size(), most));
    return places;
}

std::uint64_t CopyIndex::bytesFor(std::int64_t exemplarPixels, std::int64_t most) {
    return static_cast<std::uint64_t>(2 * exemplarPixels + most) * sizeof(std::uint32_t);
}

} // namespace texloom

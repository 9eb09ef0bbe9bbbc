#include "core/methods/wang_tiles/tiling.h"

#include <algorithm>

namespace texloom::wang_tiles {

namespace {

/// Streams of random numbers: edges that run across, upright ones, and tiles of compact sets.
constexpr std::uint32_t kAcross = 0, kUpright = 1, kChoice = 2;

} // namespace

std::vector<int> Tiling::lengths(int output, int tile, bool wraps) {
    const int count = (output + tile - 1) / tile;
    std::vector<int> all;
    for (int i = 0; i < count; ++i)
        all.push_back(wraps ? output / count + (i < output % count ? 1 : 0) : tile);
    return all;
}

Tiling::Tiling(const Request& request, const Settings& settings, const Random& random)
    : m_colours(settings.colours), m_random(random),
      m_widths(lengths(request.size.width, settings.tile, request.wrap.x)),
      m_heights(lengths(request.size.height, settings.tile, request.wrap.y)) {
    // Only on an axis that wraps is the edge after the last cell the one before the first.
    if (!request.wrap.x)
        m_widths.push_back(0);
    if (!request.wrap.y)
        m_heights.push_back(0);
    if (settings.set == Set::Compact)
        fillCompact();
}

int Tiling::drawn(int column, int row, std::uint32_t axis) const {
    return static_cast<int>(
        m_random.below(static_cast<std::uint32_t>(m_colours), column % columns(), row % rows(), axis));
}

void Tiling::fillCompact() {
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column < columns(); ++column) {
            const int north =
                row > 0 ? m_compact[m_compact.size() - m_widths.size()].south : drawn(column, row, kAcross);
            const int west = column > 0 ? m_compact.back().east : drawn(column, row, kUpright);
            const int k = m_colours;
            if (m_random.below(2, column, row, kChoice) == 0)
                m_compact.push_back({north, north, (west + 1) % k, west});
            else
                m_compact.push_back({north, (north + 1) % k, west, west});
        }
}

Edges Tiling::edges(int column, int row) const {
    if (!m_compact.empty())
        return m_compact[static_cast<std::size_t>(row) * m_widths.size() + static_cast<std::size_t>(column)];
    return {drawn(column, row, kAcross), drawn(column + 1, row, kUpright), drawn(column, row + 1, kAcross),
            drawn(column, row, kUpright)};
}

} // namespace texloom::wang_tiles

#include "core/methods/wang_tiles/tiling.h"

#include <algorithm>

namespace texloom::wang_tiles {

namespace {

/// Streams of random numbers: edges that run across, upright ones, tiles of compact sets, and corners.
constexpr std::uint32_t kAcross = 0, kUpright = 1, kChoice = 2, kCorner = 3;

} // namespace

std::vector<int> Tiling::lengths(int output, int tile, bool wraps) {
    const int count = (output + tile - 1) / tile;
    std::vector<int> all;
    for (int i = 0; i < count; ++i)
        all.push_back(wraps ? output / count + (i < output % count ? 1 : 0) : tile);
    return all;
}

Tiling::Tiling(const Request& request, const Settings& settings, const Random& random)
    : m_match(settings.match), m_colours(settings.colours), m_random(random),
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

/// What of a tile of a compact set those above and to the left of it leave open: all but the edges or the
/// corner that it shares with none of them.
Colours Tiling::begun(int column, int row) const {
    const Colours* const above = row > 0 ? &m_compact[m_compact.size() - m_widths.size()] : nullptr;
    const Colours* const left = column > 0 ? &m_compact.back() : nullptr;
    Colours tile;
    if (m_match == Match::Edges) {
        tile.north = above ? above->south : drawn(column, row, kAcross);
        tile.west = left ? left->east : drawn(column, row, kUpright);
        return tile;
    }
    tile.north = above ? above->west : left ? left->east : drawn(column, row, kCorner);
    tile.east = above ? above->south : drawn(column + 1, row, kCorner);
    tile.west = left ? left->south : drawn(column, row + 1, kCorner);
    return tile;
}

void Tiling::fillCompact() {
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column < columns(); ++column) {
            Colours tile = begun(column, row);
            const auto choice = static_cast<int>(m_random.below(2, column, row, kChoice));
            if (m_match == Match::Corners)
                tile.south = compactCorner(m_colours, tile.north, tile.east, tile.west, choice);
            else if (choice == 0) {
                tile.east = tile.north;
                tile.south = (tile.west + 1) % m_colours;
            } else {
                tile.east = (tile.north + 1) % m_colours;
                tile.south = tile.west;
            }
            m_compact.push_back(tile);
        }
}

Colours Tiling::colours(int column, int row) const {
    if (!m_compact.empty())
        return m_compact[static_cast<std::size_t>(row) * m_widths.size() + static_cast<std::size_t>(column)];
    if (m_match == Match::Corners)
        return {drawn(column, row, kCorner), drawn(column + 1, row, kCorner),
                drawn(column + 1, row + 1, kCorner), drawn(column, row + 1, kCorner)};
    return {drawn(column, row, kAcross), drawn(column + 1, row, kUpright), drawn(column, row + 1, kAcross),
            drawn(column, row, kUpright)};
}

} // namespace texloom::wang_tiles

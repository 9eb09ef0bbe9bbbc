#include "core/methods/wang_tiles/tile_set.h"

#include "core/base/at.h"

namespace texloom::wang_tiles {

TileSet::TileSet(int colours, Size size)
    : m_colours(colours), m_size(size), m_tiles(at(colours * colours * colours * colours)) {}

std::size_t TileSet::indexOf(const Colours& tile) const {
    return at(((tile.north * m_colours + tile.east) * m_colours + tile.south) * m_colours + tile.west);
}

std::uint64_t TileSet::bytesFor(const Settings& settings) {
    const auto side = static_cast<std::uint64_t>(settings.tile);
    return coloursOf(settings).size() * side * side * sizeof(Source);
}

} // namespace texloom::wang_tiles

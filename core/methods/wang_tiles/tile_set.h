#pragma once

#include "core/image/position_map.h"
#include "core/image/size.h"
#include "core/methods/wang_tiles/tile_colours.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace texloom::wang_tiles {

/// The tiles of one set, all of one size: where each of their pixels comes from.
class TileSet {
public:
    /// No tile yet. @param colours how many there are.
    TileSet(int colours, Size size);

    const Size& size() const { return m_size; }
    /// @param sources of the tile's pixels, row by row.
    void add(const Colours& tile, std::vector<Source> sources) {
        m_tiles[indexOf(tile)] = std::move(sources);
    }
    /// The pixels of a tile of the set, row by row.
    const std::vector<Source>& tile(const Colours& tile) const { return m_tiles[indexOf(tile)]; }
    const Source& source(const Colours& tile, int x, int y) const {
        return this->tile(tile)[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                                static_cast<std::size_t>(x)];
    }

    static std::uint64_t bytesFor(const Settings& settings);

private:
    std::size_t indexOf(const Colours& tile) const;

    int m_colours;
    Size m_size;
    std::vector<std::vector<Source>> m_tiles; ///< by their four colours
};

} // namespace texloom::wang_tiles

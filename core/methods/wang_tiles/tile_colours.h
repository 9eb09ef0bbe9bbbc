#pragma once

#include "core/methods/wang_tiles/settings.h"

#include <vector>

namespace texloom::wang_tiles {

/// Colours of a tile, clockwise. Of its edges: above, right, below, left. Of its corners: the upper left one,
/// the upper right one, the lower right one, the lower left one; so each corner is named after the edge that
/// begins at it.
struct Colours {
    int north = 0, east = 0, south = 0, west = 0;
    friend bool operator==(const Colours&, const Colours&) = default;
};

/// The colours of all tiles of a set, in the order in which they lie side by side on a sheet, tilesInRow() in
/// a row. Those of a full set match on it: of edges also round it (Wei, "Tile-based texture mapping on
/// graphics hardware", 2004), of corners also from its lower border to the upper one.
std::vector<Colours> coloursOf(const Settings& settings);

/// Full sets have colours² tiles in a row, compact ones twice as many as colours.
int tilesInRow(const Settings& settings);

/// The two colours that a tile of a compact set may end in, given the three others: of the corners, the lower
/// right one.
int compactCorner(int colours, int northWest, int northEast, int southWest, int choice);

/// Place in a row of matching tiles of the one with these colours at its two ends (Wei 2004, eq. 2).
int sheetPlace(int first, int second);

} // namespace texloom::wang_tiles

#pragma once

#include "core/analysis/lattice.h"
#include "core/image/image.h"
#include "core/job/random.h"

#include <functional>

namespace texloom::regular_tile {

/// How well each tile of an exemplar joins itself when it is repeated (López Recas 2011, section 4.1.1): the
/// sum, over a border along each of two sides, of squared differences to the opposite side (eq. 4.2), for the
/// tile whose first corner is pixel (x, y). One channel of the exemplar's size; infinite where the tile or
/// its borders reach beyond the exemplar. The differences are computed once for all tiles, and summed along
/// rows once, so that a tile takes as many steps as its borders have rows.
/// @param border width of a border in pixels, centred on the tile's side. @param check called per row.
Image tileCosts(const ImageView& exemplar, const Lattice& lattice, int border,
                const std::function<void()>& check);

/// Makes all tiles infinitely costly that hold a pixel where the mask is 0. @param mask one channel of the
/// costs' size.
void forbidTiles(Image& costs, const PlaneView& mask, const Lattice& lattice,
                 const std::function<void()>& check);

/// The corner of one tile.
struct Tile {
    int x = 0, y = 0;
    float cost = 0;
};

/// One of the tiles up to (1 + tolerance) times as costly as the best, drawn uniformly.
/// @throws Error if no tile is at a finite cost.
Tile drawTile(const Image& costs, double tolerance, const Random& random);

} // namespace texloom::regular_tile

#pragma once

#include "core/analysis/lattice_settings.h"

namespace texloom::regular_tile {

/// Which tile of the exemplar is repeated.
enum class Choice { Best, Given };

/// Whether all copies of the tile are alike, or vary as the exemplar's tiles do.
enum class Colour { One, Varied };

/// How the principal components of a varied tile are drawn.
enum class Draw { Normal, Resample };

/// Parameters of the repetition of one tile (López Recas 2011, section 4.1), or
/// of tiles that vary (Liu, Lin & Hays 2004).
struct Settings : LatticeSettings {
    Choice tile = Choice::Best;
    double tileX = 0, tileY = 0; ///< top left corner of the given tile
    int border = 16;             ///< width in pixels of the borders that are compared, 2 × 8 in the source
    double tolerance = 0;        ///< how much worse than the best join a drawn tile may be; 0 in the source
    Colour colour = Colour::One;
    int bases = 11; ///< principal components of varied tiles, at most (Liu, Lin & Hays 2004)
    Draw draw = Draw::Normal;
    int feather = 8; ///< half the width in pixels of the zone in which varied tiles fade into each other
};

} // namespace texloom::regular_tile

#pragma once

#include "core/analysis/lattice_settings.h"

namespace texloom::regular_tile {

/// Which tile of the exemplar is repeated.
enum class Choice { Best, Given };

/// Parameters of the repetition of one tile (López Recas 2011, section 4.1).
struct Settings : LatticeSettings {
    Choice tile = Choice::Best;
    double tileX = 0, tileY = 0; ///< top left corner of the given tile
    int border = 16;             ///< width in pixels of the borders that are compared, 2 × 8 in the source
    double tolerance = 0.1;      ///< how much worse than the best join a drawn tile may be
};

} // namespace texloom::regular_tile

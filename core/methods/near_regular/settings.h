#pragma once

#include "core/analysis/lattice_settings.h"

namespace texloom::near_regular {

/// How a patch is compared with the border that it has to fit (López Recas 2011, section 4.2.2).
enum class Match { Difference, Correlation };

/// How neighbouring blocks are joined: along minimum-error cuts, or by the source's linear blending.
enum class Join { Cut, Blend };

/// Whether slow changes of light are removed from the exemplar first; automatic: where patches would show.
enum class EvenLight { Automatic, Yes, No };

/// What is copied: square blocks whose size the lattice does not bound, or whole tiles with an overlap (Liu,
/// Tsin & Lin 2005).
enum class Unit { Blocks, Tiles };

/// Parameters of constrained random sampling and gap filling (López Recas 2011, section 4.2).
struct Settings : LatticeSettings {
    Unit unit = Unit::Blocks;
    double originX = 0,
           originY = 0; ///< the exemplar's point that lies at the output's top left, in its lattice
    int block = 0;      ///< side of the blocks in pixels; 0: chosen from the exemplar and its lattice
    int border = 0;     ///< width of the compared border in pixels; 0: chosen from the block
    int tolerance = 3;  ///< how far from the lattice a gap's patch may lie, in pixels
    Match match = Match::Difference;
    Join join = Join::Cut;
    int blend = 4; ///< width of the blended band in pixels
    EvenLight flatten = EvenLight::Automatic;
    bool rectify = false; ///< turns and shears the exemplar to whole-pixel vectors first
};

} // namespace texloom::near_regular

#pragma once

#include "core/analysis/lattice.h"
#include "core/image/image.h"

namespace texloom::near_regular {

/// How much an exemplar's tiles differ at each of their places: little in joints, which are alike, much where
/// every brick has a tone of its own.
struct PhaseDeviation {
    /// Of the exemplar's size: the standard deviation of all pixels at the same place of a tile, in units of
    /// the exemplar, its squares summed over channels.
    Image at;
    /// The place, in multiples of the lattice's vectors from the exemplar's corner, each from 0 to 1, amid
    /// the half tile that differs most: within an element rather than across its joints.
    Vec2 middle;
};

/// @param lattice of the exemplar, in pixels
PhaseDeviation phaseDeviation(const ImageView& exemplar, const Lattice& lattice);

} // namespace texloom::near_regular

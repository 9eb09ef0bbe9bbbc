#pragma once

#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice_candidate.h"

#include <optional>

namespace texloom {

/// Structure that repeats in one direction only: courses of stones of any length, planks, corrugated sheet.
struct Rows {
    /// A vector of one pixel along the rows, free to go anywhere, and one from row to row. Rated as if tiles
    /// were as long as rows are high.
    LatticeCandidate candidate;
    double confidence = 0; ///< 0 to 1, see findRows()
    Vec2 along;            ///< unit vector
    double distance = 0;   ///< between rows, square to them, in pixels
};

/// Finds the rows that stand out most. Past the source, whose lattices repeat in two directions: γ of such a
/// texture does not fall along the rows, so that its means over lines keep what γ at single displacements
/// loses in the texture's chance. The lines' direction is that in which γ changes least; the distance, that
/// of eq. 3.22 for the means. The rows are trusted if the means rise by more than can be seen, by more
/// than γ wavers along a row, and alike at every multiple, as high as along the row through the origin:
/// chance would have to hit that height each time.
/// @return nothing if the means have no maximum.
std::optional<Rows> findRows(const CorrelationPeaks& peaks);

/// Finds the direction of rows of which no two need be alike: planks of any width, courses of any height. γ
/// stays high along the line through the origin, from end to end, and is lower on all other lines. The rows
/// come as far apart, of half to two thirds of the exemplar, as they are most alike: a lattice by which the
/// rows keep their order (Lattice::keepsOrder()).
/// @return nothing if γ falls to nothing in all directions.
std::optional<Rows> findOrderedRows(const CorrelationPeaks& peaks);

/// Rows drawn roughly, as a lattice whose shorter vector lies along them, moved apart or together to fit γ.
Lattice fittedRows(const CorrelationPeaks& peaks, const Lattice& rough);

} // namespace texloom

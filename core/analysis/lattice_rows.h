#pragma once

#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice_candidate.h"

#include <optional>

namespace texloom {

/// Structure that repeats in one direction only: courses of stones of any length, planks, corrugated sheet.
struct Rows {
    /// A vector of one pixel along the rows, where all displacements are allowed, and one from row to row.
    /// Rated as if tiles were as long as the rows are high.
    LatticeCandidate candidate;
    double confidence = 0; ///< 0 to 1, see findRows()
    Vec2 along;            ///< unit vector
    double distance = 0;   ///< between rows, perpendicular to them, in pixels
};

/// Finds the rows that stand out most. Beyond the source, whose lattices repeat in two directions: γ of such
/// a texture does not fall along the rows, so its means over lines show structure that random variation hides
/// at single displacements. The lines run in the direction in which γ changes least; their distance is that
/// of eq. 3.22 for the means. The rows are trusted if the means rise by a visible amount, by more than γ
/// varies along a row, and equally at every multiple, as high as along the row through the origin: chance
/// would have to reach that height each time.
/// @return nothing if the means have no maximum.
std::optional<Rows> findRows(const CorrelationPeaks& peaks);

/// Finds the direction of rows no two of which need be alike: planks of any width, courses of any height. γ
/// stays high along the line through the origin, from end to end, and is lower on all other lines. The
/// distance is the one, of half to two thirds of the exemplar, at which rows are most alike: a lattice with
/// which the rows keep their order (Lattice::keepsOrder()).
/// @return nothing if γ falls to nothing in all directions.
std::optional<Rows> findOrderedRows(const CorrelationPeaks& peaks);

/// Rows drawn roughly, as a lattice whose shorter vector lies along them, with their distance fitted to γ.
Lattice fittedRows(const CorrelationPeaks& peaks, const Lattice& rough);

} // namespace texloom

#pragma once

#include "core/image/image.h"
#include "core/match/patch_distances.h"

#include <cstdint>
#include <vector>

namespace texloom {

/// Where a new patch is joined to the existing pixels: the boundary of least error in the overlap.
struct BoundaryCut {
    double cost = 0; ///< sum of the errors along the cut
    int patch = 0;
    /// patch × patch: 1 where the old pixel stays (beyond the cut), 0 where the new one replaces it (the cut
    /// included).
    std::vector<std::uint8_t> keep;

    bool keeps(int x, int y) const {
        return keep[static_cast<std::size_t>(y) * static_cast<std::size_t>(patch) +
                    static_cast<std::size_t>(x)] != 0;
    }
};

/// The minimum error boundary cut (Efros & Freeman 2001; Raad & Galerne, IPOL 2017, section 2.3).
/// Along each side of the overlap runs a path that advances by one pixel and shifts sideways by at most one
/// at each step; where two sides meet, so do their paths, on the diagonal, and the corner's error counts
/// once: min over i of E_v(i, i) + E_h(i, i) − e(i, i). The source has the vertical, horizontal and L-shaped
/// cases; the same rule at the other corners closes the cuts of outputs that wrap.
/// @param error squared differences e between the old and the new patch, patch × patch; read in the overlap
/// only.
/// @param overlap widths of at most half the patch each.
BoundaryCut minimumErrorCut(const PlaneView& error, const Overlap& overlap);

} // namespace texloom

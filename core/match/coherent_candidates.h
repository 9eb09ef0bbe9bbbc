#pragma once

#include "core/match/pixel_canvas.h"
#include "core/match/pixel_runs.h"

#include <vector>

namespace texloom {

/// The exemplar's pixels that continue the copies which surround an output's pixel p:
/// { s(r) + (p − r) : r in the neighbourhood }, each once, in the order of the runs (the candidates of
/// Ashikhmin, "Synthesizing natural textures", I3D 2001, fig. 2). Some may lie outside of their exemplar.
/// @param map the sources so far; pixels without one give no candidate. @param wrap axes on which the
/// neighbourhood reaches round the border; elsewhere what lies outside gives none.
/// @param found the candidates; what it held is gone.
void coherentCandidates(const PositionMap& map, const PixelRuns& runs, int x, int y, Wrap wrap,
                        std::vector<Continuation>& found);

} // namespace texloom

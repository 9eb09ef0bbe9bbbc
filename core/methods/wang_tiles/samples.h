#pragma once

#include "core/image/position_map.h"
#include "core/match/patch_search.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/settings.h"

#include <vector>

namespace texloom::wang_tiles {

/// Squares of the exemplars, sampleSide() pixels across, by their top left: one for each colour of corners,
/// which lie in their middle; or two for each colour of edges, first of the edge that runs across, then of
/// the upright one.
using Samples = std::vector<PatchPosition>;

/// How many samples a set is made of.
int sampleCount(const Settings& settings);

/// Pixels of the zone of the cuts.
int zoneOf(const Settings& settings);
/// How deep the border of a tile with coloured corners is, in pixels; what lies within is covered afresh.
int depthOf(const Settings& settings);
/// Pixels of a sample to either side of its edge or corner: half a tile, half the zone of the cuts, and a
/// little for rounding.
int reachOf(const Settings& settings);
/// Side of a square that holds a sample.
int sampleSide(const Settings& settings);

/// The squared difference of two pixels of the exemplars, over all channels.
double squaredDifference(const Request& request, const Source& a, const Source& b);

} // namespace texloom::wang_tiles

#pragma once

#include "core/methods/port.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/settings.h"
#include "core/methods/wang_tiles/tile_set.h"

#include <cstdint>
#include <vector>

namespace texloom::wang_tiles {

/// The ports through which a set of tiles is given by itself, for programs that lay it themselves.
std::vector<Port> setPorts();

/// Where each tile lies on the sheet, in tiles: a full set has colours² tiles in a row, a compact one twice
/// as many as colours.
int tilesInRow(const Settings& settings);

/// Adds to a result's outputs the sheet of all tiles side by side, the position map of it, by which companion
/// maps get the same sheet, every tile by itself, and the table of their edges, and to its pictures the
/// sheet. Those of a full set match on the sheet, also round it.
void addSet(const Request& request, const Settings& settings, const TileSet& tiles,
            const std::vector<Edges>& edges, JobContext& context, Synthesis& result);

/// Upper bound of the memory that all this takes.
std::uint64_t setBytesFor(const Settings& settings, int channels);

} // namespace texloom::wang_tiles

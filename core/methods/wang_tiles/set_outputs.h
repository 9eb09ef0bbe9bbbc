#pragma once

#include "core/job/job_context.h"
#include "core/methods/port.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/settings.h"
#include "core/methods/wang_tiles/tile_set.h"

#include <cstdint>
#include <vector>

namespace texloom::wang_tiles {

/// The ports through which a set of tiles is given by itself, for programs that lay it themselves.
std::vector<Port> setPorts();

/// Adds to a result's outputs the sheet of all tiles side by side, the position map of it, by which companion
/// maps get the same sheet, every tile by itself, and the table of their colours.
void addSet(const Request& request, const Settings& settings, const TileSet& tiles,
            const std::vector<Colours>& colours, JobContext& context, Synthesis& result);

/// Upper bound of the memory that all this takes.
std::uint64_t setBytesFor(const Settings& settings, int channels);

} // namespace texloom::wang_tiles

#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/methods/copied_pixels.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <functional>

namespace texloom {

/// Keeps the differences between neighbours that the exemplars have, the mean of both copies' where these
/// differ, and takes the level from what is around (Pérez, Gangnet & Blake, SIGGRAPH 2003): hides steps of
/// tone at the border of a hole and between copies. A step that is far larger than most along the border is
/// no step of tone, but something else that lies there: it is evened out only as far as most are, since all
/// of it would stain what is around. What was not made stays bit for bit.
/// @param image of the map's size, with the copies. @param progress called with 0 to 1; may throw.
void evenTone(const CopiedPixels& copied, const PositionMap& map, Image& image,
              const std::function<void(double)>& progress);

/// Evens the tone of a hole that was filled, with a stage of its own: what of the result is not known is a
/// copy by its map. The map is then the dominant one.
/// @param hidden the request with the masks of withoutHole().
void evenFilledTone(const Request& hidden, double weight, JobContext& context, Synthesis& result);

/// Upper bound of the memory that evenFilledTone() takes.
std::uint64_t toneBytes(const Request& request);

} // namespace texloom

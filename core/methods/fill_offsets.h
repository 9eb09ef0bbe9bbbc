#pragma once

#include "core/job/job_context.h"
#include "core/methods/copied_pixels.h"

#include <vector>

namespace texloom {

/// An offset from pixels to their sources, and a square of the picture where it may fit.
struct OffsetProposal {
    int exemplar = 0, dx = 0, dy = 0;
    int x = 0, y = 0, side = 0;
};

/// Offsets that continue what is around into what was made: for squares on the border of what was made, the
/// `best` places of the exemplars whose pixels are nearest to those of the square that were not made, each
/// pair at least a quarter of the side apart.
/// @param side of the squares in pixels, one at every half of it.
std::vector<OffsetProposal> borderOffsets(const CopiedPixels& copied, const ImageView& picture, int side,
                                          int best, JobContext& context);

/// Upper bound of the memory that borderOffsets() takes.
std::uint64_t offsetBytes(std::span<const Size> exemplars, int channels, int threads);

} // namespace texloom

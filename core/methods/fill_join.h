#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/methods/fill_request.h"
#include "core/methods/method.h"

#include <cstdint>
#include <functional>

namespace texloom {

/// Joins what was copied into a hole to what is around, and copies to each other: looks elsewhere for what
/// lies along the border (borderOffsets()), and moves the seams to where they are seen least (moveSeams()).
/// @param hidden the request with the masks of withoutHole(), or its FillWindow's.
/// @param side of the squares along the border, in pixels. @param radius see SeamMoves::radius.
/// @param map of the output; valid wherever nothing is known.
void joinCopies(const Request& hidden, int side, int radius, PositionMap& map, JobContext& context);
/// Sides of these squares on the finest scale, and on coarser ones, where they show more.
inline constexpr int kJoinSide = 48, kCoarseJoinSide = 24;

/// Upper bound of the memory that joinCopies() takes.
std::uint64_t joinBytes(const Request& request, int threads);

/// Offers a whole picture of which a window is filled, at any scale, if it is looked at.
/// @param level the window's scale: 1 / 2^level. @param pixel fills in the values of a pixel at that scale,
/// or returns false if it is not made yet; its place may lie a little outside.
void offerFilled(const FillWindow& window, int level,
                 const std::function<bool(int x, int y, float* values)>& pixel, JobContext& context);

/// Whether seams between copies are moved.
template <class Settings> Param seamsField(bool Settings::*member) {
    return field(member, "seams", TR("Move seams"))
        .group(TR("Advanced"))
        .help(TR("Where a hole is filled, moves the borders between what is copied to where they are seen "
                 "least, so that few large pieces take the place of many small ones."));
}

} // namespace texloom

#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/match/patch_match.h"

#include <cstdint>
#include <span>

namespace texloom {

/// Side of the compared patches, between the sources' 4 and 7 pixels.
inline constexpr int kEstimatedMapPatch = 5;

/// The synthesis map of a result whose pixels are new: every pixel is mapped to the centre of the exemplar
/// patch most similar to the patch around it, found with PatchMatch (Raad, thesis 2016, section 2.4;
/// Gutierrez, thesis 2020, section 2.3). At borders that do not wrap, the outermost whole patch decides.
/// @param exemplars in the order of the map's exemplar numbers. @param wrap of the result.
/// @param context its progress is set, so begin a stage of its own first.
/// @param patch side of the compared patches; smaller where an image is.
PositionMap estimatedMap(const ImageView& result, std::span<const PatchSource> exemplars, Wrap wrap,
                         JobContext& context, int patch = kEstimatedMapPatch);

/// Bytes that making the map of a result takes, the map included.
std::uint64_t estimatedMapBytes(Size result, std::span<const Size> exemplars, int channels);

/// Rough time on one thread, in seconds.
double estimatedMapSeconds(Size result, int channels);

} // namespace texloom

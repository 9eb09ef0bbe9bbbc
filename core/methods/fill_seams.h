#pragma once

#include "core/image/position_map.h"
#include "core/methods/fill_offsets.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// How seams are moved.
struct SeamMoves {
    std::vector<OffsetProposal> proposals; ///< are spread first
    int offsets = 64; ///< at most so many of those that copies have, the most frequent first, are spread
    int rounds = 2;   ///< over all of them, at most
    int least = 12;   ///< an offset of fewer pixels is no piece worth spreading
    int reach = 24;   ///< how far in pixels from where it is now an offset may spread in a round
    int radius = 0;   ///< in exemplars of the picture's size, how far a source may lie; 0: anywhere
};

/// What all seams cost before and after they were moved: the sum over neighbours p, q with sources s, t of
/// the absolute differences |e(s) − e(t + p − q)| + |e(s + q − p) − e(t)| over all channels.
struct SeamCosts {
    double before = 0, after = 0;
};

/// Moves the seams between copies, and between them and what is around, to where the pictures on both sides
/// differ least (Kwatra et al., SIGGRAPH 2003): each offset that is frequent in the map spreads to the pixels
/// that it costs least to give it, by a minimum cut (α-expansion: Boykov, Veksler & Zabih, IEEE PAMI 23,
/// 2001; offsets as labels: He & Sun, IEEE PAMI 36, 2014). What seams cost together never rises, and small
/// pieces that fit nowhere vanish. Pixels are only copied from where masks allow it.
/// @param picture of the map's size; read where nothing was made. @param map sources of what was made, valid
/// everywhere there. @param check called every few milliseconds; may throw.
SeamCosts moveSeams(const CopiedPixels& copied, const ImageView& picture, const SeamMoves& moves,
                    PositionMap& map, const std::function<void()>& check);

/// Upper bound of the memory that moveSeams() takes for a picture of this size.
std::uint64_t seamBytes(Size picture, std::span<const Size> exemplars, int channels);

} // namespace texloom

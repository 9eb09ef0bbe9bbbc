#pragma once

#include "core/analysis/lattice.h"
#include "core/image/image.h"
#include "core/image/position_map.h"

#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// What distances of small patches do not see of a result: contrast that faded, pieces that do not meet, one
/// piece that grew over all of it, and an order that was lost. `check` is called every few milliseconds and
/// may throw; images have the same number of channels.

/// The part of an image that is looked at for what repeats: the middle 512 px of larger ones.
ImageView middlePart(const ImageView& image);

/// Standard deviation of the result's pixels about their channel's mean relative to the exemplars': 1 where
/// contrast was kept, less where it faded; 1 for exemplars of one colour.
double contrastKept(
    const ImageView& result, std::span<const ImageView> exemplars,
    const std::function<void()>& check = [] {});

/// How much pieces jump where they meet: for each two neighbours p and q of the result, the difference
/// between q and the exemplar's pixel beside p's source in the same direction, which is q where both were
/// copied together (one of the terms of Kwatra et al. 2003, section 3). The root mean square over all
/// neighbours whose sources have that pixel, relative to the exemplars' standard deviation: 0 for a copy.
double seamJump(
    const ImageView& result, std::span<const ImageView> exemplars, const PositionMap& map,
    const std::function<void()>& check = [] {});

/// Share of the result that comes from the most used square of an exemplar, whose side is an eighth of the
/// exemplar's shorter one: near 1 where one piece grew over all of it ("growing garbage" of Efros & Leung
/// 1999).
/// @param occurrences as occurrencesOf().
double mostUsedShare(const std::vector<Image>& occurrences);

/// Root mean square difference of the autocorrelations γ of a result and its exemplars (the mean of theirs),
/// over displacements up to half of the shortest side: 0 where what lies at a distance is as alike as in the
/// exemplar. Of each image the middle part counts.
double correlationApart(
    const ImageView& result, std::span<const ImageView> exemplars,
    const std::function<void()>& check = [] {});

/// Mean γ of the result at the multiples of an exemplar's lattice relative to the exemplar's: 1 where the
/// pattern runs on, 0 where it is lost; at least 0. Where γ of the exemplar is low, that of edges (edgesOf())
/// is compared. Of each image the middle part counts.
double latticeKept(
    const ImageView& result, const ImageView& exemplar, const Lattice& lattice,
    const std::function<void()>& check = [] {});

} // namespace texloom

#pragma once

#include "core/image/image.h"
#include "core/image/position_map.h"

#include <functional>
#include <vector>

namespace texloom {

/// How a position map makes use of its exemplars. `check` is called for every row and may throw.

/// Share of the output that the largest connected region takes whose pixels were all copied with one offset:
/// 1 for a copy of the exemplar. Regions connect through sides of pixels.
double largestVerbatimRegion(
    const PositionMap& map, const std::function<void()>& check = [] {});

/// How often each pixel of one exemplar was copied, over how often it would be if all were copied alike: one
/// channel of the exemplar's size, with mean 1 over all exemplars.
Image occurrence(
    const PositionMap& map, int exemplar, const std::function<void()>& check = [] {});

/// occurrence() of every exemplar.
std::vector<Image> occurrencesOf(
    const PositionMap& map, const std::function<void()>& check = [] {});

/// The occurrence as a picture, 1 − 2^−k for k times the mean: black was never used, half grey as often as
/// pixels are on average.
Image occurrencePicture(const Image& occurrence);

/// Entropy of where patches come from, over its largest value: 1 where every 8 × 8 px of the exemplars are
/// used alike, 0 where only one of them is.
/// @param occurrences of all exemplars.
double occurrenceEntropy(const std::vector<Image>& occurrences);

} // namespace texloom

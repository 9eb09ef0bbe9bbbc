#pragma once

#include "core/image/image.h"
#include "core/image/position_map.h"

#include <functional>
#include <vector>

namespace texloom {

/// How a position map uses its exemplars. `check` is called for every row and may throw.

/// Share of the output taken by the largest connected region whose pixels were all copied with the same
/// offset: 1 for a copy of the exemplar. Regions are 4-connected.
double largestVerbatimRegion(
    const PositionMap& map, const std::function<void()>& check = [] {});

/// How often each pixel of one exemplar was copied, relative to how often it would be if all were copied
/// equally: one channel of the exemplar's size, with mean 1 over all exemplars.
Image occurrence(
    const PositionMap& map, int exemplar, const std::function<void()>& check = [] {});

/// occurrence() of every exemplar.
std::vector<Image> occurrencesOf(
    const PositionMap& map, const std::function<void()>& check = [] {});

/// The occurrence as a picture, 1 − 2^−k for k times the mean: black means never used, mid-grey used as often
/// as the average pixel.
Image occurrencePicture(const Image& occurrence);

/// Entropy of where patches come from, relative to its maximum: 1 where all cells of 8 × 8 px of the
/// exemplars are used equally, 0 where only one is used.
/// @param occurrences of all exemplars.
double occurrenceEntropy(const std::vector<Image>& occurrences);

} // namespace texloom

#pragma once

#include "core/volume/box.h"

#include <cstdint>
#include <vector>

namespace texloom {

/// Whole numbers from `begin` to `end` − 1.
struct Interval {
    std::int64_t begin = 0, end = 0;

    int length() const { return static_cast<int>(end - begin); }
    friend bool operator==(const Interval&, const Interval&) = default;
};

/// What a generator computes along one axis at each scale (k = 0 the finest, K the coarsest), for an output
/// of some interval. Blocks lose 2 values at either side; a coarser scale has half the coordinate, rounded
/// down.
struct ScaleIntervals {
    Interval output; ///< [a, b) of the scale's joined block; of the coarsest, of its only block
    Interval joined; ///< what goes into the joined block: [a − 2, b + 2); none of the coarsest
    Interval noise;  ///< [a − 4, b + 4), or of the coarsest [a − 2, b + 2)
};

/// The intervals of scales 0 to `coarsest` for an output: [a', b') = [⌊(a − 2) / 2⌋, ⌊(b + 1) / 2⌋ + 1) from
/// one scale to the next (Gutierrez 2020, section 4.3.2, without its rounding up).
std::vector<ScaleIntervals> scaleIntervals(Interval wanted, int coarsest);

/// The boxes at one scale.
struct ScaleBoxes {
    Box output, joined, noise;
};

/// The boxes of scales 0 to `coarsest`. @param flat whether there are two dimensions: z stays as it is.
std::vector<ScaleBoxes> scaleBoxes(const Box& wanted, int coarsest, bool flat);

} // namespace texloom

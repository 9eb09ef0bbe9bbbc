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

/// Values along an axis at a scale before all repeat: `period` of the output's, halved and rounded up from
/// scale to scale. 0: they never do.
inline int periodAt(int period, int scale) {
    return (period + (1 << scale) - 1) >> scale;
}

/// The coordinate at the next coarser scale that stands for `place`: half of it, rounded down. Where `period`
/// is not 0 both run round in circles; of an odd one the last coarse value stands for one value, the others
/// for two.
std::int64_t coarser(std::int64_t place, int period);

/// The intervals of scales 0 to `coarsest` for an output: [a', b') = [⌊(a − 2) / 2⌋, ⌊(b + 1) / 2⌋ + 1) from
/// one scale to the next (Gutierrez 2020, section 4.3.2, without its rounding up).
/// @param period after how many values the output repeats; 0: never.
std::vector<ScaleIntervals> scaleIntervals(Interval wanted, int coarsest, int period = 0);

/// The boxes at one scale.
struct ScaleBoxes {
    Box output, joined, noise;
};

/// The boxes of scales 0 to `coarsest`. @param flat whether there are two dimensions: z stays as it is.
/// @param period of the output along each axis; 0: none.
std::vector<ScaleBoxes> scaleBoxes(const Box& wanted, int coarsest, bool flat, const VolumeSize& period = {});

/// Where the values of a fine box lie in the box of the next coarser scale that holds them.
struct CoarserPlaces {
    std::vector<int> x, y, z;

    /// @param period of the fine scale along each axis; 0: none.
    CoarserPlaces(const Box& fine, const Box& coarse, bool flat, const VolumeSize& period);
};

} // namespace texloom

#pragma once

#include "core/session/run/run.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// What one axis of a sweep varies: a parameter of one of the run's methods, or the seed.
struct SweepAxis {
    std::size_t step = 0;  ///< of the run: 0 is its first method
    std::string parameter; ///< by name; empty for the seed
    std::vector<Value> values;
};

/// One run of a sweep.
struct SweepCell {
    /// One value that it has, as texts to be translated apart: "Patch size", "16", "px".
    struct Part {
        std::string title, value, unit;
    };
    std::vector<Part> parts; ///< what is particular to it, by axis
    RunInput input;
};

/// At most this many runs make up a sweep.
inline constexpr std::size_t kMostSweepCells = 100;

/// Values written as a list (8, 16, 32), as from:to:count (8:64:5, evenly spaced, both ends included), or
/// both. Equal ones count once. @throws UsageError with the parameter's limits.
std::vector<Value> sweepValues(const Param& parameter, std::string_view text);
/// The same for seeds.
std::vector<Value> sweepSeeds(std::string_view text);

/// Every combination of the axes' values: the first axis runs across, the second down.
/// @param varySeed whether each run has its own seed, from the input's upwards, rather than all the same.
/// @throws UsageError if there are too many.
std::vector<SweepCell> sweepCells(const RunInput& input, const std::vector<SweepAxis>& axes, bool varySeed);

} // namespace texloom

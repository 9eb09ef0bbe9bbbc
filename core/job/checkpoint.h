#pragma once

#include "core/job/curve.h"

#include <cstdint>
#include <string>
#include <vector>

namespace texloom {

/// How far the work of a job had come, so that it can go on from there.
struct Checkpoint {
    std::uint32_t step =
        0;               ///< of several runs in one job (see JobContext::step()), the one that was under way
    double progress = 0; ///< of the whole job
    std::string state;   ///< what the work wrote of itself, in a form of its own
    std::vector<Curve> curves = {}; ///< those of that run so far
};

} // namespace texloom

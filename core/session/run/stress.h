#pragma once

#include "core/session/run/run.h"

#include <vector>

namespace texloom {

/// One round of a stress test: a texture made from the texture that the round before made.
struct StressRound {
    Result result;
    TextureDistance distance; ///< of the result from the exemplars that the first round learned from
};

/// Makes one round; for a Job. @param first what the first round learned from.
StressRound stressRound(const RunPlan& plan, const std::vector<RunExemplar>& first, JobContext& context);

/// What the round after this one learns from: the result alone, and with the next seed.
/// @param input with at least one exemplar
void learnFrom(const Image& result, RunInput& input);

} // namespace texloom

#include "core/session/run/stress.h"

#include <memory>

namespace texloom {

StressRound stressRound(const RunPlan& plan, const std::vector<RunExemplar>& first, JobContext& context) {
    std::vector<ImageView> views;
    for (const RunExemplar& exemplar : first)
        views.push_back(*exemplar.image.image);
    StressRound round{runPlan(plan, context), {}};
    round.distance = textureDistance(round.result.synthesis.image, views, context);
    return round;
}

void learnFrom(const Image& result, RunInput& input) {
    input.exemplars.resize(1);
    RunExemplar& exemplar = input.exemplars.front();
    exemplar.mask.reset();
    exemplar.companions.clear();
    exemplar.weight = 1;
    exemplar.image.image = std::make_shared<const Image>(result);
    ++input.seed;
}

} // namespace texloom

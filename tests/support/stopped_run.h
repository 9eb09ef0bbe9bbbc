#pragma once

#include "core/session/run/run.h"
#include "tests/support/textures.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace texloom::test {

/// A run of one method on a made-up exemplar of 48 × 48 px.
inline RunPlan madeUpPlan(const std::string& method, const Values& settings, Size size) {
    RunInput input;
    input.steps.front() = {method, settings};
    RunExemplar& exemplar = input.exemplars.emplace_back();
    exemplar.image.path = "made up";
    exemplar.image.space = "srgb";
    exemplar.image.image = std::make_shared<const Image>(blobs({48, 48}, 3));
    input.size = size;
    input.judged = false;
    return planRun(input);
}

/// The result of such a run that is told to stop and keep what it has as soon as it has begun.
inline Result stoppedAtOnce(const std::string& method, const Values& settings, Size size) {
    const auto job = startRun(madeUpPlan(method, settings, size), false);
    job->stopAndKeep();
    Outcome<Result> outcome = job->take();
    if (auto* result = std::get_if<Result>(&outcome))
        return std::move(*result);
    throw std::runtime_error("a run that was stopped kept nothing");
}

} // namespace texloom::test

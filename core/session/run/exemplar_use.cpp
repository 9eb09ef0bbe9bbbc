#include "core/session/run/exemplar_use.h"

#include <algorithm>

namespace texloom {

namespace {

/// Whether one of the methods takes this port. What the first is to start from is for the first alone.
bool taken(const std::vector<RecipeStep>& steps, std::string_view port) {
    if (port == kInitialPort)
        return findMethod(steps.front().method).info().startsFromImage();
    return std::any_of(steps.begin(), steps.end(), [port](const RecipeStep& step) {
        return findMethod(step.method).info().input(port) != nullptr;
    });
}

} // namespace

ExemplarUse useOf(const std::vector<RecipeStep>& steps) {
    const auto all = [&steps](bool (MethodInfo::*ability)() const) {
        return std::all_of(steps.begin(), steps.end(), [ability](const RecipeStep& step) {
            return (findMethod(step.method).info().*ability)();
        });
    };
    return {all(&MethodInfo::learnsFromSeveral), all(&MethodInfo::heedsWeights),
            all(&MethodInfo::heedsMasks)};
}

void keepUsed(RunInput& input) {
    const std::size_t count = input.exemplars.size();
    input.exemplars = exemplarsFor(input.steps, input.exemplars, std::vector<bool>(count, true), 0);
    for (RunExemplar& exemplar : input.exemplars)
        std::erase_if(exemplar.inputs, [&](const auto& entry) { return !taken(input.steps, entry.first); });
    std::erase_if(input.inputs, [&](const auto& entry) { return !taken(input.steps, entry.first); });
    const MethodInfo& last = findMethod(input.steps.back().method).info();
    if (!last.canWrap())
        input.wrap = {};
    if (!last.makesParts())
        input.region.reset();
}

} // namespace texloom

#include "core/session/run/exemplar_use.h"

#include "core/base/error.h"

#include <algorithm>

namespace texloom {

bool takesPort(const std::vector<RecipeStep>& steps, std::string_view port) {
    if (port == kInitialPort)
        return findMethod(steps.front().method).info().startsFromImage();
    return std::any_of(steps.begin(), steps.end(), [port](const RecipeStep& step) {
        return findMethod(step.method).info().input(port) != nullptr;
    });
}

ExemplarUse useOf(const std::vector<RecipeStep>& steps) {
    std::vector<const MethodInfo*> learning;
    for (const RecipeStep& step : steps)
        if (const MethodInfo& info = findMethod(step.method).info(); info.takesExemplars())
            learning.push_back(&info);
    const auto all = [&learning](bool (MethodInfo::*ability)() const) {
        return !learning.empty() && std::all_of(learning.begin(), learning.end(),
                                                [ability](const auto* info) { return (info->*ability)(); });
    };
    ExemplarUse use;
    use.any = !learning.empty();
    use.needed = std::any_of(learning.begin(), learning.end(),
                             [](const MethodInfo* info) { return info->needsExemplar(); });
    use.several = all(&MethodInfo::learnsFromSeveral);
    use.weights = all(&MethodInfo::heedsWeights);
    use.masks = all(&MethodInfo::heedsMasks);
    use.companions = findMethod(steps.back().method).info().input(kCompanionPort) != nullptr;
    return use;
}

void checkExemplarCount(const std::vector<RecipeStep>& steps, std::size_t count) {
    const ExemplarUse use = useOf(steps);
    if (count == 0 && use.needed)
        failUsage("There is no exemplar to learn from.");
    if (count > 0 && !use.any)
        failUsage("{} takes no exemplar.", Message(findMethod(steps.front().method).info().title));
}

void keepUsed(RunInput& input) {
    const std::size_t count = input.exemplars.size();
    input.exemplars = exemplarsFor(input.steps, input.exemplars, std::vector<bool>(count, true), 0);
    std::erase_if(input.inputs, [&](const auto& entry) { return !takesPort(input.steps, entry.first); });
    const MethodInfo& last = findMethod(input.steps.back().method).info();
    if (!last.canWrap())
        input.wrap = {};
    if (!last.makesParts())
        input.region.reset();
}

} // namespace texloom

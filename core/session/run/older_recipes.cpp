#include "core/session/run/older_recipes.h"

#include "core/methods/method.h"

namespace texloom {

namespace {

/// A parameter that came to a method with a default which changes its results.
struct Newer {
    const char* method;
    const char* parameter;
    const char* before; ///< what stands for the results without it
};

constexpr Newer kNewer[] = {{"quilting", "variety", "0"}, {"gaussian-patches", "layout", "mirrored"}};

} // namespace

void completeOlder(std::vector<RecipeStep>& steps) {
    for (RecipeStep& step : steps)
        for (const Newer& newer : kNewer)
            if (step.method == newer.method && !step.parameters.contains(newer.parameter))
                step.parameters[newer.parameter] =
                    findMethod(step.method).param(newer.parameter).parse(newer.before);
}

} // namespace texloom

#pragma once

#include "core/methods/method.h"
#include "core/session/run/run.h"

#include <vector>

namespace texloom {

/// What all the methods of a run make use of: decided here for the window, sessions and the command line.
struct ExemplarUse {
    bool several = false; ///< all exemplars in use, rather than the one that is looked at
    bool weights = false;
    bool masks = false;
};

/// @throws UsageError where a method is not known.
ExemplarUse useOf(const std::vector<RecipeStep>& steps);

/// The exemplars that the methods learn from, without what they make no use of.
/// @param Entry RunExemplar or RecipeExemplar. @param all that are open. @param used of each, whether it
/// is ticked. @param current index of the one that is looked at.
template <class Entry>
std::vector<Entry> exemplarsFor(const std::vector<RecipeStep>& steps, const std::vector<Entry>& all,
                                const std::vector<bool>& used, std::size_t current) {
    const ExemplarUse use = useOf(steps);
    std::vector<Entry> chosen;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (use.several ? !used[i] : i != current)
            continue;
        chosen.push_back(all[i]);
        if (!use.masks)
            chosen.back().mask.reset();
        if (!use.weights)
            chosen.back().weight = 1;
    }
    return chosen;
}

/// Takes out of an input what its methods make no use of: masks, weights, ports, axes that cannot wrap, a
/// part that cannot be made alone. What is left fits the methods, whatever method it was put together for.
void keepUsed(RunInput& input);

} // namespace texloom

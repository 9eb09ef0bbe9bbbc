#pragma once

#include "core/methods/method.h"
#include "core/session/run/run.h"

#include <map>
#include <string_view>
#include <vector>

namespace texloom {

/// What all the methods of a run make use of: decided here for the window, sessions and the command line.
struct ExemplarUse {
    bool any = false;     ///< one of the methods takes exemplars
    bool needed = false;  ///< one of them cannot do without
    bool several = false; ///< all exemplars in use, rather than the one that is looked at
    bool weights = false;
    bool masks = false;
    bool companions = false; ///< the last method makes their maps for the result
};

/// Whether one of the methods takes this port. What the first is to start from is for the first alone.
/// @throws UsageError where a method is not known.
bool takesPort(const std::vector<RecipeStep>& steps, std::string_view port);

/// Of methods that learn from exemplars and others, the former decide. @throws UsageError where a method is
/// not known.
ExemplarUse useOf(const std::vector<RecipeStep>& steps);

/// @param count of exemplars. @throws UsageError where the methods learn from one and there is none, or learn
/// from none and there is one.
void checkExemplarCount(const std::vector<RecipeStep>& steps, std::size_t count);

/// The exemplars that the methods learn from, without what they make no use of; none if they learn from none.
/// @param Entry RunExemplar or RecipeExemplar. @param all that are open. @param used of each, whether it
/// is ticked. @param current index of the one that is looked at.
template <class Entry>
std::vector<Entry> exemplarsFor(const std::vector<RecipeStep>& steps, const std::vector<Entry>& all,
                                const std::vector<bool>& used, std::size_t current) {
    const ExemplarUse use = useOf(steps);
    std::vector<Entry> chosen;
    for (std::size_t i = 0; use.any && i < all.size(); ++i) {
        if (use.several ? !used[i] : i != current)
            continue;
        chosen.push_back(all[i]);
        if (!use.masks)
            chosen.back().mask.reset();
        if (!use.companions)
            chosen.back().companions.clear();
        if (!use.weights)
            chosen.back().weight = 1;
        std::erase_if(chosen.back().inputs, [&](const auto& own) { return !takesPort(steps, own.first); });
    }
    return chosen;
}

/// Takes out of an input what its methods make no use of: exemplars, masks, weights, ports, axes that cannot
/// wrap, a part that cannot be made alone. What is left fits the methods, whatever method it was put together
/// for.
void keepUsed(RunInput& input);

} // namespace texloom

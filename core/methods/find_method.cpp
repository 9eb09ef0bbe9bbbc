#include "core/base/error.h"
#include "core/base/settings.h"
#include "core/methods/registry.h"

#include <algorithm>

namespace texloom {

std::vector<const Method*> methodsByCategory() {
    std::vector<const Method*> sorted;
    for (const Method& method : methods())
        sorted.push_back(&method);
    std::stable_sort(sorted.begin(), sorted.end(), [](const Method* a, const Method* b) {
        return a->info().category < b->info().category;
    });
    return sorted;
}

const Method& findMethod(std::string_view id) {
    std::vector<std::string> known;
    for (const Method& method : methods()) {
        if (method.id() == id)
            return method;
        known.push_back(method.id());
    }
    for (const AbsentMethod& absent : absentMethods())
        if (absent.id == id)
            failUsage("{} is not part of this build. {}", id, Message(absent.reason));
    refuseUnknown(message("There is no method {}; the methods are {}.", id, listOf(known)), id, known);
}

} // namespace texloom

#include "core/base/settings.h"

#include "core/base/error.h"
#include "core/base/text.h"

namespace texloom {

void refuseUnknown(const Message& sentence, std::string_view word, const std::vector<std::string>& known) {
    const std::string near = nearest(word, known);
    throw UsageError(near.empty() ? sentence : message("{} Did you mean {}?", sentence, near));
}

const Param& paramNamed(const std::vector<Param>& params, std::string_view owner, std::string_view name) {
    std::vector<std::string> known;
    for (const Param& param : params) {
        if (param.name() == name)
            return param;
        known.push_back(param.name());
    }
    refuseUnknown(message("{} has no parameter {}; it has {}.", owner, name, listOf(known)), name, known);
}

Values defaultsOf(const std::vector<Param>& params, int shorterSide) {
    Values values;
    for (const Param& param : params)
        values[param.name()] = param.defaultFor(shorterSide);
    return values;
}

Values resolvedValues(const std::vector<Param>& params, std::string_view owner, const Values& settings,
                      int shorterSide) {
    Values values = defaultsOf(params, shorterSide);
    for (const auto& [name, value] : settings)
        values[name] = paramNamed(params, owner, name).checked(value);
    return values;
}

} // namespace texloom

#pragma once

#include "core/base/param.h"

#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// The parameter of this name. @param owner id of what has them, for the sentence. @throws UsageError that
/// names the owner and the nearest parameter if there is none.
const Param& paramNamed(const std::vector<Param>& params, std::string_view owner, std::string_view name);

/// Every parameter's default for an exemplar whose shorter side is `shorterSide` px; 0 if that is not known.
Values defaultsOf(const std::vector<Param>& params, int shorterSide);

/// `settings` checked and completed with defaults. @throws UsageError
Values resolvedValues(const std::vector<Param>& params, std::string_view owner, const Values& settings,
                      int shorterSide);

/// Refuses an unknown word, and asks whether the known one that is most like it was meant, if any is like it.
/// @throws UsageError always
[[noreturn]] void refuseUnknown(const Message& sentence, std::string_view word,
                                const std::vector<std::string>& known);

/// A settings struct filled from checked values.
template <class Settings> Settings settingsFrom(const std::vector<Param>& params, const Values& values) {
    Settings settings;
    for (const Param& param : params)
        if (const auto it = values.find(param.name()); it != values.end())
            param.assign(&settings, it->second);
    return settings;
}

} // namespace texloom

#pragma once

#include "core/base/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// Refuses an unknown word, and asks whether the known one that is most like it was meant, if any is like it.
/// @param sentence says that there is no such thing, and what there is. @throws UsageError
[[noreturn]] void refuseUnknown(const Message& sentence, std::string_view word,
                                const std::vector<std::string>& known);

} // namespace texloom

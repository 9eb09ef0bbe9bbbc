#include "core/methods/unknown_word.h"

#include "core/base/error.h"
#include "core/base/text.h"

namespace texloom {

void refuseUnknown(const Message& sentence, std::string_view word, const std::vector<std::string>& known) {
    const std::string near = nearest(word, known);
    throw UsageError(near.empty() ? sentence : message("{} Did you mean {}?", sentence, near));
}

} // namespace texloom

#include "core/base/error.h"

#include "core/base/text.h"

#include <new>

namespace texloom {

Message messageOf(const std::exception& error) {
    if (const auto* ours = dynamic_cast<const Error*>(&error))
        return ours->message();
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
        return TR("There is not enough memory for this; try a smaller output.");
    return Message::verbatim(error.what());
}

} // namespace texloom

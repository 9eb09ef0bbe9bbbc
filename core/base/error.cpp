#include "core/base/error.h"

#include "core/base/text.h"

#include <new>
#include <system_error>

namespace texloom {

Message messageOf(const std::exception& error) {
    if (const auto* ours = dynamic_cast<const Error*>(&error))
        return ours->message();
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
        return TR("There is not enough memory for this; try a smaller output.");
    if (const auto* system = dynamic_cast<const std::system_error*>(&error);
        system != nullptr && system->code() == std::errc::resource_unavailable_try_again)
        return TR(
            "The system gives the program no further thread; raise its limits (ulimit -v and -u), or use "
            "fewer threads.");
    return Message::verbatim(error.what());
}

} // namespace texloom

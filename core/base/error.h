#pragma once

#include "core/base/message.h"

#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>

namespace texloom {

/// Something that could not be done, as one sentence for the user that names the value and the limit.
/// The core throws it, the window shows it in place and in the user's language, the command line prints it in
/// English and exits with 1.
class Error : public std::runtime_error {
public:
    explicit Error(Message message)
        : std::runtime_error(message.text()), m_message(std::make_shared<const Message>(std::move(message))) {
    }

    const Message& message() const { return *m_message; }

private:
    std::shared_ptr<const Message> m_message; ///< shared, since a copy of what is thrown must not throw
};

/// An Error in what was asked for (a setting out of range, an unknown name). The command line exits with 2.
class UsageError : public Error {
public:
    using Error::Error;
};

/// Throws Error with message(pattern, values...).
template <class... Args>
[[noreturn]] void fail(MessagePattern<std::type_identity_t<Args>...> pattern, const Args&... values) {
    throw Error(message(pattern, values...));
}

/// Throws UsageError with message(pattern, values...).
template <class... Args>
[[noreturn]] void failUsage(MessagePattern<std::type_identity_t<Args>...> pattern, const Args&... values) {
    throw UsageError(message(pattern, values...));
}

/// What an exception has to say to the user: the message of an Error, that memory is short, or what a library
/// says, as it is.
Message messageOf(const std::exception& error);

} // namespace texloom

#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace texloom {

/// Something that could not be done, as one sentence for the user that names the value and the limit.
/// The core throws it, the window shows it in place, the command line prints it and exits with 1.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// An Error in what was asked for (a setting out of range, an unknown name). The command line exits with 2.
class UsageError : public Error {
public:
    using Error::Error;
};

/// Throws Error with the formatted sentence.
template <class... Args> [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) {
    throw Error(fmt::format(text, std::forward<Args>(args)...));
}

/// Throws UsageError with the formatted sentence.
template <class... Args> [[noreturn]] void failUsage(fmt::format_string<Args...> text, Args&&... args) {
    throw UsageError(fmt::format(text, std::forward<Args>(args)...));
}

} // namespace texloom

#pragma once

#include "core/base/message.h"

#include <gmock/gmock.h>

#include <ostream>

namespace texloom {

inline void PrintTo(const Message& message, std::ostream* out) { // NOLINT(readability-identifier-naming)
    *out << message.text();
}

namespace test {

MATCHER_P(says, part, "") {
    return ::testing::ExplainMatchResult(::testing::HasSubstr(part), arg.text(), result_listener);
}

} // namespace test

} // namespace texloom

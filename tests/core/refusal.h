#pragma once

#include "core/base/error.h"

#include <gmock/gmock.h>

namespace texloom::test {

/// Matches what throws Failing with one line that holds all of these texts.
template <class Failing = Error, class... Text> auto refusal(const Text&... parts) {
    return ::testing::ThrowsMessage<Failing>(
        ::testing::AllOf(::testing::Not(::testing::HasSubstr("\n")), ::testing::HasSubstr(parts)...));
}

/// The same for what was asked wrongly.
template <class... Text> auto usageRefusal(const Text&... parts) {
    return refusal<UsageError>(parts...);
}

} // namespace texloom::test

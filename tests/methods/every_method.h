#pragma once

#include "core/methods/method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace texloom::test {

/// The ids of all registered methods, to run a test over each of them.
inline std::vector<std::string> everyMethod() {
    std::vector<std::string> ids;
    for (const Method& method : methods())
        ids.push_back(method.id());
    return ids;
}

/// An id as part of a test's name, which holds no hyphens.
inline std::string testName(const testing::TestParamInfo<std::string>& tested) {
    std::string name = tested.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

} // namespace texloom::test

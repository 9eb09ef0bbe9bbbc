// One program for the tests of all methods, since together they compile in a fifth of the time: `--folder
// NAME` runs those whose sources lie in tests/methods/NAME.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace {

/// A filter that chooses the tests of a folder; empty if there are none.
std::string filterFor(const std::string& folder) {
    const std::string part = "tests/methods/" + folder + "/";
    std::string filter;
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
        const testing::TestSuite& suite = *all.GetTestSuite(i);
        for (int k = 0; k < suite.total_test_count(); ++k) {
            const testing::TestInfo& test = *suite.GetTestInfo(k);
            if (std::string(test.file()).find(part) != std::string::npos)
                filter += std::string(filter.empty() ? "" : ":") + suite.name() + "." + test.name();
        }
    }
    return filter;
}

} // namespace

int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    if (argc == 3 && std::string(argv[1]) == "--folder") {
        const std::string filter = filterFor(argv[2]);
        if (filter.empty()) {
            std::fprintf(stderr, "No test lies in tests/methods/%s.\n", argv[2]);
            return 1;
        }
        GTEST_FLAG_SET(filter, filter);
    }
    return RUN_ALL_TESTS();
}

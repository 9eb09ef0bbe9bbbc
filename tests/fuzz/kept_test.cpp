// The inputs that hour.sh kept, each of which reached code that no other did: read once as they are, so that
// what was mended stays so, and damaged.

#include "tests/fuzz/fuzzed.h"
#include "tests/fuzz/readers.h"
#include "tests/support/file_content.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace texloom::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> kept(const std::string& reader) {
    std::vector<fs::path> files;
    for (const auto& entry :
         fs::directory_iterator(fs::path(TEXLOOM_SOURCE_DIR "/tests/fuzz/corpus") / reader))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const auto& [name, read] : readers())
        all.push_back(name);
    return all;
}

class FuzzKept : public ::testing::TestWithParam<std::string> {
protected:
    static const Reader& read() { return readers().find(GetParam())->second; }
};

INSTANTIATE_TEST_SUITE_P(Fuzz, FuzzKept, ::testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

TEST_P(FuzzKept, AreReadOrRefused) {
    std::vector<std::string> originals;
    for (const fs::path& file : kept(GetParam())) {
        SCOPED_TRACE(file.string());
        const std::string& bytes = originals.emplace_back(contentOf(file));
        expectReadOrRefused([&] { read()(bytes); });
    }
    ASSERT_FALSE(originals.empty());
    fuzz("kept-" + GetParam(), originals, iterations(), [this](const std::string& bytes) { read()(bytes); });
}

TEST(FuzzCorpus, StaysSmall) {
    std::uintmax_t bytes = 0;
    for (const std::string& name : names())
        for (const fs::path& file : kept(name))
            bytes += fs::file_size(file);
    EXPECT_LT(bytes, 2U << 20U);
}

} // namespace
} // namespace texloom::test

#include "core/io/image_file.h"
#include "core/io/temporary_file.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <charconv>
#include <fstream>

namespace texloom::test {

namespace fs = std::filesystem;

TEST(TemporaryFile, NeverTakesAFileThatIsThere) {
    const TemporaryFolder folder;
    std::string taken;
    {
        const TemporaryFile probe(folder / "a.txt");
        taken = fs::directory_iterator(folder.path())->path().stem().string();
    }
    // What a process of the same number on another machine writes in a shared folder.
    const std::size_t dash = taken.rfind('-') + 1;
    int number = 0;
    std::from_chars(taken.data() + dash, taken.data() + taken.size(), number);
    const fs::path theirs = folder / fmt::format("{}{}.txt", taken.substr(0, dash), number + 1);
    std::ofstream(theirs) << "theirs";
    for (int i = 0; i < 4; ++i)
        writeText(folder / "a.txt", "ours");
    EXPECT_EQ(readText(folder / "a.txt"), "ours");
    ASSERT_TRUE(fs::exists(theirs));
    EXPECT_EQ(readText(theirs), "theirs");
}

} // namespace texloom::test

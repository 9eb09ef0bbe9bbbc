#include "core/io/image_file.h"
#include "core/io/temporary_file.h"
#include "tests/support/temporary_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
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

TEST(TemporaryFile, KeepsLinksAndRights) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "inner");
    writeText(folder / "inner" / "real.txt", "before");
    fs::permissions(folder / "inner" / "real.txt", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("inner/real.txt", folder / "link.txt");
    fs::create_symlink("link.txt", folder / "far.txt");
    writeText(folder / "far.txt", "after");
    EXPECT_TRUE(fs::is_symlink(folder / "far.txt") && fs::is_symlink(folder / "link.txt"));
    EXPECT_EQ(readText(folder / "inner" / "real.txt"), "after");
    EXPECT_EQ(fs::status(folder / "inner" / "real.txt").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("inner/new.txt", folder / "to_new.txt");
    writeText(folder / "to_new.txt", "made");
    EXPECT_EQ(readText(folder / "inner" / "new.txt"), "made");
}

TEST(TemporaryFile, SweepsWhatKilledProgramsLeft) {
    const TemporaryFolder folder;
    const auto old = fs::file_time_type::clock::now() - std::chrono::minutes(5);
    for (const char* name : {".texloom-1-0.png", ".texloom-2-0.png", ".texloom-3-0.png", "mine.png"}) {
        std::ofstream(folder / name) << "left";
        fs::last_write_time(folder / name, old);
    }
    fs::last_write_time(folder / ".texloom-2-0.png", fs::file_time_type::clock::now());
    const int held = ::open((folder / ".texloom-3-0.png").c_str(), O_RDONLY);
    ::flock(held, LOCK_EX);
    writeText(folder / "new.txt", "new");
    ::close(held);
    EXPECT_FALSE(fs::exists(folder / ".texloom-1-0.png"));
    EXPECT_TRUE(fs::exists(folder / ".texloom-2-0.png")); // just written
    EXPECT_TRUE(fs::exists(folder / ".texloom-3-0.png")); // at work
    EXPECT_TRUE(fs::exists(folder / "mine.png"));
}

} // namespace texloom::test

#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/core/io/foreign_files.h"
#include "tests/support/textures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Runs texloom-cli as `sh -c 'PREPARE; exec texloom-cli …'`.
Ended runAfter(const std::string& prepare, std::vector<std::string> arguments, const fs::path& folder) {
    arguments.insert(arguments.begin(), {"-c", prepare + "; exec \"$0\" \"$@\"", TEXLOOM_CLI});
    return runCli(arguments, folder, "/bin/sh");
}

/// A control group with a limit of memory, gone with the object. Of either version, where this process may
/// make one.
class MemoryGroup {
public:
    explicit MemoryGroup(std::uint64_t bytes) {
        std::ifstream lines("/proc/self/cgroup");
        for (std::string line; std::getline(lines, line) && m_path.empty();) {
            const std::size_t first = line.find(':'), second = line.find(':', first + 1);
            const std::string controllers = line.substr(first + 1, second - first - 1);
            const std::string group = line.substr(second + 1);
            if (controllers.empty())
                make(fs::path("/sys/fs/cgroup") / fs::path(group).relative_path(), "memory.max", bytes);
            else if (controllers == "memory")
                make(fs::path("/sys/fs/cgroup/memory") / fs::path(group).relative_path(),
                     "memory.limit_in_bytes", bytes);
        }
    }
    ~MemoryGroup() {
        if (!m_path.empty())
            ::rmdir(m_path.c_str());
    }
    MemoryGroup(const MemoryGroup&) = delete;
    MemoryGroup& operator=(const MemoryGroup&) = delete;

    bool made() const { return !m_path.empty(); }
    /// The shell's command by which it and what it becomes join.
    std::string join() const { return "echo $$ > " + (m_path / "cgroup.procs").string(); }

private:
    void make(const fs::path& parent, const char* limit, std::uint64_t bytes) {
        const fs::path path = parent / fmt::format("texloom-test-{}", ::getpid());
        if (::mkdir(path.c_str(), 0755) != 0)
            return;
        std::ofstream file(path / limit);
        file << bytes;
        file.flush();
        if (file && fs::exists(path / limit))
            m_path = path;
        else
            ::rmdir(path.c_str());
    }

    fs::path m_path;
};

class Limits : public ::testing::Test {
protected:
    TemporaryFolder m_folder;
};

} // namespace

TEST_F(Limits, AControlGroupIsHeededWhileDecoding) {
    constexpr std::uint64_t kBytes = 300ULL << 20;
    const MemoryGroup group(kBytes);
    if (!group.made())
        GTEST_SKIP() << "skipped: this process may not make control groups with a limit of memory";
    writeEmptyTiff(m_folder / "claims.tif", 9000, true);
    const Ended large = runAfter(
        group.join(), {"synth", "random-phase", "claims.tif", "-o", "a.png", "--quiet"}, m_folder.path());
    EXPECT_EQ(large.status, 1) << large.err;
    EXPECT_EQ(large.complaints(), 1) << large.err;
    EXPECT_THAT(large.err, HasSubstr("claims.tif"));
    EXPECT_FALSE(fs::exists(m_folder / "a.png"));

    writeImage(m_folder / "small.png", blobs({64, 64}, 3), {});
    const Ended small = runAfter(
        group.join(), {"synth", "random-phase", "small.png", "-o", "b.png", "--quiet"}, m_folder.path());
    EXPECT_EQ(small.status, 0) << small.err;
}

/// With few addresses the system may refuse memory, threads and libraries at any moment. What remains to be
/// promised is that the program ends in a sentence and leaves nothing half-written. Where not even its
/// libraries can be loaded, the sentence is the system's.
TEST_F(Limits, FewAddressesEndInASentence) {
    writeImage(m_folder / "a.png", blobs({256, 256}, 3), {});
    constexpr int kLoaderFailed = 127;
    int done = 0, refused = 0;
    for (const int mebibytes : {300, 385, 390, 395, 400, 410, 420, 430, 440, 450, 460, 500, 600, 800, 1200}) {
        const Ended ended = runAfter(fmt::format("ulimit -v {}", mebibytes * 1024),
                                     {"synth", "heeger-bergen", "a.png", "-o", "out.png", "--overwrite",
                                      "--quiet", "--threads", "64", "--set", "iterations=1"},
                                     m_folder.path());
        if (ended.status == kLoaderFailed && done + refused == 0) {
            EXPECT_EQ(ended.complaints(), 1) << ended.err;
            continue;
        }
        EXPECT_TRUE(ended.status == 0 || ended.status == 1) << mebibytes << ": " << ended.status << ended.err;
        EXPECT_EQ(ended.complaints(), ended.status) << ended.err;
        done += ended.status == 0;
        refused += ended.status == 1;
    }
    EXPECT_GT(done, 0);
    EXPECT_GT(refused, 0);
    EXPECT_EQ(readImage(m_folder / "out.png").info.size, (Size{512, 512}));
}

} // namespace texloom::test

#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/core/io/foreign_files.h"
#include "tests/support/textures.h"
#include "tests/support/time_limit.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <fstream>
#include <thread>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

/// The first child of a process; 0 if there is none.
pid_t childOf(pid_t process) {
    std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", process));
    pid_t child = 0;
    children >> child;
    return child;
}

/// Waits until the program's decoder is at work.
void waitForDecoder(Program& program) {
    const auto decodes = [&program] {
        const pid_t maker = childOf(program.id());
        return maker > 0 && childOf(maker) > 0;
    };
    while (program.running() && !decodes())
        std::this_thread::sleep_for(5ms);
}

class Hostile : public ::testing::Test {
protected:
    Ended synth(const std::string& exemplar, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"synth", "random-phase", exemplar, "-o", "out.png", "--quiet"});
        return runCli(more, m_folder.path());
    }
    void refused(const Ended& ended, const std::string& part) {
        EXPECT_EQ(ended.status, 1) << ended.err;
        EXPECT_EQ(ended.complaints(), 1) << ended.err;
        EXPECT_THAT(ended.err, HasSubstr(part));
        EXPECT_FALSE(fs::exists(m_folder / "out.png"));
    }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(Hostile, AFileThatClaimsMoreThanMayBeTakenIsRefused) {
    writeEmptyTiff(m_folder / "claims.tif", 6000, true);
    refused(synth("claims.tif", {"--memory", "200"}), "more than the");
    refused(runCli({"analyze", "lattice", "claims.tif", "--memory", "200"}, m_folder.path()), "6000 × 6000");
}

TEST_F(Hostile, AFileThatHoldsLessThanItClaimsIsRefusedAtOnce) {
    writeEmptyTiff(m_folder / "claims.tif", 16000, false);
    refused(synth("claims.tif"), "cut short");
}

TEST_F(Hostile, AnAnalysisTakesNoMoreThanItMay) {
    writeImage(m_folder / "a.png", blobs({1200, 1200}, 3), {});
    refused(runCli({"analyze", "lattice", "a.png", "--memory", "220"}, m_folder.path()), "look at a (1200");
    EXPECT_EQ(runCli({"analyze", "lattice", "a.png", "--memory", "2000"}, m_folder.path()).status, 0);
    for (const std::vector<std::string>& analysis : {std::vector<std::string>{"statistics", "a.png"},
                                                     {"quality", "a.png", "a.png"},
                                                     {"maps", "a.png", "a.png"}}) {
        std::vector<std::string> arguments = {"analyze"};
        arguments.insert(arguments.end(), analysis.begin(), analysis.end());
        arguments.insert(arguments.end(), {"--memory", "180"});
        refused(runCli(arguments, m_folder.path()), "look at a (1200");
    }
}

TEST_F(Hostile, AnInterruptEndsDecoding) {
    writeEmptyTiff(m_folder / "large.tif", 12000, true);
    Program program({"analyze", "lattice", "large.tif"}, m_folder.path());
    waitForDecoder(program);
    ASSERT_TRUE(program.running());
    const auto limit = limitNow(1s);
    const auto sent = std::chrono::steady_clock::now();
    program.signal(SIGINT);
    const Ended ended = program.wait();
    EXPECT_LE(std::chrono::steady_clock::now() - sent, limit.value_or(std::chrono::hours(1)));
    EXPECT_EQ(ended.status, 130);
    EXPECT_EQ(ended.complaints(), 1) << ended.err;
}

TEST_F(Hostile, ADecoderThatAbortsEndsInASentence) {
    writeTiledInkTiff(m_folder / "a.tif");
    refused(synth("a.tif"), "a.tif cannot be read: its decoder broke down");
}

TEST_F(Hostile, NamesOfAnyBytesComeBack) {
    const std::string name = "latin\xe9.png";
    writeImage(m_folder / "a.png", blobs({32, 32}, 3), {});
    fs::rename(m_folder / "a.png", m_folder / name);
    ASSERT_EQ(synth(name).status, 0);
    const Ended again = runCli({"run", "out.json", "-o", "again.png", "--quiet"}, m_folder.path());
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_TRUE(samePixels(readImage(m_folder / "out.png").image, readImage(m_folder / "again.png").image));
}

TEST_F(Hostile, EqualRunsMakeEqualFilesWhenAsked) {
    writeImage(m_folder / "a.png", blobs({32, 32}, 3), {});
    for (const char* extension : {".exr", ".tif"}) {
        std::vector<std::string> files;
        for (const char* name : {"one", "two"}) {
            const std::string output = std::string(name) + extension;
            EXPECT_EQ(runCli({"synth", "random-phase", "a.png", "-o", output, "--quiet", "--reproducible",
                              "--no-sidecar"},
                             m_folder.path())
                          .status,
                      0);
            files.push_back(readText(m_folder / output));
            std::this_thread::sleep_for(1100ms); // the time of day in files counts seconds
        }
        EXPECT_EQ(files[0], files[1]) << extension;
    }
}

} // namespace texloom::test

#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"
#include "tests/support/time_limit.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <thread>

namespace texloom::test {

namespace {

using namespace std::chrono_literals;

constexpr auto kSoon = 1s; // far above the 100 ms of a job, which are tested elsewhere

/// A folder with an exemplar, and a synth on it that takes minutes.
class Interrupt : public ::testing::TestWithParam<int> {
protected:
    Interrupt() { writeImage(m_folder / "bark.png", blobs({400, 400}, 3), {}); }

    std::vector<std::string> longSynth(std::vector<std::string> options = {}) const {
        std::vector<std::string> arguments = {"synth",  "quilting", "bark.png", "--set",  "patch=12",
                                              "--size", "4096",     "-o",       "out.png"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return arguments;
    }
    /// Waits until the program has done this much work.
    static void waitForWork(Program& program, std::chrono::milliseconds work) {
        while (program.running() && program.worked() < work)
            std::this_thread::sleep_for(1ms);
        ASSERT_TRUE(program.running());
    }
    /// Signals the program, and expects it to end soon, as far as what else this machine does lets that be
    /// told.
    static Ended endedSoon(Program& program, int signal) {
        const auto limit = limitNow(kSoon);
        const auto asked = std::chrono::steady_clock::now();
        program.signal(signal);
        Ended ended = program.wait();
        const auto taken = std::chrono::steady_clock::now() - asked;
        if (limit) {
            EXPECT_LE(taken, *limit);
        } else {
            std::cout << "The time is not judged. " << kTooBusy << '\n';
        }
        return ended;
    }

    TemporaryFolder m_folder;
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Cli, Interrupt, ::testing::Values(SIGINT, SIGTERM));

TEST_P(Interrupt, EndsALongSynthAtOnceAndLeavesNothing) {
    Program program(longSynth({"--map", "map.exr"}), m_folder.path());
    waitForWork(program, 1500ms);
    const Ended ended = endedSoon(program, GetParam());
    EXPECT_EQ(ended.status, 130);
    EXPECT_EQ(ended.complaints(), 1) << ended.err;
    EXPECT_EQ(m_folder.entries(), 1);
}

TEST_F(Interrupt, KeepsAnEarlierOutput) {
    writeText(m_folder / "out.png", "an earlier result");
    Program program(longSynth({"--overwrite"}), m_folder.path());
    waitForWork(program, 1500ms);
    program.signal(SIGINT);
    EXPECT_EQ(program.wait().status, 130);
    EXPECT_EQ(readText(m_folder / "out.png"), "an earlier result");
    EXPECT_EQ(m_folder.entries(), 2);
}

TEST_F(Interrupt, EndsTheWritingOfALargeFileAndLeavesNothing) {
    // A large patch makes the synthesis short beside the writing of 64 megapixels.
    Program program({"synth", "quilting", "bark.png", "--set", "patch=400", "--set", "overlap=0.02", "--size",
                     "8192", "-o", "out.png"},
                    m_folder.path());
    while (program.running() && m_folder.entries() == 1)
        std::this_thread::sleep_for(1ms);
    ASSERT_TRUE(program.running());
    const Ended ended = endedSoon(program, SIGINT);
    EXPECT_EQ(ended.status, 130);
    EXPECT_EQ(m_folder.entries(), 1);
}

} // namespace texloom::test

#include "core/base/error.h"
#include "core/io/decoder_process.h"
#include "core/io/image_file.h"
#include "core/job/job.h"
#include "tests/core/io/foreign_files.h"
#include "tests/core/io/write_as.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

/// The first child of a process; 0 if there is none.
pid_t childOf(pid_t process) {
    std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", process));
    pid_t child = 0;
    children >> child;
    return child;
}

/// What the check of the whole program does now.
std::function<void()> onCheck;

/// Reads in processes of their own in all tests of this program, as the programs do.
class Apart : public ::testing::Environment {
    void SetUp() override {
        DecoderProcess::start([] {
            if (onCheck)
                onCheck();
        });
        ASSERT_TRUE(DecoderProcess::running());
    }
};
const auto* const apart = ::testing::AddGlobalTestEnvironment(new Apart);

/// Sets the check while it lives.
class Check {
public:
    explicit Check(std::function<void()> check) { onCheck = std::move(check); }
    ~Check() { onCheck = {}; }
    Check(const Check&) = delete;
    Check& operator=(const Check&) = delete;
};

/// What decode() says in this process; empty if it succeeds.
std::string sentenceHere(const fs::path& path) {
    try {
        decode({path}, [](std::size_t) -> float* { throw Error("decoded"); });
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(DecoderProcess, ReadsWhatThisProcessReads) {
    const TemporaryFolder folder;
    for (const auto& [name, depth] : {std::pair("a.png", Depth::Bits16),
                                      {"a.jpg", Depth::Bits8},
                                      {"a.tif", Depth::Float},
                                      {"a.hdr", Depth::Float}}) {
        writeImage(folder / name, noise({90, 70}, 3), as(depth, "srgb", R"({"texloom": 1})"));
        std::vector<float> here;
        const DecodedHeader header = decode({folder / name}, [&here](std::size_t samples) {
            here.resize(samples);
            return here.data();
        });
        const DecoderProcess::Decoded there = DecoderProcess::decode({folder / name});
        EXPECT_EQ(there.header.toJson(), header.toJson());
        EXPECT_TRUE(std::equal(here.begin(), here.end(), there.samples)) << name;
        EXPECT_EQ(readImageInfo(folder / name).size, (Size{90, 70}));
    }
}

TEST(DecoderProcess, RefusesInTheSameWords) {
    const TemporaryFolder folder;
    writeText(folder / "text.png", "no image");
    writeHugePngHeader(folder / "huge.png", 100000, 100000);
    writeText(folder / "empty.tif", "");
    for (const char* name : {"text.png", "huge.png", "empty.tif", "gone.png"})
        EXPECT_THAT([&] { readImage(folder / name); }, refusal(sentenceHere(folder / name))) << name;
    writeImage(folder / "a.png", blobs({8, 8}, 3), {});
    EXPECT_THAT([&] { readImage(folder / "a.png", {.layer = "x"}); }, usageRefusal("x"));
}

TEST(DecoderProcess, TakesAnyName) {
    const TemporaryFolder folder;
    const fs::path path = folder / "latin\xe9.png";
    writeImage(folder / "a.png", blobs({8, 8}, 3), {});
    fs::rename(folder / "a.png", path);
    EXPECT_EQ(readImage(path).info.size, (Size{8, 8}));
}

TEST(DecoderProcess, StopsWhenItsCheckThrows) {
    const TemporaryFolder folder;
    writeEmptyTiff(folder / "large.tif", 6000, true);
    int calls = 0;
    const Check check([&calls] {
        if (++calls > 1)
            throw Cancelled{};
    });
    EXPECT_THROW(readImage(folder / "large.tif"), Cancelled);
}

TEST(DecoderProcess, StopsForTheThreadThatIsWatched) {
    const TemporaryFolder folder;
    writeEmptyTiff(folder / "large.tif", 6000, true);
    int calls = 0;
    const auto stop = [&calls] {
        if (++calls > 1)
            throw Cancelled{};
    };
    {
        const DecoderProcess::Watch outer(stop);
        const DecoderProcess::Watch inner([] {});
        EXPECT_NO_THROW(readImageInfo(folder / "large.tif"));
        EXPECT_EQ(calls, 0) << "the innermost counts";
    }
    {
        const DecoderProcess::Watch watch(stop);
        std::thread([&folder] { EXPECT_NO_THROW(readImageInfo(folder / "large.tif")); }).join();
        EXPECT_EQ(calls, 0) << "of this thread alone";
        EXPECT_THROW(readImage(folder / "large.tif"), Cancelled);
    }
    EXPECT_NO_THROW(readImageInfo(folder / "large.tif"));
}

TEST(DecoderProcess, OutlivesADecoderThatDies) {
    // As the system ends a process that takes too much, or abort() one that is in a state it cannot be in.
    const TemporaryFolder folder;
    writeImage(folder / "a.png", blobs({8, 8}, 3), {});
    writeEmptyTiff(folder / "large.tif", 6000, true);
    const Check check([] {
        const pid_t maker = childOf(::getpid());
        if (const pid_t decoder = maker > 0 ? childOf(maker) : 0; decoder > 0)
            ::kill(decoder, SIGKILL);
    });
    EXPECT_THAT([&] { readImage(folder / "large.tif"); }, refusal("large.tif", "broke down"));
}

} // namespace texloom::test

#include "core/io/decoder_process.h"
#include "core/session/run/exemplar_file.h"
#include "core/session/run/input_file.h"
#include "tests/core/io/foreign_files.h"
#include "tests/core/io/write_as.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace texloom::test {

/// From the decoder's samples on, each step over a large picture can be stopped at every row.
TEST(LoadExemplar, CanBeStoppedAllTheWhile) {
    constexpr int kRows = 400;
    const TemporaryFolder folder;
    Image image = noise({300, kRows}, 4);
    for (int x = 0; x < 150; ++x)
        image(x, 200, 3) = 0;
    writeImage(folder / "leaf.exr", image, as(Depth::Float, "linear"));
    const auto asked = [&](const auto& load) {
        int count = 0;
        const DecoderProcess::Watch watch([&count] { ++count; });
        load();
        return count;
    };
    // Taken up, looked through, divided by alpha.
    EXPECT_GE(asked([&] { readImage(folder / "leaf.exr"); }), 3 * kRows);
    // And what is hidden filled: looked for, taken out, halved, filled, put back.
    EXPECT_GE(asked([&] { loadExemplar(folder / "leaf.exr"); }), 7 * kRows);
    EXPECT_GE(asked([&] { loadMask(folder / "leaf.exr"); }), 3 * kRows);
    EXPECT_GE(asked([&] { fileHash(folder / "leaf.exr"); }), 7); // blocks of 64 KiB
    const DecoderProcess::Watch watch([] { throw std::length_error("stop"); });
    EXPECT_THROW(loadExemplar(folder / "leaf.exr"), std::length_error);
}

TEST(LoadExemplar, KnowsNoColourUnderAlphaZero) {
    const TemporaryFolder folder;
    Image image({16, 16}, 4);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            image(x, y, 0) = image(x, y, 2) = 1;
    for (int x = 0; x < 16; ++x)
        for (const auto& [c, value] : {std::pair(0, 0.2F), {1, 0.4F}, {2, 0.2F}, {3, 1.0F}})
            image(x, 5, c) = value;
    writeImage(folder / "leaf.png", image, {});
    const Image loaded = *loadExemplar(folder / "leaf.png").image;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_NEAR(loaded(x, y, 1), 0.4F, 0.01F);
    EXPECT_EQ(loaded(0, 0, 3), 0);
    EXPECT_EQ((*loadData(folder / "leaf.png").image)(0, 0, 1), 0);
}

/// No method is told of it: whatever reads a picture for one gives the same bits for any colour there.
TEST(LoadExemplar, GivesTheSameBitsForAnyColourUnderAlphaZero) {
    const TemporaryFolder folder;
    const Port port{.id = "initial", .title = "Start", .help = ""};
    for (const auto& [name, depth] : {std::pair{"a.png", Depth::Bits8},
                                      {"a.png", Depth::Bits16},
                                      {"a.tif", Depth::Bits8},
                                      {"a.tif", Depth::Float}}) {
        std::vector<std::vector<Image>> read;
        for (const float hidden : {0.0F, 1.0F}) {
            Image image = blobs({24, 20}, 4);
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 24; ++x) {
                    const bool seen = (x / 3 + y / 4) % 2 == 0;
                    image(x, y, 3) = seen ? 0.2F * static_cast<float>(1 + x % 5) : 0;
                    for (int c = 0; c < 3 && !seen; ++c)
                        image(x, y, c) = c == 1 ? 1 - hidden : hidden;
                }
            const auto file = folder / name;
            writeImage(file, image, as(depth));
            read.push_back({*loadExemplar(file).image, *loadExemplar(file, "linear").image,
                            *loadUnconverted(file).image, *loadInput(port, {file, "", ""}, {}).image()});
        }
        for (std::size_t way = 0; way < read[0].size(); ++way)
            EXPECT_TRUE(samePixels(read[0][way], read[1][way])) << name << ", way " << way;
    }
}

TEST(LoadCompanions, NotesWhatWasCompressedWithLoss) {
    const TemporaryFolder folder;
    const Image map = blobs({32, 32}, 3);
    writeImage(folder / "bark_orm.jpg", map, {});
    writeImage(folder / "bark_normal.png", map, {});
    writeForeign(folder / "dwa.exr", map, {.type = "half", .compression = "dwaa"});
    writeForeign(folder / "b44.exr", map, {.type = "half", .compression = "b44"});
    writeForeign(folder / "b44_float.exr", map, {.compression = "b44"}); // which leaves floats alone
    writeForeign(folder / "pxr24.exr", map, {.compression = "pxr24"});
    writeForeign(folder / "piz.exr", map, {.type = "half", .compression = "piz"});
    const auto notes = [&](const char* name) {
        return loadCompanions(folder / name).front().info.notes.size();
    };
    for (const char* lossy : {"bark_orm.jpg", "dwa.exr", "b44.exr", "pxr24.exr"}) {
        EXPECT_EQ(notes(lossy), 1U) << lossy;
        EXPECT_EQ(loadMask(folder / lossy).info.notes.size(), 1U) << lossy;
        EXPECT_TRUE(loadExemplar(folder / lossy).info.notes.empty()) << lossy; // a picture may be so
    }
    for (const char* exact : {"bark_normal.png", "b44_float.exr", "piz.exr"})
        EXPECT_EQ(notes(exact), 0U) << exact;
}

} // namespace texloom::test

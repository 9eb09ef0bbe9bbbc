#include "core/color/color_pipeline.h"
#include "core/io/image_file.h"
#include "core/session/run/exemplar_file.h"
#include "tests/core/color/srgb.h"
#include "tests/core/io/foreign_files.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <cmath>

namespace texloom::test {

namespace {

using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

Bytes number(std::uint32_t value) {
    return {static_cast<std::uint8_t>(value >> 24), static_cast<std::uint8_t>(value >> 16),
            static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
}

Bytes chromaticities(const std::array<std::uint32_t, 8>& values) {
    Bytes bytes;
    for (const std::uint32_t value : values)
        for (const std::uint8_t byte : number(value))
            bytes.push_back(byte);
    return bytes;
}

using Chunks = std::vector<std::pair<std::string, Bytes>>;

struct Tagged {
    explicit Tagged(const Chunks& chunks, const std::array<std::uint8_t, 3>& color = {128, 128, 128}) {
        writeTaggedPng(folder / "a.png", color, chunks);
        file = loadExemplar(folder / "a.png");
    }
    double at(int channel) const { return static_cast<double>((*file.image)(0, 0, channel)); }

    TemporaryFolder folder;
    ExemplarFile file;
};

constexpr double kHalf = 128 / 255.0;
const Bytes kP3Codes = {12, 13, 0, 1};

} // namespace

TEST(ColorTags, OfSrgbChangeNothing) {
    const Bytes primaries = chromaticities({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000});
    for (const Chunks& chunks : {Chunks{}, Chunks{{"sRGB", {0}}}, Chunks{{"gAMA", number(45455)}},
                                 Chunks{{"gAMA", number(45455)}, {"cHRM", primaries}},
                                 Chunks{{"cHRM", primaries}}, Chunks{{"cICP", {1, 13, 0, 1}}}}) {
        const Tagged tagged(chunks);
        EXPECT_EQ(tagged.file.space, "srgb");
        EXPECT_EQ(tagged.at(0), static_cast<double>(static_cast<float>(kHalf)));
        EXPECT_TRUE(tagged.file.info.notes.empty());
    }
}

TEST(ColorTags, GammaOfAPngIsTaken) {
    const Tagged linear({{"gAMA", number(100000)}});
    EXPECT_EQ(linear.file.space, "linear");
    EXPECT_NEAR(linear.at(1), encoded(kHalf), 1e-4);
    const Tagged mac({{"gAMA", number(55556)}});
    EXPECT_EQ(mac.file.space, "file");
    EXPECT_NEAR(mac.at(2), encoded(std::pow(kHalf, 1.8)), 1e-4);
    EXPECT_THAT(mac.file.info.notes.front().text(), HasSubstr("gamma 1.8"));
}

TEST(ColorTags, DisplayP3RedIsMoreThanRed) {
    // Red of Display P3 in linear Rec.709, by the published matrix: 1.2249, -0.0420, -0.0197.
    const Tagged red({{"cICP", kP3Codes}}, {255, 0, 0});
    EXPECT_NEAR(red.at(0), encoded(1.2249), 1e-3);
    EXPECT_LT(red.at(1), 0);
    const Tagged white({{"cICP", kP3Codes}}, {255, 255, 255});
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(white.at(c), 1, 1e-4);
    // Its primaries alone leave the curve to sRGB.
    const Bytes primaries = chromaticities({31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000});
    const Tagged alone({{"cHRM", primaries}}, {255, 0, 0});
    EXPECT_NEAR(alone.at(0), encoded(1.2249), 1e-3);
    EXPECT_LT(alone.at(1), 0);
}

TEST(ColorTags, WhatCannotBeConvertedIsNamed) {
    const Tagged pq({{"cICP", {9, 16, 0, 1}}});
    EXPECT_EQ(pq.file.space, "srgb");
    ASSERT_EQ(pq.file.info.notes.size(), 1U);
    EXPECT_THAT(pq.file.info.notes.front().text(), HasSubstr("9-16-0-1"));
    const TemporaryFolder folder;
    writeForeign(folder / "a.tif", Image({2, 2}, 3), {.iccProfile = "Strange RGB"});
    EXPECT_THAT(readImageInfo(folder / "a.tif").notes.front().text(), HasSubstr("Strange RGB"));
}

TEST(ColorTags, ASpaceThatSomeoneNamesCountsInstead) {
    const TemporaryFolder folder;
    writeTaggedPng(folder / "a.png", {128, 128, 128}, {{"gAMA", number(55556)}});
    EXPECT_EQ((*loadExemplar(folder / "a.png", "srgb").image)(0, 0, 0), static_cast<float>(kHalf));
    EXPECT_EQ(loadExemplar(folder / "a.png", "file").space, "file");
}

TEST(ColorTags, ChromaticitiesOfAnExrAreTaken) {
    const TemporaryFolder folder;
    Image red({2, 2}, 3);
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}})
        red(x, y, 0) = 1;
    writeForeign(folder / "p3.exr", red,
                 {.chromaticities = {0.68F, 0.32F, 0.265F, 0.69F, 0.15F, 0.06F, 0.3127F, 0.329F}});
    const ExemplarFile p3 = loadExemplar(folder / "p3.exr");
    EXPECT_EQ(p3.space, "file");
    EXPECT_NEAR(static_cast<double>((*p3.image)(0, 0, 0)), encoded(1.2249), 1e-3);
    writeForeign(folder / "own.exr", red,
                 {.chromaticities = {0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F}});
    EXPECT_EQ(loadExemplar(folder / "own.exr").space, "linear");
    writeForeign(folder / "aces.exr", red,
                 {.chromaticities = {0.713F, 0.293F, 0.165F, 0.83F, 0.128F, 0.044F, 0.32168F, 0.33767F}});
    EXPECT_EQ(loadExemplar(folder / "aces.exr").space, "acescg");
}

TEST(FileColor, GoesThereAndBack) {
    FileColor color;
    color.curve = FileColor::Curve::Power;
    color.power = 1.8;
    color.toRec709 = toRec709({0.68, 0.32, 0.265, 0.69, 0.15, 0.06, 0.3127, 0.329});
    Image image({1, 1}, 3);
    for (int c = 0; c < 3; ++c)
        image(0, 0, c) = 0.2F + 0.3F * static_cast<float>(c);
    const Image before = image;
    color::toWorking(image, color);
    color::fromWorking(image, color);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(image(0, 0, c), before(0, 0, c), 1e-5F);
}

} // namespace texloom::test

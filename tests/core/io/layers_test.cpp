#include "core/io/channel_names.h"
#include "core/io/image_file.h"
#include "tests/core/io/foreign_files.h"
#include "tests/core/io/write_as.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <map>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Names = std::vector<std::string>;

/// An image whose channel c is c + 1 hundredths everywhere.
Image numbered(int channels) {
    Image image({6, 5}, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 6; ++x)
                image(x, y, c) = 0.01F * static_cast<float>(c + 1);
    return image;
}

/// The value by each channel's name.
std::map<std::string, float> valuesOf(const LoadedImage& loaded) {
    std::map<std::string, float> values;
    for (int c = 0; c < loaded.image.channels(); ++c)
        values[loaded.info.channelNames[static_cast<std::size_t>(c)]] = loaded.image(0, 0, c);
    return values;
}

} // namespace

TEST(Channels, KeepTheirNamesAndPlacesThroughManyPasses) {
    const TemporaryFolder folder;
    const Names names = {"R", "G", "B", "A", "Z", "u.x", "u.y", "m.a", "m.b", "m.c"};
    writeForeign(folder / "a.exr", numbered(10), {.channelNames = names});
    const ReadOptions data{.data = true};
    const LoadedImage first = readImage(folder / "a.exr", data);
    EXPECT_THAT(first.info.channelNames, ::testing::UnorderedElementsAreArray(names));
    LoadedImage last = first;
    for (int pass = 0; pass < 3; ++pass) {
        WriteOptions options = as(Depth::Float, "raw");
        options.channelNames = last.info.channelNames;
        writeImage(folder / "b.exr", last.image, options);
        last = readImage(folder / "b.exr", data);
    }
    EXPECT_EQ(last.info.channelNames, first.info.channelNames);
    EXPECT_EQ(valuesOf(last), valuesOf(first));
    EXPECT_NEAR(valuesOf(last).at("m.c"), 0.1F, 1e-6F);
}

TEST(Channels, OfOneLayerKeepItsName) {
    const TemporaryFolder folder;
    writeForeign(folder / "a.exr", numbered(3), {.channelNames = {"diffuse.R", "diffuse.G", "diffuse.B"}});
    const ImageFileInfo info = readImageInfo(folder / "a.exr");
    EXPECT_THAT(info.channelNames, ElementsAre("diffuse.R", "diffuse.G", "diffuse.B"));
    EXPECT_TRUE(info.layers.empty() && info.notes.empty());
    EXPECT_EQ(readImageInfo(folder / "a.exr", "diffuse").channels, 3);
    writeForeign(folder / "z.exr", numbered(1), {.channelNames = {"Z"}});
    EXPECT_THAT(readImageInfo(folder / "z.exr").channelNames, ElementsAre("Z"));
}

TEST(Layers, CanBeChosen) {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.exr";
    writeForeign(path, numbered(6), {.channelNames = {"R", "G", "B", "diffuse.R", "diffuse.G", "diffuse.B"}});
    const LoadedImage whole = readImage(path);
    EXPECT_EQ(whole.image.channels(), 6);
    EXPECT_THAT(whole.info.layers, ElementsAre("diffuse"));
    ASSERT_EQ(whole.info.notes.size(), 1U);
    EXPECT_THAT(whole.info.notes.front().text(), HasSubstr("diffuse"));
    const LoadedImage layer = readImage(path, {.layer = "diffuse"});
    EXPECT_THAT(layer.info.channelNames, ElementsAre("diffuse.R", "diffuse.G", "diffuse.B"));
    EXPECT_NEAR(layer.image(2, 2, 1), 0.05F, 1e-6F);
    EXPECT_TRUE(layer.info.notes.empty());
    EXPECT_THAT([&] { readImage(path, {.layer = "specular"}); }, usageRefusal("specular", "diffuse"));
}

TEST(Parts, CanBeChosen) {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.exr";
    const Image first = numbered(3), second = numbered(4);
    writeParts(path, {first, second}, {"colour", "depth"});
    const LoadedImage whole = readImage(path);
    EXPECT_EQ(whole.image.channels(), 3);
    ASSERT_EQ(whole.info.notes.size(), 1U);
    EXPECT_THAT(whole.info.notes.front().text(), HasSubstr("colour and depth"));
    EXPECT_EQ(readImage(path, {.layer = "depth"}).image.channels(), 4);
    EXPECT_THAT([&] { readImage(path, {.layer = "3"}); }, usageRefusal("colour and depth"));
}

TEST(Layers, AreRefusedWhereThereAreNone) {
    const TemporaryFolder folder;
    writeImage(folder / "a.png", numbered(3), {});
    EXPECT_THAT([&] { readImage(folder / "a.png", {.layer = "diffuse"}); }, usageRefusal("a.png", "diffuse"));
}

TEST(WideNumbers, AreScaledByTheLargest) {
    const TemporaryFolder folder;
    writeWideTiff(folder / "a.tif", {2, 2}, {0, 65535, 13107, 32768});
    const LoadedImage loaded = readImage(folder / "a.tif");
    EXPECT_EQ(loaded.image(1, 0, 0), 1);
    EXPECT_NEAR(loaded.image(0, 1, 0), 0.2F, 1e-6F);
    ASSERT_EQ(loaded.info.notes.size(), 1U);
    EXPECT_THAT(loaded.info.notes.front().text(), HasSubstr("65535"));
}

TEST(AlphaGroups, BelongToTheirLayer) {
    const std::vector<AlphaGroup> groups = alphaGroups({"R", "G", "B", "A", "Z", "d.R", "d.A", "n.x", "n.A"});
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].alpha, 3);
    EXPECT_THAT(groups[0].colours, ElementsAre(0, 1, 2));
    EXPECT_EQ(groups[1].alpha, 6);
    EXPECT_THAT(groups[1].colours, ElementsAre(5));
}

TEST(DisplayWindow, ThatDiffersIsNamed) {
    const TemporaryFolder folder;
    writeForeign(folder / "a.exr", numbered(3), {.x = 3, .y = 2});
    ASSERT_EQ(readImageInfo(folder / "a.exr").notes.size(), 1U);
    EXPECT_THAT(readImageInfo(folder / "a.exr").notes.front().text(), HasSubstr("(3, 2)"));
}

} // namespace texloom::test

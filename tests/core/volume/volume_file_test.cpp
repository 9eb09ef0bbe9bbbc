#include "core/volume/volume_file.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/volumes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <fstream>
#include <tuple>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const VolumeSize kVolume{6, 5, 4};

std::string get(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

DenseSource sample(int channels, DenseSource::Edge edge = DenseSource::Edge::Ends) {
    return {sampleVolume(kVolume, channels), edge};
}

/// Writes the sample, whole.
void write(const fs::path& path, int channels, const VolumeWriteOptions& options = {}) {
    TestContext context;
    writeVolume(path, sample(channels), {0, 0, 0, kVolume}, options, context);
}

LoadedVolume read(const fs::path& path, std::int64_t most = kLargestFileVoxels) {
    TestContext context;
    return readVolume(path, context, {{}, most});
}

/// Writes a raw volume and changes what its head says.
fs::path changed(const TemporaryFolder& folder, const std::string& key, const Json& value) {
    write(folder / "v.json", 2);
    Json head = Json::parse(get(folder / "v.json"));
    if (value.is_discarded())
        head.erase(key);
    else
        head[key] = value;
    std::ofstream(folder / "v.json") << head.dump();
    return folder / "v.json";
}

} // namespace

TEST(VolumeFile, RawComesBackBitForBit) {
    const TemporaryFolder folder;
    for (const int channels : {1, 3, 5}) {
        VolumeWriteOptions options;
        options.recipe = R"({"texloom": 1, "seed": 18446744073709551615})";
        options.repeats = channels == 3;
        TestContext context;
        const DenseSource source(sampleVolume({9, 9, 9}, channels), DenseSource::Edge::Repeats);
        const Box box{-4, 7, -100, {6, 5, 40}};
        writeVolume(folder / "v.json", source, box, options, context);
        const LoadedVolume loaded = read(folder / "v.json");
        EXPECT_TRUE(sameVoxels(loaded.source->volume(), source.sample(box, context))) << channels;
        EXPECT_EQ(loaded.source->bounds(), channels == 3 ? std::nullopt : std::optional(box));
        EXPECT_EQ(Json::parse(loaded.recipe), Json::parse(options.recipe));
        EXPECT_TRUE(sameVoxels(loaded.source->sample(box, context), loaded.source->volume()));
        EXPECT_EQ(folder.entries(), 2);
    }
}

TEST(VolumeFile, RawIsWhatItSays) {
    const TemporaryFolder folder;
    VolumeWriteOptions options;
    options.space = "linear";
    write(folder / "v.json", 3, options);
    const Json head = Json::parse(get(folder / "v.json"));
    EXPECT_EQ(head["data"], "v.raw");
    EXPECT_EQ(head["size"], Json({6, 5, 4}));
    EXPECT_EQ(head["hash"], fileHash(folder / "v.raw"));
    const std::string bytes = get(folder / "v.raw");
    ASSERT_EQ(bytes.size(), 6U * 5 * 4 * 3 * 4);
    const auto valueAt = [&](std::size_t x, std::size_t y, std::size_t z, std::size_t c) {
        float value = 0;
        std::memcpy(&value, bytes.data() + (((z * 5 + y) * 6 + x) * 3 + c) * sizeof(float), sizeof(float));
        return value;
    };
    const Volume volume = sampleVolume(kVolume, 3);
    const float encoded = volume(4, 3, 2, 1);
    EXPECT_NEAR(valueAt(4, 3, 2, 1), std::pow((encoded + 0.055F) / 1.055F, 2.4F), 1e-4); // sRGB's curve
}

TEST(VolumeFile, SlicesComeBackInEveryFormat) {
    for (const auto& [extension, depth, step] :
         {std::tuple("png", Depth::Bits8, 1.0 / 255), std::tuple("png", Depth::Bits16, 1.0 / 65535),
          std::tuple("tif", Depth::Float, 0.0), std::tuple("exr", Depth::Float, 0.0),
          std::tuple("exr", Depth::Half, 1.0 / 1024)}) {
        const TemporaryFolder folder;
        VolumeWriteOptions options;
        options.depth = depth;
        options.space = depth == Depth::Float || depth == Depth::Half ? "linear" : "srgb";
        options.recipe = "{\"texloom\": 1}";
        const fs::path path = folder / (std::string("wood.") + extension);
        write(path, 3, options);
        EXPECT_EQ(folder.entries(), kVolume.depth);
        for (const fs::path& file : volumeFiles(path, kVolume.depth)) {
            EXPECT_EQ(readImageInfo(file).recipe, options.recipe);
            const LoadedVolume loaded = read(file);
            ASSERT_EQ(loaded.source->volume().size(), kVolume);
            const Volume expected = sampleVolume(kVolume, 3);
            for (int z = 0; z < kVolume.depth; ++z)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(loaded.source->volume()(2, 3, z, c), expected(2, 3, z, c), step / 2 + 1e-6);
            EXPECT_EQ(loaded.recipe, options.recipe);
        }
    }
}

TEST(VolumeFile, SlicesOfAPeriodSaySo) {
    const TemporaryFolder folder;
    VolumeWriteOptions options;
    options.repeats = true;
    write(folder / "v.png", 1, options);
    EXPECT_EQ(read(folder / "v-0002.png").source->period(), kVolume);
    EXPECT_FALSE(read(folder / "v-0002.png").source->bounds());
}

TEST(VolumeFile, NamesOfManySlicesStayInOrder) {
    const std::vector<fs::path> files = volumeFiles("/a/b.c.tif", 10001);
    EXPECT_EQ(files.front(), "/a/b.c-00000.tif");
    EXPECT_EQ(files.back(), "/a/b.c-10000.tif");
    EXPECT_EQ(volumeFiles("v.png", 1), std::vector<fs::path>{"v-0000.png"});
    EXPECT_EQ(volumeFiles("v.JSON", 9), (std::vector<fs::path>{"v.JSON", "v.raw"}));
}

TEST(VolumeFile, SlicesOfOtherProgramsAreTakenByTheirNumbers) {
    const TemporaryFolder folder;
    const Volume volume = sampleVolume(kVolume, 1);
    WriteOptions options;
    options.depth = Depth::Float;
    for (int z = 0; z < kVolume.depth; ++z)
        writeImage(folder / ("scan" + std::to_string(z + 8) + ".tif"), volume.slice(z), options);
    writeImage(folder / "scan_other7.tif", volume.slice(0), options);
    TestContext context;
    EXPECT_TRUE(sameVoxels(readVolume(folder / "scan10.tif", context, {"raw"}).source->volume(), volume));
}

TEST(VolumeFile, IncompleteSeriesAreRefusedByName) {
    const TemporaryFolder folder;
    write(folder / "v.png", 3);
    fs::remove(folder / "v-0002.png");
    EXPECT_THAT([&] { read(folder / "v-0000.png"); }, refusal("v-0002.png is missing", "from 0 to 3"));
    fs::copy_file(folder / "v-0000.png", folder / "v-2.png");
    fs::copy_file(folder / "v-0000.png", folder / "v-02.png");
    EXPECT_THAT([&] { read(folder / "v-0000.png"); }, refusal("v-2.png", "v-02.png", "same number"));
    EXPECT_THAT([&] { read(folder / "w-0000.png"); }, refusal("There is no file", "w-0000.png"));
    EXPECT_THAT([&] { read(folder / "w.png"); }, refusal("w.png", "number"));
}

TEST(VolumeFile, SlicesOfOtherSizesAreRefusedByName) {
    const TemporaryFolder folder;
    write(folder / "v.png", 3);
    writeImage(folder / "v-0003.png", Image({6, 4}, 3), {});
    EXPECT_THAT([&] { read(folder / "v-0000.png"); }, refusal("v-0003.png is 6 × 4", "v-0000.png is 6 × 5"));
    writeImage(folder / "v-0003.png", Image({6, 5}, 1), {});
    EXPECT_THAT([&] { read(folder / "v-0000.png"); }, refusal("v-0003.png", "1 channel;", "with 3"));
    writeImage(folder / "v-0003.png", Image({60, 50}, 3), {});
    EXPECT_THAT([&] { read(folder / "v-0000.png"); }, refusal("v-0003.png", "60 × 50"));
}

TEST(VolumeFile, TooManyVoxelsAreRefusedWithTheLimit) {
    const TemporaryFolder folder;
    write(folder / "v.png", 3);
    write(folder / "v.json", 3);
    for (const char* name : {"v-0000.png", "v.json"})
        EXPECT_THAT([&] { read(folder / name, 119); }, refusal(name, "6 × 5 × 4", "119")) << name;
    EXPECT_NO_THROW(read(folder / "v.json", 120));
}

TEST(VolumeFile, HeadsThatLieAreRefused) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& key, const Json& value) {
        return [&folder, key, value] { read(changed(folder, key, value)); };
    };
    EXPECT_THAT(refused("size", {6, 5, 5}), refusal("v.raw has 960 bytes", "take 1,200"));
    // Products that overflow 64 bits, or fit only after it.
    EXPECT_THAT(refused("size", {2147483647, 2147483647, 2147483647}),
                refusal("2147483647", "can be opened"));
    EXPECT_THAT(refused("size", {65536, 65536, 65536}), refusal("65536 × 65536 × 65536"));
    EXPECT_THAT(refused("size", {6, -5, 4}), refusal("size[1]", "-5"));
    EXPECT_THAT(refused("size", {6, 5}), refusal("size"));
    EXPECT_THAT(refused("size", {6, 5, 1e300}), refusal("size[2]"));
    EXPECT_THAT(refused("channels", 65), refusal("65 channels", "up to 64"));
    EXPECT_THAT(refused("channels", 2147483647), refusal("2147483647"));
    EXPECT_THAT(refused("place", {0, 0, 1e18}), refusal("place[2]"));
    EXPECT_THAT(refused("place", {0, 0.5, 0}), refusal("place[1]", "0.5"));
    EXPECT_THAT(refused("texloom-volume", 2), refusal("format 2", "up to 1"));
    EXPECT_THAT(refused("texloom-volume", Json(Json::value_t::discarded)), refusal("does not describe"));
    EXPECT_THAT(refused("type", "float64"), refusal("float64", "float32"));
    EXPECT_THAT(refused("bytes", "big-endian"), refusal("little-endian"));
    EXPECT_THAT(refused("order", "z, y, x"), refusal("channel, x, y, z"));
    EXPECT_THAT(refused("space", "mauve"), refusal("mauve"));
    EXPECT_THAT(refused("repeats", "no"), refusal("true or false"));
    EXPECT_THAT(refused("data", "gone.raw"), refusal("gone.raw"));
    for (const char* outside : {"../v.raw", "/etc/passwd", "..", ""})
        EXPECT_THAT(refused("data", outside), refusal("same folder")) << outside;
}

TEST(VolumeFile, OtherNumbersThanThoseWrittenAreRefused) {
    const TemporaryFolder folder;
    write(folder / "v.json", 2);
    std::string bytes = get(folder / "v.raw");
    bytes[100] = static_cast<char>(~bytes[100]);
    std::ofstream(folder / "v.raw", std::ios::binary) << bytes;
    EXPECT_THAT([&] { read(folder / "v.json"); }, refusal("v.raw", "SHA-1"));
    changed(folder, "hash", Json(Json::value_t::discarded));
    std::memcpy(bytes.data() + 960 - 4, "\0\0\xc0\x7f", 4);
    std::ofstream(folder / "v.raw", std::ios::binary) << bytes;
    EXPECT_THAT([&] { read(folder / "v.json"); }, refusal("v.raw", "z = 3", "finite"));
}

TEST(VolumeFile, WhatCannotBeWrittenLeavesWhatWasThere) {
    const TemporaryFolder folder;
    write(folder / "v.json", 2);
    write(folder / "v.png", 3);
    const std::string json = get(folder / "v.json"), first = get(folder / "v-0000.png");
    const int entries = folder.entries();
    JobMonitor monitor;
    int left = 3;
    JobContext context(
        {1, 1, false}, [&left] { return --left < 0; }, monitor);
    EXPECT_THROW(writeVolume(folder / "v.json", sample(3), {0, 0, 0, kVolume}, {}, context), Cancelled);
    left = 8;
    EXPECT_THROW(writeVolume(folder / "v.png", sample(1), {0, 0, 0, kVolume}, {}, context), Cancelled);
    EXPECT_EQ(get(folder / "v.json"), json);
    EXPECT_EQ(get(folder / "v-0000.png"), first);
    EXPECT_EQ(folder.entries(), entries);
    EXPECT_NO_THROW(read(folder / "v.json"));
}

TEST(VolumeFile, AShorterVolumeDoesNotMixWithALongerOne) {
    const TemporaryFolder folder;
    write(folder / "v.png", 3);
    TestContext context;
    EXPECT_THAT(
        [&] {
            writeVolume(folder / "v.png", sample(3), {0, 0, 0, {6, 5, 2}}, {}, context);
        },
        refusal("v-000", "2 slices"));
    EXPECT_EQ(folder.entries(), kVolume.depth);
}

TEST(VolumeFile, WhatAFormatCannotHoldIsRefusedBeforeTheWork) {
    const TemporaryFolder folder;
    EXPECT_THAT([&] { write(folder / "v.png", 5); }, usageRefusal("5 channels"));
    EXPECT_THAT([&] { write(folder / "v.bmp", 3); }, usageRefusal(".bmp"));
    EXPECT_THAT([&] { write(folder / "no" / "v.png", 3); }, refusal("no folder"));
    EXPECT_THAT([&] { write(folder / "no" / "v.json", 3); }, refusal("no folder"));
    EXPECT_EQ(folder.entries(), 0);
}

} // namespace texloom::test

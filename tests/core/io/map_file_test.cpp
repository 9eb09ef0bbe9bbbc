#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/job/random.h"
#include "tests/core/io/write_as.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <cmath>

namespace texloom::test {

namespace {

/// Every kind of source: each exemplar, their corners, and none.
PositionMap sampleMap(Size size, const std::vector<Size>& exemplars) {
    const Random random(5);
    PositionMap map(size, exemplars);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (random.below(10, x, y, 4) == 0)
                continue;
            const std::uint32_t which = random.below(static_cast<std::uint32_t>(exemplars.size()), x, y, 0);
            const auto width = static_cast<std::uint32_t>(exemplars[which].width);
            const auto height = static_cast<std::uint32_t>(exemplars[which].height);
            map.at(x, y) = {static_cast<std::uint16_t>(random.below(width, x, y, 1)),
                            static_cast<std::uint16_t>(random.below(height, x, y, 2)),
                            static_cast<std::uint16_t>(which)};
        }
    for (std::size_t i = 0; i < exemplars.size(); ++i) {
        const auto number = static_cast<std::uint16_t>(i);
        map.at(static_cast<int>(2 * i), 0) = {0, 0, number};
        map.at(static_cast<int>(2 * i) + 1, 0) = {static_cast<std::uint16_t>(exemplars[i].width - 1),
                                                  static_cast<std::uint16_t>(exemplars[i].height - 1),
                                                  number};
    }
    return map;
}

/// A 1 × 1 STMap of another program.
void writeStMap(const std::filesystem::path& path, std::initializer_list<float> samples,
                Depth depth = Depth::Float) {
    Image image({1, 1}, static_cast<int>(samples.size()));
    int channel = 0;
    for (const float sample : samples)
        image(0, 0, channel++) = sample;
    writeImage(path, image, as(depth, "raw"));
}

} // namespace

class MapFiles : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(MapFile, MapFiles, ::testing::Values("map.exr", "map.png"),
                         [](const auto& test) { return std::string(test.param + 4); });

TEST_P(MapFiles, GiveEverySourceBack) {
    const TemporaryFolder folder;
    const PositionMap map = sampleMap({50, 41}, {{37, 23}, {64, 64}, {1, 1}});
    writePositionMap(folder / GetParam(), map);
    EXPECT_EQ(readPositionMap(folder / GetParam()), map);
}

TEST_P(MapFiles, AddressLargeExemplarsExactly) {
    const TemporaryFolder folder;
    const PositionMap map = sampleMap({300, 200}, {{2049, 4097}, {65534, 65534}, {65521, 3}});
    writePositionMap(folder / GetParam(), map);
    EXPECT_EQ(readPositionMap(folder / GetParam()), map);
}

TEST_P(MapFiles, AddressEveryColumnOfTheLargestExemplar) {
    const TemporaryFolder folder;
    constexpr int kSide = 65534;
    PositionMap map({kSide, 1}, {{kSide, kSide}});
    for (int x = 0; x < kSide; ++x)
        map.at(x, 0) = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(x), 0};
    writePositionMap(folder / GetParam(), map);
    EXPECT_EQ(readPositionMap(folder / GetParam()), map);
}

TEST_P(MapFiles, KeepAMapWithoutAnySource) {
    const TemporaryFolder folder;
    const PositionMap map({7, 5}, {{9, 9}});
    writePositionMap(folder / GetParam(), map);
    EXPECT_EQ(readPositionMap(folder / GetParam()), map);
}

TEST_P(MapFiles, TellTheExemplarsSizesRatherThanBelieveTheCaller) {
    const TemporaryFolder folder;
    const PositionMap map = sampleMap({50, 41}, {{37, 23}});
    writePositionMap(folder / GetParam(), map);
    EXPECT_EQ(readPositionMap(folder / GetParam(), {{99, 99}}).exemplarSizes(),
              (std::vector<Size>{{37, 23}}));
}

TEST_P(MapFiles, EmbedTheRecipe) {
    const TemporaryFolder folder;
    writePositionMap(folder / GetParam(), PositionMap::identity({4, 4}), "{\"texloom\": 1}");
    EXPECT_EQ(readImageInfo(folder / GetParam()).recipe, "{\"texloom\": 1}");
}

TEST_P(MapFiles, AreData) {
    const TemporaryFolder folder;
    writePositionMap(folder / GetParam(), PositionMap::identity({4, 4}));
    EXPECT_EQ(readImageInfo(folder / GetParam()).space, "raw");
}

TEST(StMap, HoldsTheDocumentedFormula) {
    const TemporaryFolder folder;
    PositionMap map({2, 1}, {{8, 8}, {200, 50}});
    map.at(0, 0) = {37, 11, 1};
    writePositionMap(folder / "map.exr", map);
    const LoadedImage raw = readImage(folder / "map.exr");
    EXPECT_EQ(raw.info.depth, "float");
    EXPECT_EQ(raw.image.channels(), 4);
    EXPECT_FLOAT_EQ(raw.image(0, 0, 0), 37.5F / 200);
    EXPECT_FLOAT_EQ(raw.image(0, 0, 1), 1 - 11.5F / 50);
    EXPECT_EQ(raw.image(0, 0, 2), 1);
    EXPECT_EQ(raw.image(0, 0, 3), 1);
    EXPECT_EQ(raw.image(1, 0, 3), 0);
}

TEST(ExactMap, HoldsTheDocumentedNumbers) {
    const TemporaryFolder folder;
    PositionMap map({2, 1}, {{8, 8}, {200, 50}});
    map.at(0, 0) = {137, 11, 1};
    writePositionMap(folder / "map.png", map);
    const LoadedImage raw = readImage(folder / "map.png");
    const auto number = [&](int x, int c) {
        return std::lround(static_cast<double>(raw.image(x, 0, c)) * 65535);
    };
    EXPECT_EQ(raw.info.depth, "16-bit");
    EXPECT_EQ(raw.image.channels(), 3);
    EXPECT_EQ(number(0, 0), 137);
    EXPECT_EQ(number(0, 1), 11);
    EXPECT_EQ(number(0, 2), 1);
    EXPECT_EQ(number(1, 2), 65535);
}

TEST(StMap, OfAnotherProgramTakesTheSizeFromTheCaller) {
    const TemporaryFolder folder;
    writeStMap(folder / "map.exr", {2.5F / 10, 1 - 3.5F / 20});
    const PositionMap map = readPositionMap(folder / "map.exr", {{10, 20}});
    EXPECT_EQ(map.at(0, 0), (Source{2, 3, 0}));
}

TEST(StMap, OfAnotherProgramMayHaveThreeChannels) {
    const TemporaryFolder folder;
    writeStMap(folder / "map.exr", {2.5F / 10, 1 - 3.5F / 20, 1});
    const PositionMap map = readPositionMap(folder / "map.exr", {{7, 7}, {10, 20}});
    EXPECT_EQ(map.at(0, 0), (Source{2, 3, 1}));
}

TEST(StMap, WithoutSizesAsksForTheExemplar) {
    const TemporaryFolder folder;
    writeStMap(folder / "map.exr", {0.25F, 0.25F});
    EXPECT_THAT([&] { readPositionMap(folder / "map.exr"); }, refusal("map.exr", "size of its exemplar"));
}

TEST(StMap, OfHalfFloatsIsRefused) {
    const TemporaryFolder folder;
    writeStMap(folder / "map.exr", {0.25F, 0.25F, 0, 1}, Depth::Half);
    EXPECT_THAT(
        [&] {
            readPositionMap(folder / "map.exr", {{10, 10}});
        },
        refusal("map.exr", "32-bit float", "half"));
}

TEST(StMap, OutsideTheExemplarIsRefusedWithPixelAndLimit) {
    const TemporaryFolder folder;
    for (const float value : {-0.05F, 1.05F, 1e30F}) {
        writeStMap(folder / "map.exr", {value, 0.25F});
        EXPECT_THAT(
            [&] {
                readPositionMap(folder / "map.exr", {{10, 10}});
            },
            refusal("(0, 0)", "outside", "0 to 9"))
            << value;
    }
}

TEST(StMap, BetweenTwoPixelsIsRefused) {
    const TemporaryFolder folder;
    writeStMap(folder / "map.exr", {0.3F, 0.25F});
    EXPECT_THAT(
        [&] {
            readPositionMap(folder / "map.exr", {{10, 10}});
        },
        refusal("(0, 0)", "2.50", "between two pixels"));
}

TEST(StMap, WithAnExemplarThatIsNotThereIsRefused) {
    const TemporaryFolder folder;
    for (const float exemplar : {1.0F, -1.0F, 3e9F}) {
        writeStMap(folder / "map.exr", {0.25F, 0.25F, exemplar});
        EXPECT_THAT(
            [&] {
                readPositionMap(folder / "map.exr", {{10, 10}});
            },
            refusal("(0, 0)", "outside"))
            << exemplar;
    }
}

TEST(ExactMap, OutsideTheExemplarIsRefused) {
    const TemporaryFolder folder;
    Image image({1, 1}, 3);
    image(0, 0, 0) = 10.0F / 65535;
    writeImage(folder / "map.png", image, as(Depth::Bits16, "raw"));
    EXPECT_THAT([&] { readPositionMap(folder / "map.png", {{10, 10}}); }, refusal("(0, 0)", "10", "0 to 9"));
}

TEST(ExactMap, OfEightBitsIsRefused) {
    const TemporaryFolder folder;
    writeImage(folder / "map.png", Image({4, 4}, 3), as(Depth::Bits8, "raw"));
    EXPECT_THAT(
        [&] {
            readPositionMap(folder / "map.png", {{10, 10}});
        },
        refusal("map.png", "16 bits", "8-bit"));
}

TEST(MapFile, WithDamagedSizesIsRefused) {
    const TemporaryFolder folder;
    for (const char* sizes : {"0x5", "-3x4", "70000x10", "99999999999x1"}) {
        WriteOptions options = as(Depth::Float, "raw");
        options.attributes = {{"texloom:exemplars", sizes}};
        writeImage(folder / "map.exr", Image({2, 2}, 4), options);
        EXPECT_THAT([&] { readPositionMap(folder / "map.exr"); }, refusal("map.exr")) << sizes;
    }
}

TEST(MapFile, HasNoOtherFormat) {
    const TemporaryFolder folder;
    EXPECT_THAT(
        [&] {
            writePositionMap(folder / "map.tif", PositionMap::identity({4, 4}));
        },
        usageRefusal("map.tif", ".exr", ".png"));
    EXPECT_EQ(folder.entries(), 0);
}

} // namespace texloom::test

#include "core/base/error.h"
#include "core/io/image_file.h"
#include "tests/core/io/foreign_files.h"
#include "tests/core/io/write_as.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <ostream>
#include <string_view>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

/// One way of storing an image.
struct Way {
    const char* name;
    Depth depth;
    int channels;

    friend void PrintTo(const Way& way, std::ostream* out) {
        *out << way.name << ' ' << depthName(way.depth) << ' ' << way.channels;
    }
};

std::string nameOf(const ::testing::TestParamInfo<Way>& info) {
    std::string name = fs::path(info.param.name).extension().string().substr(1) + "_" +
                       std::string(depthName(info.param.depth)) + "_" + std::to_string(info.param.channels);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

/// Noise that the depth holds exactly.
Image holdable(Size size, int channels, Depth depth) {
    Image image = noise(size, channels);
    const float steps = depth == Depth::Bits8 ? 255.0F : depth == Depth::Bits16 ? 65535.0F : 2048.0F;
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                image(x, y, c) = std::round(image(x, y, c) * steps) / steps;
                if (depth == Depth::Half || depth == Depth::Float)
                    image(x, y, c) = image(x, y, c) * 8 - 2;
            }
    return image;
}

/// Whether two images become the same file: integers come back as multiples of 1/255 to the last bit but one.
bool sameSteps(const ImageView& a, const ImageView& b, Depth depth) {
    if (depth == Depth::Half || depth == Depth::Float)
        return samePixels(a, b);
    const float steps = depth == Depth::Bits8 ? 255.0F : 65535.0F;
    bool same = a.size() == b.size() && a.channels == b.channels;
    for (int c = 0; same && c < a.channels; ++c)
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x)
                same = same && std::abs(a(x, y, c) - b(x, y, c)) * steps < 0.01F;
    return same;
}

double largestDifference(const ImageView& a, const ImageView& b) {
    double largest = 0;
    for (int c = 0; c < a.channels; ++c)
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x)
                largest = std::max(largest, std::abs(static_cast<double>(a(x, y, c) - b(x, y, c))));
    return largest;
}

/// Colours that change slowly, as JPEG and HDR like them.
Image positionRamp(Size size, int channels) {
    Image image(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                image(x, y, c) =
                    static_cast<float>(x + y + c) / static_cast<float>(size.width + size.height + 2);
    return image;
}

/// An L that no turn or mirror leaves as it is, in blocks that JPEG keeps well apart.
Image letterL() {
    Image image({48, 32}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 48; ++x)
                image(x, y, c) = x < 16 || (y >= 24 && x < 32) ? 1.0F : 0.0F;
    return image;
}

/// What a file of `stored` pixels shows under an EXIF orientation.
Image oriented(const Image& stored, int orientation) {
    const int w = stored.width(), h = stored.height();
    Image shown(orientation >= 5 ? Size{h, w} : Size{w, h}, stored.channels());
    for (int c = 0; c < stored.channels(); ++c)
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const std::array<Size, 8> places = {{{x, y},
                                                     {w - 1 - x, y},
                                                     {w - 1 - x, h - 1 - y},
                                                     {x, h - 1 - y},
                                                     {y, x},
                                                     {h - 1 - y, x},
                                                     {h - 1 - y, w - 1 - x},
                                                     {y, w - 1 - x}}};
                const Size place = places[static_cast<std::size_t>(orientation - 1)];
                shown(place.width, place.height, c) = stored(x, y, c);
            }
    return shown;
}

} // namespace

class ExactWays : public ::testing::TestWithParam<Way> {};

INSTANTIATE_TEST_SUITE_P(ImageFile, ExactWays,
                         ::testing::Values(Way{"a.png", Depth::Bits8, 1}, Way{"a.png", Depth::Bits8, 2},
                                           Way{"a.png", Depth::Bits8, 3}, Way{"a.png", Depth::Bits8, 4},
                                           Way{"a.png", Depth::Bits16, 1}, Way{"a.png", Depth::Bits16, 3},
                                           Way{"a.png", Depth::Bits16, 4}, Way{"a.tif", Depth::Bits8, 1},
                                           Way{"a.tif", Depth::Bits8, 3}, Way{"a.tif", Depth::Bits8, 4},
                                           Way{"a.tiff", Depth::Bits16, 3}, Way{"a.tif", Depth::Bits16, 4},
                                           Way{"a.tif", Depth::Float, 1}, Way{"a.tif", Depth::Float, 3},
                                           Way{"a.tif", Depth::Float, 4}, Way{"a.tif", Depth::Float, 7},
                                           Way{"a.exr", Depth::Half, 1}, Way{"a.exr", Depth::Half, 3},
                                           Way{"a.exr", Depth::Half, 4}, Way{"a.exr", Depth::Float, 3},
                                           Way{"a.exr", Depth::Float, 4}, Way{"a.exr", Depth::Float, 6}),
                         nameOf);

TEST_P(ExactWays, GiveEverySampleBack) {
    const Way way = GetParam();
    const TemporaryFolder folder;
    const Image image = holdable({37, 23}, way.channels, way.depth);
    // An EXR holds colours times alpha, which is exact for data alone.
    const bool exr = std::string_view(way.name).ends_with(".exr");
    writeImage(folder / way.name, image, as(way.depth, exr ? "raw" : "srgb"));
    const LoadedImage back = readImage(folder / way.name);
    EXPECT_EQ(back.image.size(), image.size());
    EXPECT_EQ(back.image.channels(), way.channels);
    EXPECT_TRUE(sameSteps(back.image, image, way.depth));
}

TEST_P(ExactWays, SayWhatIsInThem) {
    const Way way = GetParam();
    const TemporaryFolder folder;
    writeImage(folder / way.name, holdable({37, 23}, way.channels, way.depth), as(way.depth));
    const ImageFileInfo info = readImageInfo(folder / way.name);
    EXPECT_EQ(info.size, (Size{37, 23}));
    EXPECT_EQ(info.channels, way.channels);
    EXPECT_EQ(info.depth, depthName(way.depth));
}

TEST_P(ExactWays, LeaveNoTemporaryFile) {
    const Way way = GetParam();
    const TemporaryFolder folder;
    writeImage(folder / way.name, holdable({37, 23}, way.channels, way.depth), as(way.depth));
    EXPECT_EQ(folder.entries(), 1);
}

TEST(ImageFile, JpegKeepsSizeAndNearValues) {
    const TemporaryFolder folder;
    for (const int channels : {1, 3}) {
        const Image image = positionRamp({61, 47}, channels);
        writeImage(folder / "a.jpg", image, {});
        const LoadedImage back = readImage(folder / "a.jpg");
        ASSERT_EQ(back.image.size(), image.size());
        ASSERT_EQ(back.image.channels(), channels);
        EXPECT_LT(largestDifference(back.image, image), 0.03);
    }
}

TEST(ImageFile, HdrKeepsValuesToItsPrecision) {
    const TemporaryFolder folder;
    Image image = positionRamp({61, 47}, 3);
    for (int x = 0; x < 61; ++x)
        image(x, 0, 0) = image(x, 0, 1) = image(x, 0, 2) = static_cast<float>(x) * 100;
    writeImage(folder / "a.hdr", image, as(Depth::Float, "linear"));
    const LoadedImage back = readImage(folder / "a.hdr");
    EXPECT_EQ(back.info.format, "hdr");
    for (int y = 0; y < 47; ++y)
        for (int x = 0; x < 61; ++x) {
            const float brightest = std::max({image(x, y, 0), image(x, y, 1), image(x, y, 2)});
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(back.image(x, y, c), image(x, y, c), brightest / 100);
        }
}

TEST(ImageFile, ColoursUnderAlphaAreNotPremultiplied) {
    const TemporaryFolder folder;
    Image image = constant({8, 8}, 4, 1);
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y)
            image(x, y, 3) = static_cast<float>(x) / 255.0F;
    for (const char* name : {"a.png", "a.tif"}) {
        writeImage(folder / name, image, {});
        EXPECT_TRUE(sameSteps(readImage(folder / name).image, image, Depth::Bits8)) << name;
    }
}

TEST(ImageFile, ReadsAPaletteAsColours) {
    const TemporaryFolder folder;
    writePalettePng(folder / "a.png");
    const LoadedImage back = readImage(folder / "a.png");
    Image expected({3, 2}, 3);
    for (int x = 0; x < 3; ++x) {
        expected(x, 0, x) = 1;
        expected(x, 1, 2 - x) = 1;
    }
    EXPECT_TRUE(samePixels(back.image, expected));
}

TEST(ImageFile, ReadsAPaletteOfFewBitsThatIsNotCompressed) {
    const TemporaryFolder folder;
    writePaletteTiff(folder / "a.tif");
    const LoadedImage back = readImage(folder / "a.tif");
    Image expected({64, 48}, 3);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            expected(x, y, x < 32 ? 0 : 2) = 1;
    EXPECT_TRUE(samePixels(back.image, expected));
}

TEST(ImageFile, GoesByTheFirstBytesNotTheName) {
    const TemporaryFolder folder;
    const Image image = holdable({9, 7}, 3, Depth::Bits8);
    writeImage(folder / "a.png", image, {});
    fs::rename(folder / "a.png", folder / "a.jpg");
    EXPECT_EQ(readImageInfo(folder / "a.jpg").format, "png");
    EXPECT_TRUE(sameSteps(readImage(folder / "a.jpg").image, image, Depth::Bits8));
}

class Orientations : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(ImageFile, Orientations, ::testing::Range(1, 9));

TEST_P(Orientations, AreAppliedToJpeg) {
    const TemporaryFolder folder;
    ForeignFile file;
    file.orientation = GetParam();
    writeForeign(folder / "a.jpg", letterL(), file);
    const Image expected = oriented(letterL(), GetParam());
    const LoadedImage back = readImage(folder / "a.jpg");
    ASSERT_EQ(back.image.size(), expected.size());
    EXPECT_EQ(back.info.size, expected.size());
    EXPECT_LT(largestDifference(back.image, expected), 0.1);
}

TEST_P(Orientations, AreAppliedToTiff) {
    const TemporaryFolder folder;
    ForeignFile file;
    file.orientation = GetParam();
    writeForeign(folder / "a.tif", letterL(), file);
    EXPECT_TRUE(samePixels(readImage(folder / "a.tif").image, oriented(letterL(), GetParam())));
}

TEST(ImageFile, NamesTheIccProfile) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.jpg", "a.tif"}) {
        writeForeign(folder / name, letterL(), {.iccProfile = "Display P3 of a test"});
        EXPECT_EQ(readImageInfo(folder / name).iccProfile, "Display P3 of a test") << name;
    }
}

TEST(ImageFile, ReadsTilesAndDataWindowsAwayFromTheOrigin) {
    const TemporaryFolder folder;
    const Image image = noise({37, 23}, 3);
    writeForeign(folder / "a.exr", image, {.x = -5, .y = 11, .tiled = true});
    EXPECT_TRUE(samePixels(readImage(folder / "a.exr").image, image));
}

TEST(ImageFile, TakesIntegersForSrgbAndFloatsForLinear) {
    const TemporaryFolder folder;
    for (const auto& [name, space] :
         {std::pair{"a.png", "srgb"}, {"a.jpg", "srgb"}, {"a.tif", "srgb"}, {"a.exr", "linear"}}) {
        writeForeign(folder / name, letterL());
        EXPECT_EQ(readImageInfo(folder / name).space, space) << name;
    }
}

TEST(ImageFile, RemembersTheSpaceItWasWrittenIn) {
    const TemporaryFolder folder;
    for (const char* space : {"srgb", "linear", "acescg", "raw"})
        for (const char* name : {"a.png", "a.exr"}) {
            writeImage(folder / name, letterL(), as(depthsFor(name).front(), space));
            EXPECT_EQ(readImageInfo(folder / name).space, space) << name;
        }
}

TEST(ImageFile, RemembersItsRecipe) {
    const TemporaryFolder folder;
    const std::string recipe = "{\"texloom\": 1, \"note\": \"ε ≤ 0.1 \\\"quoted\\\"\"}\n\tsecond line";
    for (const char* name : {"a.png", "a.tif", "a.exr"}) {
        writeImage(folder / name, letterL(), as(depthsFor(name).front(), "srgb", recipe));
        EXPECT_EQ(readImageInfo(folder / name).recipe, recipe) << name;
    }
}

TEST(ImageFile, RemembersALongRecipe) {
    const TemporaryFolder folder;
    const std::string recipe = "{\"texloom\": 1, \"note\": \"" + std::string(300000, 'x') + "\"}";
    writeImage(folder / "a.tif", letterL(), as(depthsFor("a.tif").front(), "srgb", recipe));
    EXPECT_EQ(readImageInfo(folder / "a.tif").recipe, "") << "a TIFF would cut it off";
    for (const char* name : {"a.png", "a.exr"}) {
        writeImage(folder / name, letterL(), as(depthsFor(name).front(), "srgb", recipe));
        const std::string back = readImageInfo(folder / name).recipe;
        EXPECT_EQ(back.size(), recipe.size()) << name;
        EXPECT_TRUE(back == recipe) << name;
    }
}

TEST(ImageFile, WritesRowsInOrderWithoutTheWholeImage) {
    const TemporaryFolder folder;
    const Image image = holdable({37, 23}, 3, Depth::Bits8);
    int next = 0;
    writeImage(folder / "a.png", image.size(), 3,
               [&](int y, float* row) {
                   EXPECT_EQ(y, next++);
                   for (int x = 0; x < 37; ++x)
                       for (int c = 0; c < 3; ++c)
                           *row++ = image(x, y, c);
               },
               {});
    EXPECT_EQ(next, 23);
    EXPECT_TRUE(sameSteps(readImage(folder / "a.png").image, image, Depth::Bits8));
}

TEST(FileHash, IsTheSha1OfTheBytes) {
    const TemporaryFolder folder;
    writeText(folder / "a.txt", "abc");
    std::string hash = fileHash(folder / "a.txt");
    for (char& digit : hash)
        digit = static_cast<char>(std::tolower(digit));
    EXPECT_EQ(hash, "a9993e364706816aba3e25717850c26c9cd0d89d");
}

TEST(WriteText, ComesBack) {
    const TemporaryFolder folder;
    const std::string text("zero \0 inside\n", 14);
    writeText(folder / "a.txt", text);
    EXPECT_EQ(readText(folder / "a.txt"), text);
    EXPECT_EQ(folder.entries(), 1);
}

TEST(ReadText, RefusesWhatIsTooLong) {
    const TemporaryFolder folder;
    writeText(folder / "a.txt", std::string(200000, 'x'));
    EXPECT_THAT([&] { readText(folder / "a.txt", 100000); },
                ::testing::ThrowsMessage<Error>(::testing::HasSubstr("a.txt")));
}

} // namespace texloom::test

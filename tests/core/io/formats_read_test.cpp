// Holds the table of docs/formats.md that says what is read: every claim in it has a check here, on a file
// that another program's library wrote.

#include "core/base/error.h"
#include "core/color/color_pipeline.h"
#include "core/io/image_file.h"
#include "tests/core/color/srgb.h"
#include "tests/core/io/foreign_files.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace texloom::test::formats_read {

namespace {

namespace fs = std::filesystem;
using Check = std::function<void(const fs::path&)>;

Image even(const std::vector<float>& color, Size size = {6, 5}) {
    Image image(size, static_cast<int>(color.size()));
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                image(x, y, c) = color[static_cast<std::size_t>(c)];
    return image;
}

void expectColor(const Image& image, const std::vector<float>& color, float tolerance) {
    ASSERT_EQ(image.channels(), static_cast<int>(color.size()));
    for (int c = 0; c < image.channels(); ++c)
        EXPECT_NEAR(image(1, 1, c), color[static_cast<std::size_t>(c)], tolerance) << "channel " << c;
}

/// Steps of so many bits, as far as a byte goes around.
void expectSteps(const Image& image, int bits) {
    const int most = (1 << bits) - 1;
    for (int x = 0; x < image.width(); ++x)
        EXPECT_NEAR(image(x, 0, 0), static_cast<float>(x % (most + 1)) / static_cast<float>(most), 3e-5F)
            << bits << " bits at " << x;
}

Image steps(int bits) {
    const int most = (1 << bits) - 1;
    Image image({16, 2}, 1);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 16; ++x)
            image(x, y, 0) = static_cast<float>(x % (most + 1)) / static_cast<float>(most);
    return image;
}

void bitsOfPng(const fs::path& path) {
    for (const auto& [bits, bytes] : std::vector<std::pair<int, std::vector<std::uint8_t>>>{
             {1, {0x55, 0x55}}, {2, {0x1b, 0x1b}}, {4, {0x01, 0x23, 0x45, 0x67, 0x89, 0xab, 0xcd, 0xef}}}) {
        writeGreyPng(path, bits, bytes);
        expectSteps(readImage(path).image, bits);
    }
    for (const auto& [bits, type] : {std::pair{8, "uint8"}, {16, "uint16"}}) {
        writeForeign(path, steps(bits), {.type = type});
        expectSteps(readImage(path).image, bits);
    }
}

void bitsOfTiff(const fs::path& path) {
    for (const auto& [bits, type] : {std::pair{2, "uint8"},
                                     {4, "uint8"},
                                     {8, "uint8"},
                                     {10, "uint16"},
                                     {12, "uint16"},
                                     {16, "uint16"}}) {
        writeForeign(path, steps(bits), {.type = type, .bits = bits});
        expectSteps(readImage(path).image, bits);
    }
    writeBilevelTiff(path, {0x55, 0x55});
    expectSteps(readImage(path).image, 1);
}

void wholeNumbers(const fs::path& path) {
    if (path.extension() == ".tif")
        writeWideTiff(path, {3, 1}, {0, 500, 1000});
    else
        writeWideExr(path, {3, 1}, {0, 500, 1000});
    const LoadedImage loaded = readImage(path);
    EXPECT_NEAR(loaded.image(1, 0, 0), 0.5F, 1e-6F);
    EXPECT_EQ(loaded.image(2, 0, 0), 1);
    ASSERT_FALSE(loaded.info.notes.empty());
    EXPECT_THAT(loaded.info.notes.front().text(), ::testing::HasSubstr("32 bits"));
}

Check samples(const std::string& type, float tolerance, float most = 1.5F) {
    return [=](const fs::path& path) {
        writeForeign(path, even({0.1F, 0.7F, most}), {.type = type});
        expectColor(readImage(path).image, {0.1F, 0.7F, most}, tolerance);
    };
}

Check alpha(bool straight, const std::vector<float>& stored, const std::vector<float>& read) {
    return [=](const fs::path& path) {
        writeForeign(path, even(stored), {.straightAlpha = straight});
        expectColor(readImage(path).image, read, 0.004F);
    };
}

void noAlpha(const fs::path& path) {
    writeForeign(path, even({0.2F, 0.4F, 0.6F}));
    EXPECT_EQ(readImage(path).image.channels(), 3);
    EXPECT_FALSE(readImageInfo(path).associatedAlpha);
}

void noLayers(const fs::path& path) {
    writeForeign(path, even({0.2F, 0.4F, 0.6F}));
    EXPECT_TRUE(readImageInfo(path).layers.empty());
    EXPECT_THAT([&] { readImage(path, {.layer = "diffuse"}); },
                usageRefusal("no layer diffuse", "one picture"));
}

void pages(const fs::path& path) {
    const Image first = even({0, 0, 0}), second = even({1, 1, 1}, {8, 4});
    writePages(path, {first, second});
    EXPECT_THAT(readImageInfo(path).layers, ::testing::ElementsAre("1", "2"));
    EXPECT_EQ(readImage(path).image(0, 0, 0), 0);
    EXPECT_EQ(readImage(path, {.layer = "2"}).image.size(), (Size{8, 4}));
    EXPECT_THAT([&] { readImage(path, {.layer = "3"}); }, usageRefusal("no layer 3", "1 and 2"));
}

void layersByName(const fs::path& path) {
    writeForeign(path, even({0.1F, 0.2F, 0.3F, 0.4F}), {.channelNames = {"R", "G", "B", "rough.Y"}});
    EXPECT_THAT(readImageInfo(path).layers, ::testing::ElementsAre("rough"));
    EXPECT_NEAR(readImage(path, {.layer = "rough"}).image(0, 0, 0), 0.4F, 1e-6F);
}

void parts(const fs::path& path) {
    const Image first = even({0.1F}), second = even({0.9F});
    writeParts(path, {first, second}, {"one", "two"});
    EXPECT_THAT(readImageInfo(path).layers, ::testing::ElementsAre("one", "two"));
    EXPECT_NEAR(readImage(path, {.layer = "two"}).image(0, 0, 0), 0.9F, 1e-6F);
}

/// A picture in the working space.
Image working(const fs::path& path) {
    LoadedImage loaded = readImage(path);
    if (loaded.info.space == color::kFileSpace)
        color::toWorking(loaded.image, *loaded.info.color);
    else
        color::toWorking(loaded.image, loaded.info.space);
    return loaded.image;
}

/// A grey of one half under a curve of a power.
Check curve(const std::function<void(const fs::path&, double)>& write) {
    return [=](const fs::path& path) {
        write(path, 1.8);
        EXPECT_NEAR(working(path)(0, 0, 1), encoded(std::pow(128 / 255.0, 1.8)), 4e-3);
    };
}

void writeWithProfile(const fs::path& path, double gamma) {
    writeForeign(path, even({128 / 255.0F, 128 / 255.0F, 128 / 255.0F}),
                 {.profileBytes = matrixProfile(gamma)});
}

std::vector<std::uint8_t> bigEndian(const std::vector<std::uint32_t>& numbers) {
    std::vector<std::uint8_t> bytes;
    for (const std::uint32_t number : numbers)
        for (const int shift : {24, 16, 8, 0})
            bytes.push_back(static_cast<std::uint8_t>(number >> shift));
    return bytes;
}

/// gAMA is one over the power, and the primaries are sRGB's.
void writeWithGamma(const fs::path& path, double gamma) {
    const auto inverse = static_cast<std::uint32_t>(std::lround(100000 / gamma));
    writeTaggedPng(path, {128, 128, 128},
                   {{"gAMA", bigEndian({inverse})},
                    {"cHRM", bigEndian({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000})}});
}

void displayP3(const fs::path& path) {
    writeTaggedPng(path, {255, 0, 0}, {{"cICP", {12, 13, 0, 1}}});
    EXPECT_GT(working(path)(0, 0, 0), 1.05F);
}

void srgb(const fs::path& path) {
    writeTaggedPng(path, {128, 128, 128}, {{"sRGB", {0}}});
    EXPECT_EQ(working(path)(0, 0, 0), 128 / 255.0F);
}

void chromaticities(const fs::path& path) {
    writeForeign(path, even({1, 0, 0}),
                 {.chromaticities = {0.708F, 0.292F, 0.17F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.329F}});
    EXPECT_GT(working(path)(0, 0, 0), 1.1F); // Rec. 2020's red is more than Rec. 709's
}

void linear(const fs::path& path) {
    writeForeign(path, even({0.5F, 0.5F, 0.5F}), {.type = "float"});
    EXPECT_EQ(readImageInfo(path).space, "linear");
    EXPECT_NEAR(working(path)(0, 0, 0), encoded(0.5), 0.01);
}

void turned(const fs::path& path) {
    Image image({24, 16}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                image(x, y, c) = 1;
    writeForeign(path, image, {.orientation = 6}); // a quarter to the right
    const Image shown = readImage(path).image;
    ASSERT_EQ(shown.size(), (Size{16, 24}));
    EXPECT_GT(shown(12, 3, 0), 0.9F);
    EXPECT_LT(shown(3, 3, 0), 0.1F);
}

void turnedPng(const fs::path& path) {
    writeTurnedPng(path);
    const Image shown = readImage(path).image;
    ASSERT_EQ(shown.size(), (Size{1, 3}));
    EXPECT_EQ(shown(0, 0, 0), 1);
    EXPECT_EQ(shown(0, 2, 0), 0);
}

/// Where the first pixel of each order is shown, by Ward's description.
void orderedHdr(const fs::path& path) {
    for (const auto& [order, x, y] : {std::tuple{"-Y 3 +X 2", 0, 0},
                                      {"-Y 3 -X 2", 1, 0},
                                      {"+Y 3 +X 2", 0, 2},
                                      {"+Y 3 -X 2", 1, 2},
                                      {"+X 2 +Y 3", 0, 2},
                                      {"-X 2 +Y 3", 1, 2},
                                      {"-X 2 -Y 3", 1, 0},
                                      {"+X 2 -Y 3", 0, 0}}) {
        writeOrderedHdr(path, order);
        const Image shown = readImage(path).image;
        ASSERT_EQ(shown.size(), (Size{2, 3})) << order;
        EXPECT_GT(shown(x, y, 0), 0.9F) << order;
    }
}

void notTurned(const fs::path& path) {
    writeForeign(path, even({0.1F, 0.2F, 0.3F}, {24, 16}));
    EXPECT_EQ(readImage(path).image.size(), (Size{24, 16}));
}

using Claim = std::pair<std::string, std::string>; ///< row and text
using Claims = std::map<Claim, Check>;

/// By the column's heading: each claim of the table.
std::map<std::string, Claims> claims() {
    const Check icc = curve(writeWithProfile);
    return {{"PNG",
             {{{"depths", "1 to 16 bits"}, bitsOfPng},
              {{"depths", "palette"},
               [](const fs::path& path) {
                   writePalettePng(path);
                   expectColor(readImage(path).image, {0, 1, 0}, 0); // of (1, 1): blue, green, red
               }},
              {{"alpha", "straight"}, alpha(true, {0.8F, 0.4F, 0, 0.5F}, {0.8F, 0.4F, 0, 0.5F})},
              {{"layers", "–"}, noLayers},
              {{"colour", "cICP"}, displayP3},
              {{"colour", "ICC"}, icc},
              {{"colour", "sRGB"}, srgb},
              {{"colour", "gAMA with cHRM"}, curve(writeWithGamma)},
              {{"orientation", "EXIF"}, turnedPng}}},
            {"JPEG",
             {{{"depths", "8 bits"},
               [](const fs::path& path) {
                   writeForeign(path, even({0.2F, 0.4F, 0.6F}, {32, 32}));
                   expectColor(readImage(path).image, {0.2F, 0.4F, 0.6F}, 0.015F);
               }},
              {{"alpha", "none"}, noAlpha},
              {{"layers", "–"}, noLayers},
              {{"colour", "ICC"}, icc},
              {{"orientation", "EXIF"}, turned}}},
            {"TIFF",
             {{{"depths", "1 to 16 bits"}, bitsOfTiff},
              {{"depths", "32-bit integers"}, wholeNumbers},
              {{"depths", "float"}, samples("float", 0)},
              {{"alpha", "as its ExtraSamples say"},
               [](const fs::path& path) {
                   alpha(false, {0.4F, 0.2F, 0, 0.4F}, {1, 0.5F, 0, 0.4F})(path);
                   alpha(true, {0.8F, 0.4F, 0, 0.4F}, {0.8F, 0.4F, 0, 0.4F})(path);
               }},
              {{"layers", "pages"}, pages},
              {{"colour", "ICC"}, icc},
              {{"orientation", "yes"}, turned}}},
            {"OpenEXR",
             {{{"depths", "half"}, samples("half", 1e-3F)},
              {{"depths", "float"}, samples("float", 0)},
              {{"depths", "32-bit integers"}, wholeNumbers},
              {{"alpha", "multiplied"}, alpha(false, {0.25F, 0.125F, 0, 0.5F}, {0.5F, 0.25F, 0, 0.5F})},
              {{"alpha", "divided on reading"}, alpha(false, {0.1F, 0, 0, 0.2F}, {0.5F, 0, 0, 0.2F})},
              {{"layers", "layers by name"}, layersByName},
              {{"layers", "parts"}, parts},
              {{"colour", "chromaticities"}, chromaticities},
              {{"orientation", "–"}, notTurned}}},
            {"Radiance HDR",
             {{{"depths", "RGBE"}, samples("float", 0.01F)},
              {{"alpha", "none"}, noAlpha},
              {{"layers", "–"}, noLayers},
              {{"colour", "linear"}, linear},
              {{"orientation", "yes"}, orderedHdr}}}};
}

const std::map<std::string, const char*> kEndings = {
    {"PNG", ".png"}, {"JPEG", ".jpg"}, {"TIFF", ".tif"}, {"OpenEXR", ".exr"}, {"Radiance HDR", ".hdr"}};

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string> parted(const std::string& text, char separator) {
    std::vector<std::string> cells;
    std::istringstream line(text);
    for (std::string cell; std::getline(line, cell, separator);)
        cells.push_back(trimmed(cell));
    return cells;
}

/// The rows of the table under "## Read", each with an empty cell before it.
std::vector<std::vector<std::string>> readTable() {
    const std::string page = readText(fs::path(TEXLOOM_SOURCE_DIR) / "docs" / "formats.md");
    std::istringstream lines(page.substr(page.find("## Read")));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("|") && !line.starts_with("|--"))
            rows.push_back(parted(line, '|'));
    return rows;
}

} // namespace

TEST(FormatsPage, SaysWhatIsRead) {
    const TemporaryFolder folder;
    std::map<std::string, Claims> open = claims();
    const auto rows = readTable();
    ASSERT_EQ(rows.size(), 6U);
    for (std::size_t row = 1; row < rows.size(); ++row)
        for (std::size_t column = 2; column < rows[0].size(); ++column) {
            const std::string& format = rows[0][column];
            for (const std::string& text : parted(rows[row].at(column), ',')) {
                SCOPED_TRACE(format + ", " + rows[row][1] + ": " + text);
                const auto claim = open[format].find({rows[row][1], text});
                ASSERT_NE(claim, open[format].end()) << "is a claim that nothing checks";
                claim->second(folder / (std::string("a") + kEndings.at(format)));
                open[format].erase(claim);
            }
        }
    for (const auto& [format, left] : open)
        EXPECT_TRUE(left.empty()) << format << " does not say " << left.begin()->first.second;
}

} // namespace texloom::test::formats_read

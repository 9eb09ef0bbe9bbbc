#include "core/io/image_file.h"
#include "core/session/export/export.h"
#include "core/session/run/edited_exemplar.h"
#include "core/session/session.h"
#include "core/tools/edits.h"
#include "tests/core/session/sample_run.h"
#include "tests/core/tools/sample_edits.h"
#include "tests/support/file_content.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

/// What edits were before each became a tool: their bits, and the form in which files hold them.
namespace texloom::test {

namespace {

namespace fs = std::filesystem;

constexpr Size kSize{97, 83};

std::uint64_t hashOf(const Image& image) {
    std::uint64_t hash = 1469598103934665603ULL; // FNV-1a over the floats
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const float value = image(x, y, c);
                unsigned char bytes[sizeof value];
                std::memcpy(bytes, &value, sizeof value);
                for (const unsigned char byte : bytes)
                    hash = (hash ^ byte) * 1099511628211ULL;
            }
    return hash;
}

Image randomImage(int channels, std::uint32_t state) {
    Image image(kSize, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x) {
                state = state * 1664525U + 1013904223U;
                image(x, y, c) = static_cast<float>(state >> 8U) / 16777216.0F;
            }
    return image;
}

ExemplarFile fileOf(Image image, MapRole role = MapRole::Other) {
    ExemplarFile file;
    file.image = std::make_shared<const Image>(std::move(image));
    file.role = role;
    return file;
}

/// Random pixels with a mask that hides a few, normals and heights.
RunExemplar randomExemplar() {
    RunExemplar exemplar;
    exemplar.image = fileOf(randomImage(3, 1));
    exemplar.image.space = "srgb";
    Image mask = randomImage(1, 2);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x)
            mask(x, y, 0) = mask(x, y, 0) > 0.02F ? 1.0F : 0.0F;
    exemplar.mask = fileOf(std::move(mask));
    exemplar.companions = {fileOf(randomImage(3, 3), MapRole::NormalGl),
                           fileOf(randomImage(1, 4), MapRole::Height)};
    return exemplar;
}

/// Edits and the hashes of image, mask, normals and heights that they made then.
struct Known {
    ExemplarEdits edits;
    std::uint64_t image, mask, normals, heights;
};

std::vector<Known> knownEdits() {
    const ExemplarEdit cropped = crop(5, 7, 70, 60), turned = turn(12.5), quarter = turn(90);
    const ExemplarEdit across = flip("horizontal"), down = flip("vertical");
    const PlanePoints corners = {{3.5, 2}, {60, 4}, {62, 55.25}, {1, 50}};
    const ExemplarEdit small = rectify({{3.5, 2}, {50, 4}, {48, 40.25}, {1, 38}}, {30, 40});
    const ExemplarEdit smooth = flatten("smooth"), polynomial = flatten("polynomial", 0.7, {{"order", 3}});
    return {
        {{cropped}, 0x64ef58f8d91b3670, 0xe78d2c9208a55393, 0xe11247011230a1f7, 0x8749a21b386a90ff},
        {{turned}, 0xb2d4145b135bdead, 0xa8b461c70453461a, 0x8e8c2dcf9f3565c4, 0x39c298a1ba7789b8},
        {{quarter}, 0xc8d5a141bd113e03, 0xe87d7830f5106a3a, 0x1fdae4bc26fa0147, 0x462c1ed61619c8b9},
        {{across}, 0x77b1e451c7ef588b, 0x4dcb59d31492a4ba, 0x970d875407dbb1c3, 0x4f74d5503b33b971},
        {{down}, 0x70ba6b4097563997, 0xcd1d46a1d72c965a, 0xf365e92610fed3c9, 0x216a4c3ef5a42ac5},
        {{rectify(corners)}, 0xcc145910b60b8375, 0x89da6fbc43a930f3, 0x1e032bd9f2e6920f, 0x936174cba9cdd50f},
        {{rectify(corners, {30, 40})},
         0x1f6eeb7d30fb70f4,
         0x6453d8aa90610323,
         0xeb1eca85a74727dc,
         0xd9a99235146ca96f},
        {{smooth}, 0x96b0188cc27b6048, 0xa208e49f7b93fd7a, 0x3c581fddfc1308ad, 0xe86acbbc4b170891},
        {{polynomial}, 0xbc9b8c6a7fe1f82d, 0xa208e49f7b93fd7a, 0x3c581fddfc1308ad, 0xe86acbbc4b170891},
        {{cropped, turned, smooth, down, small, polynomial, quarter},
         0x17266533e8470e7b,
         0x419ad7c5b71285ca,
         0x39cb662391e3193c,
         0xac4c31b9208d661f}};
}

fs::path dataFile(const char* name) {
    return fs::path(TEXLOOM_SOURCE_DIR) / "tests" / "data" / name;
}

nlohmann::json jsonOf(const std::string& text) {
    return nlohmann::json::parse(text);
}

void expectComplete(const ExemplarEdits& edits) {
    EXPECT_EQ(edits.size(), 7U);
    EXPECT_EQ(resolved(edits), edits);
}

} // namespace

TEST(EditBits, AreThoseFromBeforeThereWereTools) {
    const RunExemplar exemplar = randomExemplar();
    for (const Known& known : knownEdits()) {
        const RunExemplar made = edited(exemplar, known.edits);
        EXPECT_EQ(hashOf(*made.image.image), known.image) << made.edits.front().begin()->first;
        EXPECT_EQ(hashOf(*made.mask->image), known.mask) << made.edits.front().begin()->first;
        EXPECT_EQ(hashOf(*made.companions[0].image), known.normals) << made.edits.front().begin()->first;
        EXPECT_EQ(hashOf(*made.companions[1].image), known.heights) << made.edits.front().begin()->first;
    }
}

TEST(EditFiles, ARecipeFromBeforeThereWereToolsIsReadAndWrittenAlike) {
    const std::string text = contentOf(dataFile("recipe_with_edits.json"));
    const Recipe recipe = Recipe::fromJson(text, "/data");
    expectComplete(recipe.exemplars.front().edits);
    EXPECT_EQ(jsonOf(recipe.toJson("/data"))["exemplars"], jsonOf(text)["exemplars"]);
}

TEST(EditFiles, ASessionFromBeforeThereWereToolsIsReadAndWrittenAlike) {
    const std::string text = contentOf(dataFile("session_with_edits.texloom"));
    const Session session = Session::fromJson(text, "/data");
    expectComplete(session.settings.exemplars.front().edits);
    EXPECT_EQ(jsonOf(session.toJson("/data"))["settings"]["exemplars"],
              jsonOf(text)["settings"]["exemplars"]);
}

TEST(EditFiles, APictureFromBeforeThereWereToolsIsMadeAgainFromItsRecipe) {
    const fs::path file = dataFile("edited_by_0_1.png");
    SampleRun again;
    again.input = loadRecipe(readRecipe(file));
    expectComplete(again.input.exemplars.front().edits);
    ExportOptions options;
    options.image = again.folder / "again.png";
    options.depth = Depth::Bits8;
    exportResult(again.run(), options);
    EXPECT_TRUE(samePixels(readImage(options.image).image, readImage(file).image));
}

} // namespace texloom::test

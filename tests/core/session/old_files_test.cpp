// Files in the form that Texloom 0.1 wrote before methods had ports.

#include "core/io/image_file.h"
#include "core/session/run/run.h"
#include "core/session/session.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace texloom::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string oldRecipe() {
    return readText(fs::path(TEXLOOM_SOURCE_DIR) / "tests/data/recipe_with_inputs.json");
}

TEST(OldFiles, aRecipeFromBeforeThereWerePortsIsReadAndWrittenAlike) {
    const Recipe recipe = Recipe::fromJson(oldRecipe(), "/data");
    EXPECT_EQ(Json::parse(recipe.toJson("/data")), Json::parse(oldRecipe()));
}

TEST(OldFiles, itsMaskMapWeightImageToStartFromAndPartGoIntoTheRun) {
    const TemporaryFolder folder;
    writeImage(folder / "bark.png", blobs({48, 40}, 3), {});
    writeImage(folder / "moss.png", blobs({30, 44}, 3, 5), {});
    writeImage(folder / "mask.png", constant({48, 40}, 1, 1), {});
    writeImage(folder / "bark_normal.png", blobs({48, 40}, 3, 7), {});
    writeImage(folder / "start.png", blobs({96, 64}, 3, 9), {});
    const RunInput input = loadRecipe(Recipe::fromJson(oldRecipe(), folder.path()));
    ASSERT_EQ(input.steps.size(), 2U);
    EXPECT_EQ(input.steps[1].method, "texture-optimization");
    ASSERT_EQ(input.exemplars.size(), 2U);
    EXPECT_TRUE(input.exemplars[0].mask);
    EXPECT_EQ(input.exemplars[0].companions.size(), 1U);
    EXPECT_EQ(input.exemplars[0].weight, 2.5);
    EXPECT_EQ(input.exemplars[1].image.space, "linear");
    ASSERT_TRUE(input.inputs.contains("initial"));
    EXPECT_EQ(input.inputs.at("initial").front().file.image->size(), (Size{96, 64}));
    EXPECT_EQ(input.seed, 18446744073709551615ULL);
    EXPECT_EQ(input.region, (Region{8, 16, {40, 32}}));
    EXPECT_TRUE(input.wrap.x && !input.wrap.y);
}

TEST(OldFiles, aSessionOfSuchSettingsIsReadAndWrittenAlike) {
    const Json session = {{"session", 1},
                          {"settings", Json::parse(oldRecipe())},
                          {"used", {true, false}},
                          {"current", 1},
                          {"seedLocked", true}};
    EXPECT_EQ(Json::parse(Session::fromJson(session.dump(), "/data").toJson("/data")), session);
}

} // namespace
} // namespace texloom::test

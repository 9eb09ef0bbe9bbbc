#include "core/base/error.h"
#include "core/session/export/export.h"
#include "core/session/run/material_files.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace texloom::test {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> named(const std::vector<std::string>& names) {
    std::vector<fs::path> files;
    for (const std::string& name : names)
        files.push_back(fs::path("/pictures") / name);
    return files;
}

std::vector<std::string> namesOf(const std::vector<fs::path>& files) {
    std::vector<std::string> names;
    for (const fs::path& file : files)
        names.push_back(file.filename().string());
    return names;
}

} // namespace

TEST(MaterialFiles, SortsAnAmbientCgFolderIntoOneMaterial) {
    const auto materials = materialsOf(
        named({"Bricks_1K-JPG_AmbientOcclusion.jpg", "Bricks_1K-JPG_Color.jpg", "Bricks_1K-JPG_NormalDX.jpg",
               "Bricks_1K-JPG_NormalGL.jpg", "Bricks_1K-JPG_Roughness.jpg", "Bricks.png"}));
    ASSERT_EQ(materials.size(), 1U);
    EXPECT_EQ(materials[0].image.filename(), "Bricks_1K-JPG_Color.jpg");
    EXPECT_THAT(namesOf(materials[0].maps),
                testing::ElementsAre("Bricks_1K-JPG_AmbientOcclusion.jpg", "Bricks_1K-JPG_NormalGL.jpg",
                                     "Bricks_1K-JPG_Roughness.jpg"));
}

TEST(MaterialFiles, TakesPackedMapsForWhatHasNoFileOfItsOwn) {
    const auto materials = materialsOf(
        named({"rock_arm_1k.png", "rock_diff_1k.png", "rock_nor_gl_1k.png", "moss_diff.png", "photo.jpg"}));
    ASSERT_EQ(materials.size(), 3U);
    EXPECT_EQ(materials[0].image.filename(), "rock_diff_1k.png");
    EXPECT_THAT(namesOf(materials[0].maps), testing::ElementsAre("rock_nor_gl_1k.png", "rock_arm_1k.png"));
    EXPECT_TRUE(materials[1].maps.empty());
    EXPECT_EQ(materials[2].image.filename(), "photo.jpg");
    const auto alone = materialsOf(
        named({"rock_diff.png", "rock_ao.png", "rock_rough.png", "rock_metal.png", "rock_orm.png"}));
    EXPECT_THAT(namesOf(alone.at(0).maps),
                testing::ElementsAre("rock_ao.png", "rock_rough.png", "rock_metal.png"));
}

TEST(MaterialFiles, FindsWhatLiesBesideAPicture) {
    const SampleRun sample;
    for (const char* name : {"bark_normal", "bark_orm", "birch_normal"})
        sample.write(name, {48, 44}, 3);
    const fs::path bark = sample.folder / "bark.png";
    EXPECT_THAT(namesOf(neighboursOf(bark, {})), testing::ElementsAre("bark_normal.png", "bark_orm.png"));
    EXPECT_THAT(namesOf(neighboursOf(bark, {sample.folder / "bark_normal.png"})),
                testing::ElementsAre("bark_orm.png"));
    EXPECT_EQ(picturesIn(sample.folder.path()).size(), 4U);
}

TEST(MaterialFiles, PackedMapsAreSplitLaidOutAndPackedAgain) {
    SampleRun sample;
    const fs::path packed = sample.write("bark_MetallicSmoothness", {48, 44}, 4, 5);
    std::vector<ExemplarFile> maps = loadCompanions(packed);
    ASSERT_EQ(maps.size(), 2U);
    EXPECT_EQ(maps[0].role, MapRole::Metallic);
    EXPECT_EQ(maps[1].role, MapRole::Roughness);
    const Image whole = std::move(readImage(packed).image);
    EXPECT_EQ((*maps[0].image)(7, 9, 0), whole(7, 9, 0));
    EXPECT_EQ((*maps[1].image)(7, 9, 0), 1 - whole(7, 9, 3));
    sample.input.exemplars.front().companions = std::move(maps);
    const Result result = sample.run();
    ExportOptions options;
    options.image = sample.folder / "made.png";
    const std::vector<ExportEntry> written = exportResult(result, options);
    const fs::path again = sample.folder / "made_MetallicSmoothness.png";
    EXPECT_TRUE(std::any_of(written.begin(), written.end(),
                            [&](const ExportEntry& entry) { return entry.path == again; }));
    const Image image = std::move(readImage(again).image);
    ASSERT_EQ(image.channels(), 4);
    for (int x = 0; x < image.width(); ++x) {
        EXPECT_NEAR(image(x, 3, 0), result.companion(0)(x, 3, 0), 1e-6);
        EXPECT_NEAR(image(x, 3, 3), 1 - result.companion(1)(x, 3, 0), 1e-6);
    }
    options.preset = findExportPreset("unreal"); // which packs in another order
    options.image = sample.folder / "T_bark_BC.png";
    options.pattern = "T_bark_$map";
    exportResult(result, options);
    const Image orm = std::move(readImage(sample.folder / "T_bark_ORM.png").image);
    EXPECT_NEAR(orm(5, 5, 1), result.companion(1)(5, 5, 0), 1.0 / 255);
    EXPECT_NEAR(orm(5, 5, 2), result.companion(0)(5, 5, 0), 1.0 / 255);
}

TEST(MaterialFiles, RecipesNameTheChannel) {
    SampleRun sample;
    sample.input.exemplars.front().companions = loadCompanions(sample.write("bark_orm", {48, 44}, 3, 5));
    const Recipe recipe = planRun(sample.input).recipe;
    const Recipe read = Recipe::fromJson(recipe.toJson(sample.folder.path()), sample.folder.path());
    const RunInput again = loadRecipe(read);
    ASSERT_EQ(again.exemplars.front().companions.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const ExemplarFile& map = again.exemplars.front().companions[i];
        EXPECT_EQ(map.role, sample.input.exemplars.front().companions[i].role);
        EXPECT_TRUE(samePixels(*map.image, *sample.input.exemplars.front().companions[i].image));
    }
    EXPECT_THAT(
        [&] {
            loadData(sample.folder / "bark_orm.png", {}, {7, false});
        },
        usageRefusal("bark_orm", "8"));
}

TEST(MaterialFiles, GreyBesideColourIsPromoted) {
    SampleRun sample;
    sample.input.exemplars.push_back({loadExemplar(sample.write("ash", {48, 44}, 1, 4)), {}, {}});
    const RunPlan plan = planRun(sample.input);
    ASSERT_EQ(plan.request.exemplars.size(), 2U);
    const Image& grey = *plan.request.exemplars[1].image;
    EXPECT_EQ(grey.channels(), 3);
    EXPECT_EQ(grey(4, 5, 0), (*sample.input.exemplars[1].image.image)(4, 5, 0));
    EXPECT_EQ(grey(4, 5, 2), grey(4, 5, 0));
    EXPECT_TRUE(std::any_of(plan.notes.begin(), plan.notes.end(), [](const Message& note) {
        return note.text().find("ash is grey") != std::string::npos;
    }));
    sample.input.exemplars.push_back({loadExemplar(sample.write("leaf", {48, 44}, 4, 4)), {}, {}});
    const RunPlan alpha = planRun(sample.input);
    EXPECT_EQ(alpha.request.channels(), 4);
    EXPECT_EQ((*alpha.request.exemplars[0].image)(4, 5, 3), 1);
    EXPECT_EQ((*alpha.request.exemplars[1].image)(4, 5, 3), 1);
}

TEST(MaterialFiles, CountsWhatWholeNumbersCutOff) {
    Image image(Size{5, 4}, 3);
    image(1, 1, 0) = 1.27F;
    image(2, 1, 1) = -0.25F;
    image(3, 1, 2) = 1;
    EXPECT_EQ(clippedSamples(image), 2U);
}

} // namespace texloom::test

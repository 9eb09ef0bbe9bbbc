#include "core/image/normal_map.h"
#include "core/session/run/edited_exemplar.h"
#include "core/tools/edits.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"
#include "tests/core/tools/sample_edits.h"

namespace texloom::test {

namespace {

const ExemplarEdits kEdits = {crop(2, 2, 44, 40), turn(90), flatten("smooth"), flip("vertical")};

Recipe throughJson(const Recipe& recipe, const std::filesystem::path& folder) {
    return Recipe::fromJson(recipe.toJson(folder), folder);
}

} // namespace

TEST(EditedExemplar, CompanionsAndMaskComeAlong) {
    SampleRun sample;
    sample.addCompanion("bark_normal", {48, 44});
    sample.addCompanion("bark_height", {48, 44});
    RunExemplar& source = sample.input.exemplars.front();
    source.mask = loadMask(sample.write("mask", {48, 44}, 1));
    EXPECT_EQ(source.companions[0].role, MapRole::NormalGl);
    EXPECT_EQ(source.companions[1].role, MapRole::Height);
    const RunExemplar made = edited(source, kEdits);
    for (const ExemplarFile* file : {&made.image, &*made.mask, &made.companions[0], &made.companions[1]})
        EXPECT_EQ(file->image->size(), (Size{40, 44}));
    // Down the right column goes the crop's top row; flipped, up it.
    for (int x = 0; x < 44; ++x) {
        EXPECT_EQ((*made.companions[1].image)(39, 43 - x, 0), (*source.companions[1].image)(x + 2, 2, 0));
        EXPECT_NEAR((*made.companions[0].image)(39, 43 - x, 0), (*source.companions[0].image)(x + 2, 2, 1),
                    1e-6);
        EXPECT_NEAR((*made.companions[0].image)(39, 43 - x, 1), (*source.companions[0].image)(x + 2, 2, 0),
                    1e-6);
    }
}

TEST(EditedExemplar, ARecipeMakesTheSameResultAgain) {
    SampleRun sample;
    sample.addCompanion("bark_normal", {48, 44});
    sample.input.exemplars.front() = edited(sample.input.exemplars.front(), kEdits);
    const Result first = sample.run();
    sample.input = loadRecipe(throughJson(first.plan.recipe, sample.folder.path()));
    const Result again = sample.run();
    EXPECT_TRUE(samePixels(first.synthesis.image, again.synthesis.image));
    EXPECT_TRUE(samePixels(first.companion(0), again.companion(0)));
    EXPECT_EQ(again.plan.recipe.exemplars.front().edits, resolved(kEdits));
}

TEST(EditedExemplar, TheRoleInARecipeOverrulesTheName) {
    SampleRun sample;
    sample.addCompanion("bark_normal", {48, 44});
    sample.input.exemplars.front().companions.front().role = MapRole::NormalDx;
    const Recipe recipe = planRun(sample.input).recipe;
    EXPECT_EQ(recipe.exemplars.front().companions.front().role, "normal-dx");
    const RunInput again = loadRecipe(throughJson(recipe, sample.folder.path()));
    EXPECT_EQ(again.exemplars.front().companions.front().role, MapRole::NormalDx);
}

TEST(EditedExemplar, NormalsOfStatisticalMethodsAreMadeOneLong) {
    SampleRun sample;
    sample.addCompanion("bark_normal", {48, 44});
    sample.input.steps.front().method = "random-phase";
    sample.input.steps.front().parameters = {};
    const Result result = sample.run();
    Image unit = result.companions.front();
    renormalize(unit);
    for (int x = 0; x < unit.width(); ++x)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(unit(x, 5, c), result.companions.front()(x, 5, c), 1e-5);
}

TEST(EditedExemplar, RefusesWhatDoesNotFit) {
    SampleRun sample;
    sample.addCompanion("bark_height", {40, 44});
    const RunExemplar& source = sample.input.exemplars.front();
    EXPECT_THAT([&] { edited(source, kEdits); }, usageRefusal("bark_height", "40 × 44", "48 × 44"));
    SampleRun plain;
    EXPECT_THAT([&] { edited(plain.input.exemplars.front(), {crop(0, 0, 49, 10)}); },
                usageRefusal("49 × 10", "48 × 44"));
}

} // namespace texloom::test

#include "core/image/normal_map.h"
#include "core/session/run/edited_exemplar.h"
#include "core/tools/edits.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"
#include "tests/core/tools/sample_edits.h"

#include <cmath>

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

TEST(EditedPreview, IsTheWholeReduced) {
    SampleRun sample;
    RunExemplar& source = sample.input.exemplars.front();
    Image waves({330, 270}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < waves.height(); ++y)
            for (int x = 0; x < waves.width(); ++x)
                waves(x, y, c) = 0.5F + 0.2F * std::sin(0.05F * static_cast<float>(x + c)) *
                                            std::cos(0.04F * static_cast<float>(y));
    source.image.image = std::make_shared<const Image>(waves);
    const ExemplarEdits edits = {crop(10, 20, 300, 240), turn(12), flatten("smooth"), flip("horizontal")};
    const Image whole = *edited(source, edits).image.image;
    const Image reduced = reducedImage(waves, 2);
    EXPECT_EQ(reduced.size(), (Size{165, 135}));
    EXPECT_NEAR(reduced(7, 9, 1),
                (waves(14, 18, 1) + waves(15, 18, 1) + waves(14, 19, 1) + waves(15, 19, 1)) / 4, 1e-6);
    const EditedPreview preview = editedPreview(source.image, reduced, 2, edits, 100);
    EXPECT_EQ(preview.whole, whole.size());
    EXPECT_LE(preview.image.size().longerSide(), 100);
    const Image expected = reducedImage(whole, preview.step);
    ASSERT_EQ(preview.image.size(), expected.size());
    double apart = 0;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < expected.height(); ++y)
            for (int x = 0; x < expected.width(); ++x)
                apart += std::abs(static_cast<double>(preview.image(x, y, c) - expected(x, y, c)));
    EXPECT_LT(apart / static_cast<double>(3 * expected.size().area()), 0.01);
}

TEST(EditedPreview, RefusesWhatCannotBeMadeAndEndsWhenTold) {
    SampleRun sample;
    const ExemplarFile& image = sample.input.exemplars.front().image;
    const Image reduced = reducedImage(*image.image, 1);
    EXPECT_THROW(editedPreview(image, reduced, 1, {crop(0, 0, 4000, 10)}, 100), UsageError);
    const auto end = [] { throw Cancelled{}; };
    EXPECT_THROW(editedPreview(image, reduced, 1, {turn(5)}, 100, end), Cancelled);
    EXPECT_THROW(edited(sample.input.exemplars.front(), {turn(5)}, end), Cancelled);
}

} // namespace texloom::test

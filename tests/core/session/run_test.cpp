#include "core/session/run/exemplar_use.h"
#include "core/session/run/run.h"
#include "tests/core/io/write_as.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"
#include "tests/support/says.h"

#include <gmock/gmock.h>

namespace texloom::test {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

} // namespace

TEST(PlanRun, CompletesTheSettings) {
    const SampleRun sample;
    const RunPlan plan = planRun(sample.input);
    const RunStep& step = plan.steps.front();
    EXPECT_EQ(step.settings.size(), step.method->params().size());
    EXPECT_EQ(step.settings.at("patch"), Value(12));
    EXPECT_EQ(plan.recipe.steps.front().parameters, step.settings);
}

TEST(PlanRun, RefusesMoreMemoryThanThereIsWithBothFigures) {
    SampleRun sample;
    sample.input.size = {4000, 4000};
    const std::uint64_t need = planRun(sample.input).estimate.bytes;
    EXPECT_THAT([&] { planRun(sample.input, 64ULL << 20); },
                ThrowsMessage<Error>(AllOf(HasSubstr("4000 × 4000 px"), HasSubstr("64 MiB"),
                                           HasSubstr("MiB of memory"), HasSubstr("smaller"))));
    EXPECT_NO_THROW(planRun(sample.input, need));
    EXPECT_THROW(planRun(sample.input, need - 1), Error);
}

TEST(RunPlan, GetsToItsEndWhereNobodySaysHowLongItTakes) {
    RunPlan plan = planRun(SampleRun().input);
    plan.estimate.seconds = plan.steps.front().estimate.seconds = 0;
    JobMonitor monitor;
    JobContext context(
        {plan.request.seed, 2, false}, [] { return false; }, monitor);
    EXPECT_EQ(runPlan(plan, context).synthesis.image.size(), (Size{64, 60}));
    EXPECT_NEAR(monitor.progress(), 1, 1e-6);
}

TEST(PlanRun, RefusesARunWithoutAnExemplar) {
    SampleRun sample;
    sample.input.exemplars.clear();
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("no exemplar"));
}

TEST(PlanRun, RefusesACompanionOfAnotherSizeWithBothSizes) {
    SampleRun sample;
    sample.addCompanion("bark_normal", {40, 48});
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("bark_normal", "40 × 48", "48 × 44"));
}

TEST(PlanRun, RefusesUnequalNumbersOfCompanions) {
    SampleRun sample;
    sample.input.exemplars.push_back(sample.input.exemplars.front());
    sample.addCompanion("bark_normal", {48, 44});
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("companion", "1", "0"));
}

TEST(PlanRun, SuggestsTheMethodThatWasMeant) {
    SampleRun sample;
    sample.input.steps.front().method = "quiting";
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("quiting", "Did you mean quilting?"));
}

TEST(PlanRun, SuggestsTheParameterThatWasMeant) {
    SampleRun sample;
    sample.input.steps.front().parameters["tolerence"] = 0.5;
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("tolerence", "Did you mean tolerance?"));
}

TEST(PlanRun, RefusesASettingOutOfRange) {
    SampleRun sample;
    sample.input.steps.front().parameters["patch"] = 1;
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("patch = 1", "4 to 512 px"));
}

TEST(PlanRun, RefusesAnOutputWithoutPixels) {
    SampleRun sample;
    sample.input.size = {0, 64};
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("0 × 64", "65,536"));
}

TEST(PlanRun, RefusesExemplarsWithUnequalChannels) {
    SampleRun sample;
    ExemplarFile deep = loadExemplar(sample.write("deep", {50, 50}, 1));
    deep.image = std::make_shared<const Image>(blobs({50, 50}, 5)); // grey beside colour would be made alike
    sample.input.exemplars.push_back({deep, {}, {}});
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("bark", "3", "deep", "5"));
}

TEST(PlanRun, RefusesAMaskOfAnotherSize) {
    SampleRun sample;
    sample.input.exemplars[0].mask = loadMask(sample.write("mask", {20, 20}, 1));
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("20 × 20", "48 × 44"));
}

TEST(PlanRun, RefusesAnInitialImageOfAnotherSize) {
    SampleRun sample;
    sample.input.inputs["initial"] = {loadExemplar(sample.write("start", {20, 20}, 3))};
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("20 × 20", "64 × 60"));
}

TEST(StartRun, GivesTheMethodsResultAndTheQualityFigures) {
    const SampleRun sample;
    const Result result = sample.run();
    EXPECT_EQ(result.synthesis.image.size(), sample.input.size);
    std::vector<std::string> names;
    for (const Figure& figure : result.figures)
        names.push_back(figure.name.text());
    EXPECT_THAT(names, ::testing::IsSupersetOf({"Innovation", "Seam, left to right", "Seam, top to bottom"}));
    EXPECT_FALSE(result.stages.empty());
}

TEST(StartRun, GivesTheSameBitsOnAnyNumberOfThreads) {
    SampleRun sample;
    sample.input.threads = 1;
    const Result one = sample.run();
    sample.input.threads = 7;
    const Result seven = sample.run();
    EXPECT_TRUE(samePixels(one.synthesis.image, seven.synthesis.image));
    EXPECT_EQ(one.synthesis.map, seven.synthesis.map);
}

TEST(StartRun, NotesWhereWeightsHaveNoEffect) {
    SampleRun sample;
    sample.input.exemplars.push_back(sample.input.exemplars.front());
    sample.input.exemplars.back().weight = 4;
    EXPECT_TRUE(sample.run().synthesis.notes.empty());
    sample.input.steps.front().method = "patchmatch";
    sample.input.steps.front().parameters = {};
    const Result weighed = sample.run();
    EXPECT_THAT(weighed.synthesis.notes, ::testing::Contains(says("weights")));
    EXPECT_EQ(weighed.plan.recipe.exemplars.back().weight, 4);
    sample.input.exemplars.back().weight = 0;
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("0", "0.01"));
}

TEST(StartRun, GivesAnotherTextureForAnotherSeed) {
    SampleRun sample;
    const Result one = sample.run();
    ++sample.input.seed;
    EXPECT_FALSE(samePixels(one.synthesis.image, sample.run().synthesis.image));
}

TEST(LoadRecipe, TellsWhichFileHasChanged) {
    const SampleRun sample;
    const Recipe recipe = planRun(sample.input).recipe;
    std::vector<std::filesystem::path> changed;
    const auto note = [&](const std::filesystem::path& path) { changed.push_back(path); };
    loadRecipe(recipe, note);
    EXPECT_TRUE(changed.empty());
    sample.write("bark", {48, 44}, 3, 99);
    loadRecipe(recipe, note);
    EXPECT_EQ(changed, std::vector{sample.folder / "bark.png"});
}

TEST(LoadRecipe, BringsBackThePicturesThatBelongToAnExemplar) {
    SampleRun sample;
    sample.input.steps = {{"texture-transfer", {{"patch", 12}}}};
    sample.input.exemplars.front().inputs["correspondence"] = {
        loadExemplar(sample.write("heights", {48, 44}, 1))};
    sample.input.inputs["target"] = {loadExemplar(sample.write("face", sample.input.size, 1, 7))};
    const Result first = sample.run();
    std::vector<std::filesystem::path> changed;
    const auto note = [&](const std::filesystem::path& path) { changed.push_back(path); };
    sample.input = loadRecipe(first.plan.recipe, note);
    ASSERT_EQ(sample.input.exemplars.front().inputs.count("correspondence"), 1U);
    EXPECT_TRUE(samePixels(sample.run().synthesis.image, first.synthesis.image));
    EXPECT_TRUE(changed.empty());
    sample.write("heights", {48, 44}, 1, 99);
    loadRecipe(first.plan.recipe, note);
    EXPECT_EQ(changed, std::vector{sample.folder / "heights.png"});
}

TEST(PlanRun, APictureOfTheExemplarThatNoMethodTakesIsRefused) {
    SampleRun sample;
    sample.input.exemplars.front().inputs["guide"] = {loadExemplar(sample.write("labels", {48, 44}, 3))};
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("guide"));
    EXPECT_TRUE(exemplarsFor(sample.input.steps, sample.input.exemplars, {true}, 0).front().inputs.empty())
        << "the window keeps it for methods that do";
    sample.input.steps = {{"analogy", {}}};
    EXPECT_EQ(exemplarsFor(sample.input.steps, sample.input.exemplars, {true}, 0).front().inputs.size(), 1U);
}

TEST(PlanRun, AMethodThatFollowsIsNotGivenThePicturesOfTheOneBefore) {
    SampleRun sample;
    sample.input.steps = {{"analogy", {}}, {"quilting", {{"patch", 12}}}};
    sample.input.exemplars.front().inputs["guide"] = {loadExemplar(sample.write("labels", {48, 44}, 3))};
    sample.input.inputs["output-guide"] = {loadExemplar(sample.write("layout", sample.input.size, 3, 7))};
    EXPECT_NO_THROW(planRun(sample.input));
}

TEST(LoadRecipe, NamesAFileThatIsGone) {
    const SampleRun sample;
    const Recipe recipe = planRun(sample.input).recipe;
    std::filesystem::remove(sample.folder / "bark.png");
    EXPECT_THAT([&] { loadRecipe(recipe); }, ThrowsMessage<Error>(HasSubstr("bark.png")));
}

TEST(LoadRecipe, RefusesAnUnknownParameterBeforeItOpensAnyFile) {
    const SampleRun sample;
    Recipe recipe = planRun(sample.input).recipe;
    std::filesystem::remove(sample.folder / "bark.png");
    recipe.steps.front().parameters["pach"] = 12;
    EXPECT_THAT([&] { loadRecipe(recipe); }, usageRefusal("pach", "Did you mean patch?"));
}

TEST(LoadMask, TakesTheFirstChannel) {
    const SampleRun sample;
    const std::filesystem::path path = sample.write("mask", {48, 44}, 3);
    const LoadedImage whole = readImage(path);
    ImageView first = whole.image;
    first.channels = 1;
    EXPECT_TRUE(samePixels(*loadMask(path).image, first));
}

TEST(LoadData, KeepsTheFilesValues) {
    const SampleRun sample;
    const std::filesystem::path path = sample.folder / "height.exr";
    const Image heights = noise({9, 9}, 3);
    writeImage(path, heights, as(Depth::Float, "linear"));
    EXPECT_TRUE(samePixels(*loadData(path).image, heights));
    EXPECT_FALSE(samePixels(*loadExemplar(path).image, heights));
}

TEST(Result, IsNamedAfterExemplarMethodSeedAndSize) {
    const SampleRun sample;
    EXPECT_EQ(sample.run().fileName(), "bark_quilting_s3_64x60");
}

} // namespace texloom::test

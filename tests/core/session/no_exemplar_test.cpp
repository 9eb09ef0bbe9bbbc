// Runs of methods that learn from no exemplar, and methods that give what they do not declare.

#include "core/io/model_file.h"
#include "core/session/export/export.h"
#include "core/session/results/result_files.h"
#include "core/session/run/exemplar_use.h"
#include "core/session/session.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"
#include "tests/support/volumes.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <vector>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A model of the colours of so many channels: means 0.25, 0.5 …, and no deviation.
std::shared_ptr<Model> evenMoments(std::int64_t channels) {
    auto model = std::make_shared<Model>();
    model->kind = "moments";
    std::vector<double> mean;
    for (std::int64_t c = 0; c < channels; ++c)
        mean.push_back(0.25 * static_cast<double>(c + 1));
    model->arrays["mean"] = {{channels}, mean};
    model->arrays["root"] = {{channels, channels},
                             std::vector<double>(static_cast<std::size_t>(channels * channels))};
    return model;
}

/// A run of draw-moments from a model alone.
struct DrawRun : SampleRun {
    explicit DrawRun(std::int64_t channels) {
        const fs::path path = folder / "grey.safetensors";
        writeModel(path, *evenMoments(channels));
        input.steps = {{"draw-moments", {}}};
        input.exemplars.clear();
        input.inputs["moments"] = {
            loadInput(*findMethod("draw-moments").info().input("moments"), {path, "", ""}, {})};
    }
};

std::vector<RecipeStep> steps(const std::vector<std::string>& ids) {
    std::vector<RecipeStep> all;
    for (const std::string& id : ids)
        all.push_back({id, {}});
    return all;
}

} // namespace

TEST(RunWithoutExemplars, HasTheChannelsOfItsModel) {
    for (const int channels : {1, 3, 4}) {
        const DrawRun sample(channels);
        EXPECT_EQ(planRun(sample.input).resultChannels(), channels);
        const Image image = sample.run().synthesis.image;
        ASSERT_EQ(image.channels(), channels);
        for (int c = 0; c < channels; ++c)
            EXPECT_FLOAT_EQ(image(5, 7, c), 0.25F * static_cast<float>(c + 1));
    }
}

TEST(RunWithoutExemplars, IsPlannedForTheMemoryOfItsChannels) {
    EXPECT_GT(planRun(DrawRun(40).input).estimate.bytes, planRun(DrawRun(1).input).estimate.bytes);
}

TEST(RunWithoutExemplars, IsExportedUnderTheModelsNameAndRunsAgain) {
    const DrawRun sample(3);
    const Result result = sample.run();
    EXPECT_EQ(result.fileName(), "grey_draw-moments_s3_64x60");
    EXPECT_EQ(nameWords(result, "").at("name"), "grey");
    ExportOptions options;
    options.image = sample.folder / "made.png";
    exportResult(result, options);
    const Image written = readImage(options.image).image;
    EXPECT_NEAR(written(1, 1, 1), 0.5, 1 / 255.0);
    EXPECT_EQ(Json::parse(readText(sample.folder / "made.json")).at("exemplars"), Json::array());
    SampleRun again;
    again.input = loadRecipe(readRun(options.image));
    EXPECT_TRUE(samePixels(again.run().synthesis.image, result.synthesis.image));
}

TEST(RunWithoutExemplars, IsKeptAndReadBack) {
    const DrawRun sample(2);
    const Result result = sample.run();
    const ResultFolder folder(sample.folder / "results");
    const ResultEntry entry = entryFor(result, false);
    folder.write(entry, result);
    const ResultFolder::Scan found = folder.scan();
    ASSERT_EQ(found.entries.size(), 1U);
    const StoredResult stored = folder.read(found.entries.front());
    EXPECT_TRUE(stored.problem.empty()) << stored.problem.text();
    EXPECT_TRUE(samePixels(stored.result->synthesis.image, result.synthesis.image));
    EXPECT_EQ(stored.result->plan.resultChannels(), 2);
    fs::remove(sample.folder / "grey.safetensors");
    const StoredResult orphan = folder.read(found.entries.front());
    EXPECT_FALSE(orphan.problem.empty());
    EXPECT_EQ(orphan.result->plan.resultChannels(), 2);
    EXPECT_FALSE(orphan.result->plan.hasCompanions());
}

TEST(RunWithoutExemplars, IsRefusedWithThem) {
    DrawRun sample(3);
    sample.input.exemplars = SampleRun().input.exemplars;
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("Draw colour moments", "takes no exemplar"));
    keepUsed(sample.input);
    EXPECT_TRUE(sample.input.exemplars.empty());
    EXPECT_NO_THROW(planRun(sample.input));
    SampleRun quilting;
    quilting.input.exemplars.clear();
    EXPECT_THAT([&] { planRun(quilting.input); }, usageRefusal("no exemplar to learn from"));
}

TEST(RunWithoutExemplars, IsWhatASessionHasWhoseMethodTakesNone) {
    Session session;
    session.settings.size = {64, 64};
    session.settings.steps = steps({"quilting"});
    EXPECT_THAT([&] { runOf(session); }, usageRefusal("no exemplar in use"));
    session.settings.steps = steps({"draw-moments"});
    EXPECT_TRUE(runOf(session).exemplars.empty());
    session.settings.exemplars = {{{"/data/bark.png", "srgb", ""}, {}, {}}};
    session.used = {true};
    EXPECT_TRUE(runOf(session).exemplars.empty()) << "it is open, but of no use";
    session.settings.steps = steps({"learn-moments", "draw-moments"});
    EXPECT_EQ(runOf(session).exemplars.size(), 1U);
}

TEST(ExemplarUse, IsWhatTheLearningMethodsHaveInCommon) {
    const ExemplarUse none = useOf(steps({"draw-moments"}));
    EXPECT_FALSE(none.any || none.needed || none.several || none.masks || none.weights || none.companions);
    const ExemplarUse alone = useOf(steps({"texture-optimization"}));
    const ExemplarUse after = useOf(steps({"draw-moments", "texture-optimization"}));
    EXPECT_TRUE(after.any && after.needed && after.companions);
    EXPECT_EQ(after.several, alone.several);
    EXPECT_EQ(after.masks, alone.masks);
    EXPECT_EQ(after.weights, alone.weights);
}

TEST(Pipeline, OfMethodsWithAndWithoutExemplarsShowsThemToTheFormerAlone) {
    DrawRun sample(3);
    sample.input.exemplars = SampleRun().input.exemplars;
    sample.input.steps = steps({"draw-moments", "texture-optimization"});
    const RunPlan plan = planRun(sample.input);
    EXPECT_TRUE(plan.requestFor(0, plan.steps[0].method->info()).exemplars.empty());
    EXPECT_EQ(plan.requestFor(1, plan.steps[1].method->info()).exemplars.size(), 1U);
    EXPECT_EQ(sample.run().synthesis.image.size(), sample.input.size);

    DrawRun grey(1);
    grey.input.exemplars = sample.input.exemplars;
    grey.input.steps = sample.input.steps;
    EXPECT_THAT([&] { planRun(grey.input); }, usageRefusal("1 channel,", "output 3"));
}

TEST(Pipeline, ThatEndsWithoutExemplarsMakesNoCompanionMaps) {
    SampleRun sample;
    sample.addCompanion("bark_normal", {48, 44});
    sample.input.steps = steps({"learn-moments", "draw-moments"});
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("Draw colour moments", "companion maps"));
    keepUsed(sample.input);
    EXPECT_TRUE(sample.run().companions.empty());
}

namespace {

struct NoSettings {};

/// A method whose one output is what `give` makes of it.
Method giving(AssetKind kind, void (*give)(Assets& outputs)) {
    static void (*gives)(Assets&) = nullptr;
    gives = give;
    return named("giving",
                 method<NoSettings>(
                     {.title = "Giving",
                      .summary = "",
                      .citation = "",
                      .takes = {},
                      .gives = {ports::image(),
                                {.id = "thing", .title = "Thing", .help = "", .kind = kind, .least = 1}}},
                     {},
                     [](const Request& request, const NoSettings&, JobContext&) {
                         Synthesis made;
                         made.image = Image(request.size, request.channels());
                         gives(made.outputs);
                         return made;
                     },
                     [](const Request&, const NoSettings&) {},
                     [](const Request&, const NoSettings&, int) { return Estimate{}; }));
}

std::shared_ptr<const Model> emptyModel(const char* kind) {
    auto model = std::make_shared<Model>();
    model->kind = kind;
    return model;
}

} // namespace

TEST(Method, ThatGivesOtherThanItDeclaresIsFoundOut) {
    const auto runOnce = [](AssetKind kind, void (*give)(Assets&)) {
        Request request;
        request.size = {4, 4};
        TestContext context;
        return giving(kind, give).run(request, {}, context);
    };
    const Synthesis fine =
        runOnce(AssetKind::Model, [](Assets& out) { out.add("thing", emptyModel("thing")); });
    EXPECT_EQ(fine.image.channels(), 3) << "colour, where nothing says otherwise";
    EXPECT_THAT(
        [&] { runOnce(AssetKind::Model, [](Assets& out) { out.add("thing", emptyModel("moments")); }); },
        refusal("Giving", "moments", "thing", "mistake in the method"));
    EXPECT_THAT(
        [&] { runOnce(AssetKind::Volume, [](Assets& out) { out.add("thing", emptyModel("thing")); }); },
        refusal("Giving", "a volume", "thing"));
    EXPECT_THAT(
        [&] {
            runOnce(AssetKind::Model, [](Assets& out) { out.add("thing", std::shared_ptr<const Model>()); });
        },
        refusal("Giving", "a model", "thing"));
    EXPECT_THAT([&] { runOnce(AssetKind::Model, [](Assets&) {}); }, refusal("Giving", "1 to 1", "made 0"));
    EXPECT_THAT(
        [&] {
            runOnce(AssetKind::Model, [](Assets& out) {
                out.add("thing", emptyModel("thing"));
                out.add("other", emptyModel("other"));
            });
        },
        refusal("Giving", "other", "does not declare"));
}

} // namespace texloom::test

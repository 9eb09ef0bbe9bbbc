// Methods that follow each other in one run, and companion maps that are made together with the result.

#include "core/analysis/derived_maps.h"
#include "core/session/preset.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <string>

namespace texloom::test {

namespace {

/// Random phase, then quilting on what it made.
struct PipelineRun : SampleRun {
    PipelineRun() {
        input.steps.front().method = "random-phase";
        input.steps.front().parameters = {};
        input.steps.push_back({"quilting", {{"patch", 12}}});
    }
};

/// A step's image by the method alone, with the numbers of the step's stream.
Image alone(const SampleRun& sample, std::size_t step, std::shared_ptr<const Image> initial) {
    const RunPlan plan = planRun(sample.input);
    Request request = plan.request;
    request.inputs.set(kInitialPort, std::move(initial));
    Job<Image> job({plan.request.seed, 1, false}, [&](JobContext& context) {
        context.step(static_cast<std::uint32_t>(step), 1);
        return plan.steps[step].method->run(request, plan.steps[step].settings, context).image;
    });
    return std::get<Image>(job.take());
}

/// What the sources' figures and algorithms were made with, as far as they say it.
const std::vector<std::pair<std::string, Values>> kPublished = {
    // Efros & Leung, ICCV 1999: σ is 1 / 6.4 of the window, ε 0.1, and a seed of 3 px.
    {"efros-leung",
     {{"window", 11},
      {"tolerance", 0.1},
      {"sigma", 1 / 6.4},
      {"seed-size", 3},
      {"order", std::string("onion")},
      {"search", std::string("exact")},
      {"scales", 1}}},
    // Tartavel, Gousseau & Peyré 2013, section 4.
    {"sparse",
     {{"patch", 12},
      {"spacing", 6},
      {"scales", 3},
      {"sparsity", 4},
      {"atoms", 384},
      {"histogram-weight", 1.0},
      {"low-pass-weight", 1.0},
      {"spectrum", false}}},
    // Raad, thesis 2016: figures 2.1, 2.6, 3.4, 3.5 and 4.21, without a balance of contrast.
    {"gaussian-patches",
     {{"patch", 30},
      {"neighbours", 10},
      {"overlap", 0.5},
      {"layout", std::string("mirrored")},
      {"contrast", 0.0}}},
    {"locally-gaussian",
     {{"patch", 30}, {"neighbours", 10}, {"overlap", 0.5}, {"contrast", 0.0}, {"bounded", false}}},
    {"conditional-gaussian",
     {{"patch", 40},
      {"neighbours", 30},
      {"overlap", 0.5},
      {"border", 0},
      {"contrast", 0.0},
      {"bounded", false}}},
    {"multiscale-gaussian",
     {{"patch", 20},
      {"neighbours", 50},
      {"scales", 3},
      {"stitch", std::string("none")},
      {"coarsest-stitch", std::string("average")},
      {"contrast", 0.0},
      {"bounded", false}}},
    {"midway-quilting", {{"patch", 40}, {"overlap", 0.45}, {"contrast", 0.0}}},
    // Raad & Galerne, IPOL 2017, section 4.
    {"quilting", {{"patch", 40}, {"overlap", 0.25}, {"tolerance", 0.1}, {"variety", 0.0}, {"contrast", 0.0}}},
    // López Recas 2011, sections 4.1 and 4.2.
    {"near-regular", {{"block", 40}, {"border", 10}, {"join", std::string("blend")}, {"blend", 4}}},
    {"regular-tile", {{"border", 16}, {"tolerance", 0.0}}},
    // Gutierrez, thesis 2020, algorithm 1 and section 3.1.
    {"patch-assignment",
     {{"patch", 8},
      {"scales", 3},
      {"coarse-iterations", 50},
      {"fine-iterations", 10},
      {"epsilon", 0.0},
      {"settle", 0.0},
      {"solve", std::string("whole")}}},
    {"texture-optimization",
     {{"scales", 3},
      {"largest-patch", 32},
      {"aggregation", std::string("robust-falloff")},
      {"histogram", false},
      {"bidirectional", false},
      {"uniformity", 0.0}}},
};

} // namespace

TEST(Pipeline, EachStepStartsFromTheImageOfTheOneBefore) {
    const PipelineRun sample;
    const auto first = std::make_shared<const Image>(alone(sample, 0, nullptr));
    const Image second = alone(sample, 1, first);
    EXPECT_TRUE(samePixels(sample.run().synthesis.image, second));
    EXPECT_FALSE(samePixels(alone(sample, 1, nullptr), second)) << "the first step must matter";
}

TEST(Pipeline, GivesTheSameBitsOnAnyNumberOfThreads) {
    PipelineRun sample;
    sample.input.threads = 1;
    const Image one = sample.run().synthesis.image;
    sample.input.threads = 5;
    EXPECT_TRUE(samePixels(sample.run().synthesis.image, one));
}

TEST(Pipeline, RunsAgainFromItsRecipe) {
    const PipelineRun sample;
    const Result first = sample.run();
    const Recipe recipe =
        Recipe::fromJson(first.plan.recipe.toJson(sample.folder.path()), sample.folder.path());
    ASSERT_EQ(recipe.steps.size(), 2U);
    EXPECT_EQ(recipe.steps[1].method, "quilting");
    EXPECT_EQ(recipe.steps[1].parameters, first.plan.steps[1].settings);
    SampleRun again;
    again.input = loadRecipe(recipe);
    EXPECT_TRUE(samePixels(again.run().synthesis.image, first.synthesis.image));
}

TEST(Pipeline, NeedsTheMemoryOfItsLargestStepAndTheImageBetween) {
    const RunPlan plan = planRun(PipelineRun().input);
    ASSERT_EQ(plan.steps.size(), 2U);
    const std::uint64_t between = Image::bytesFor(plan.request.size, plan.request.channels());
    EXPECT_EQ(plan.estimate.bytes,
              std::max(plan.steps[0].estimate.bytes, plan.steps[1].estimate.bytes + between));
    EXPECT_DOUBLE_EQ(plan.estimate.seconds, plan.steps[0].estimate.seconds + plan.steps[1].estimate.seconds);
}

TEST(Pipeline, IsNamedAfterAllItsMethods) {
    const Result result = PipelineRun().run();
    EXPECT_EQ(result.label(), "random-phase + quilting · seed 3 · 64 × 60");
    EXPECT_EQ(result.fileName(), "bark_random-phase_quilting_s3_64x60");
}

TEST(Pipeline, RefusesAMethodThatCannotStartFromAnImage) {
    SampleRun sample;
    sample.input.steps.push_back({"random-phase", {}});
    EXPECT_THAT([&] { planRun(sample.input); },
                usageRefusal("Random phase", "uses nothing", "Image quilting"));
}

TEST(Pipeline, WrapsWhereItsLastMethodCan) {
    PipelineRun sample;
    sample.input.wrap = {true, false};
    sample.input.steps = {{"solid-optimise", {}}, {"quilting", {{"patch", 12}}}};
    const RunPlan plan = planRun(sample.input);
    EXPECT_FALSE(plan.requestFor(0, plan.steps[0].method->info(), false).wrap.x);
    EXPECT_TRUE(plan.requestFor(1, plan.steps[1].method->info()).wrap.x);
    sample.input.steps.pop_back();
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("cannot make an output that wraps"));
}

TEST(Pipeline, RefusesAWrongSettingOfALaterStep) {
    PipelineRun sample;
    sample.input.steps[1].parameters["patch"] = 1;
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("patch", "1", "4"));
    sample.input.steps[1] = {"quiting", {}};
    EXPECT_THAT([&] { planRun(sample.input); }, usageRefusal("Did you mean quilting?"));
}

TEST(Pipeline, ProgressCoversAllSteps) {
    JobMonitor monitor;
    JobContext context(
        {1, 1, false}, [] { return false; }, monitor);
    context.step(0, 0.25);
    context.stage(1, "first");
    context.progress(1);
    EXPECT_DOUBLE_EQ(monitor.progress(), 0.25);
    const std::uint32_t first = context.random().bits(3, 4);
    context.step(1, 0.75);
    context.stage(0.5, "second");
    context.progress(1);
    EXPECT_DOUBLE_EQ(monitor.progress(), 0.625);
    context.stage(0.5, "third");
    context.progress(1);
    EXPECT_DOUBLE_EQ(monitor.progress(), 1);
    EXPECT_NE(context.random().bits(3, 4), first);
}

TEST(Companions, AreMadeWithTheResultWhereNoPixelsAreCopied) {
    PipelineRun sample;
    sample.input.steps.pop_back();
    sample.addCompanion("bark_height", {48, 44});
    const Result result = sample.run();
    EXPECT_EQ(result.synthesis.image.channels(), 3);
    ASSERT_EQ(result.companions.size(), 1U);
    EXPECT_EQ(result.companions[0].size(), result.synthesis.image.size());

    const RunExemplar& exemplar = sample.input.exemplars[0];
    const std::array<ImageView, 2> channels = {*exemplar.image.image, *exemplar.companions[0].image};
    sample.input.exemplars[0].image.image = std::make_shared<const Image>(stacked(channels));
    sample.input.exemplars[0].companions.clear();
    const Image all = sample.run().synthesis.image;
    EXPECT_TRUE(samePixels(result.synthesis.image, all.view().channelRange(0, 3)));
    EXPECT_TRUE(samePixels(result.companion(0), all.view().channelRange(3, 3)));
}

/// The bark with heights and the normals that belong to them.
struct ReliefRun : SampleRun {
    explicit ReliefRun(const std::string& method) {
        input.steps.front() = {method, {}};
        const Image height(input.exemplars.front().image.image->view().channelRange(0, 1));
        WriteOptions write;
        write.depth = Depth::Bits16;
        writeImage(folder / "bark_height.png", height, write);
        writeImage(folder / "bark_normal.png", normalsFromHeight(height, 4), write);
        for (const char* name : {"bark_height.png", "bark_normal.png"})
            input.exemplars.front().companions.push_back(loadData(folder / name));
    }
    /// Of the result's normals with its heights.
    static double agreement(const Result& result) {
        return reliefOf(result.companion(0), result.companion(1), MapRole::NormalGl).agreement;
    }
    static bool saysSo(const Result& result) {
        return std::any_of(result.synthesis.notes.begin(), result.synthesis.notes.end(),
                           [](const Message& note) {
                               return note.text().find("derived from the heights") != std::string::npos;
                           });
    }
};

TEST(Companions, NormalsAgreeWithTheHeightsMadeWithThem) {
    const Result statistics = ReliefRun("heeger-bergen").run();
    EXPECT_GT(ReliefRun::agreement(statistics), 0.9);
    EXPECT_TRUE(ReliefRun::saysSo(statistics));
    // The same phases in all channels keep slopes and vectors together, so that there is nothing to mend.
    const Result phases = ReliefRun("random-phase").run();
    EXPECT_GT(ReliefRun::agreement(phases), 0.7);
    EXPECT_FALSE(ReliefRun::saysSo(phases));
}

TEST(Companions, FollowTheMapOfALastStepThatCopies) {
    PipelineRun sample;
    sample.addCompanion("bark_normal", {48, 44});
    const Result result = sample.run();
    EXPECT_TRUE(result.companions.empty());
    EXPECT_TRUE(samePixels(result.companion(0),
                           result.synthesis.map.apply(*sample.input.exemplars[0].companions[0].image)));
}

TEST(Preset, IsReadWithItsSteps) {
    const Preset preset = Preset::fromJson("a-b", R"({"title": "A", "summary": "B.", "steps": [
        {"method": "random-phase"}, {"method": "quilting", "parameters": {"patch": 20}}]})");
    EXPECT_EQ(preset.id, "a-b");
    ASSERT_EQ(preset.steps.size(), 2U);
    EXPECT_EQ(preset.steps[1].parameters, (Values{{"patch", 20}}));
}

TEST(Preset, NamesTheWrongField) {
    const auto read = [](const char* steps) {
        return [text = std::string(R"({"title": "A", "summary": "B.", "steps": )") + steps + "}"] {
            Preset::fromJson("a", text);
        };
    };
    EXPECT_THAT(read("[]"), usageRefusal("preset's steps", "at least one method"));
    EXPECT_THAT(read(R"([{"method": 3}])"), usageRefusal("preset's steps[0].method", "3", "text"));
    EXPECT_THAT(read(R"([{"method": "quilting", "parameters": {"pach": 3}}])"),
                usageRefusal("pach", "patch"));
}

TEST(Preset, PublishedOnesHoldWhatTheSourcesSay) {
    for (const auto& [method, values] : kPublished) {
        const Preset* preset = findPreset(method + "-published");
        ASSERT_TRUE(preset) << method;
        ASSERT_EQ(preset->steps.size(), 1U);
        EXPECT_EQ(preset->steps.front().method, method);
        const Values given = findMethod(method).resolved(preset->steps.front().parameters, {512, 512});
        for (const auto& [name, value] : values)
            EXPECT_EQ(given.at(name), value) << method << ": " << name;
    }
}

TEST(Preset, EveryShippedOneCanBeUsed) {
    for (const Preset& preset : presets()) {
        SampleRun sample;
        sample.input.steps = preset.steps;
        sample.input.exemplars.front() = {loadExemplar(sample.write("sand", {96, 96}, 3)), {}, {}};
        EXPECT_NO_THROW(planRun(sample.input)) << preset.id;
        EXPECT_EQ(findPreset(preset.id), &preset);
    }
}

} // namespace texloom::test

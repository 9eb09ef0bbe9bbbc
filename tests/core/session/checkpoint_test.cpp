#include "core/base/text.h"
#include "core/base/version.h"
#include "core/session/results/result_files.h"
#include "core/session/run/checkpoint_file.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

namespace texloom::test {

namespace {

struct DiffusionRun : SampleRun {
    DiffusionRun() { input.steps = {{"slow-diffusion", {{"rounds", 6}}}}; }

    Result runWith(Checkpoints checkpoints) const {
        Outcome<Result> outcome = startRun(planRun(input), false, {}, std::move(checkpoints))->take();
        return std::get<Result>(std::move(outcome));
    }
};

bool sameCurves(const std::vector<Curve>& one, const std::vector<Curve>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const Curve& a, const Curve& b) {
        return a.name == b.name && a.values == b.values;
    });
}

} // namespace

TEST(Checkpoint, ResumedFromAnyEqualsUninterrupted) {
    const DiffusionRun sample;
    std::vector<Checkpoint> kept;
    const Result whole = sample.runWith({[&](const Checkpoint& one) { kept.push_back(one); }, nullptr});
    ASSERT_EQ(kept.size(), 6U);
    for (const Checkpoint& checkpoint : kept) {
        const Result resumed = sample.runWith({{}, std::make_shared<const Checkpoint>(checkpoint)});
        EXPECT_TRUE(samePixels(resumed.synthesis.image, whole.synthesis.image));
        EXPECT_TRUE(sameCurves(resumed.synthesis.curves, whole.synthesis.curves)) << checkpoint.progress;
    }
}

TEST(Checkpoint, ResumedFromAFileHasTheCurvesOfTheWholeRun) {
    const DiffusionRun sample;
    const RunPlan plan = planRun(sample.input);
    const auto path = sample.folder / "one.checkpoint";
    int left = 4;
    const Result whole = sample.runWith({[&](const Checkpoint& one) {
                                             if (left-- > 0) // as a run that is killed then leaves it
                                                 writeCheckpoint(path, plan.recipe, one);
                                         },
                                         nullptr});
    ASSERT_EQ(whole.synthesis.curves.size(), 1U);
    const std::shared_ptr<const Checkpoint> last = resumable(readCheckpoint(path), plan);
    ASSERT_EQ(last->curves.size(), 1U);
    EXPECT_EQ(last->curves.front().values, (std::vector<double>{1, 2, 3, 4}));
    const Result resumed = sample.runWith({{}, last});
    EXPECT_TRUE(sameCurves(resumed.synthesis.curves, whole.synthesis.curves));
}

TEST(Checkpoint, OfABuildThatKeptNoCurvesStillOpens) {
    const DiffusionRun sample;
    const auto path = sample.folder / "one.checkpoint";
    writeCheckpoint(path, planRun(sample.input).recipe, {0, 0.5, "state"});
    std::string text = readText(path);
    const std::string none = R"("curves":[],)";
    ASSERT_NE(text.find(none), std::string::npos);
    writeText(path, text.erase(text.find(none), none.size()));
    const CheckpointFile file = readCheckpoint(path);
    EXPECT_TRUE(file.checkpoint.curves.empty());
    EXPECT_EQ(file.checkpoint.state, "state");
}

TEST(Checkpoint, ComesBackFromItsFileWithItsRecipe) {
    const DiffusionRun sample;
    const RunPlan plan = planRun(sample.input);
    const std::vector<Curve> curves = {{message("Energy at scale {}", 2), {1.0 / 3, -0.0, 1e300}},
                                       {TR("Round"), {}}};
    const Checkpoint checkpoint{2, 0.25, std::string("\0\n{}\xff", 5), curves};
    const auto path = sample.folder / "one.checkpoint";
    writeCheckpoint(path, plan.recipe, checkpoint);
    const CheckpointFile file = readCheckpoint(path);
    EXPECT_EQ(file.version, kVersion);
    EXPECT_EQ(file.checkpoint.step, 2U);
    EXPECT_EQ(file.checkpoint.progress, 0.25);
    EXPECT_EQ(file.checkpoint.state, checkpoint.state);
    EXPECT_TRUE(sameCurves(file.checkpoint.curves, curves));
    EXPECT_EQ(resumable(file, plan)->state, checkpoint.state);
}

TEST(Checkpoint, OfAnotherBuildOrRunIsRefused) {
    DiffusionRun sample;
    const auto path = sample.folder / "one.checkpoint";
    writeCheckpoint(path, planRun(sample.input).recipe, {0, 0.5, "state"});
    CheckpointFile file = readCheckpoint(path);
    sample.input.seed = 99;
    EXPECT_THAT([&] { resumable(file, planRun(sample.input)); }, usageRefusal("other settings"));
    file.version = "0.0.1";
    EXPECT_THAT([&] { resumable(file, planRun(sample.input)); }, usageRefusal("0.0.1", kVersion));
}

TEST(Checkpoint, DamagedInAnyByteIsRefused) {
    const DiffusionRun sample;
    const auto path = sample.folder / "one.checkpoint";
    writeCheckpoint(path, planRun(sample.input).recipe, {0, 0.5, "state"});
    const std::string whole = readText(path);
    for (const std::size_t length : {std::size_t{0}, std::size_t{1}, whole.size() / 2, whole.size() - 1}) {
        writeText(path, whole.substr(0, length));
        EXPECT_THAT([&] { readCheckpoint(path); }, usageRefusal("one.checkpoint")) << length;
    }
    std::string flipped = whole;
    flipped.back() = '!';
    writeText(path, flipped);
    EXPECT_THAT([&] { readCheckpoint(path); }, usageRefusal("damaged"));
}

TEST(StoppedEarly, KeepsThePictureTheMapAndHowFarItCame) {
    SampleRun sample;
    sample.input.size = {900, 700};
    auto job = startRun(planRun(sample.input), false);
    job->stopAndKeep();
    const Result result = std::get<Result>(job->take());
    ASSERT_TRUE(result.stoppedAt);
    EXPECT_LT(*result.stoppedAt, 1);
    EXPECT_EQ(result.synthesis.image.size(), sample.input.size);
    EXPECT_EQ(result.synthesis.mapKind, MapKind::Exact);
    EXPECT_TRUE(samePixels(result.synthesis.map.apply(*sample.input.exemplars.front().image.image),
                           result.synthesis.image));
}

TEST(StoppedEarly, ComesBackFromTheStoreAsStopped) {
    SampleRun sample;
    sample.input.size = {900, 700};
    auto job = startRun(planRun(sample.input), false);
    job->stopAndKeep();
    const Result result = std::get<Result>(job->take());
    const ResultFolder folder(sample.folder / "results");
    const ResultEntry entry = entryFor(result, false);
    folder.write(entry, result);
    const auto scan = folder.scan();
    ASSERT_EQ(scan.entries.size(), 1U);
    EXPECT_EQ(scan.entries.front().stoppedAt, result.stoppedAt);
    EXPECT_EQ(folder.read(scan.entries.front()).result->stoppedAt, result.stoppedAt);
}

TEST(LiveCurves, AreSeenWhileTheRunGoesAndStandInTheResult) {
    DiffusionRun sample;
    sample.input.steps.front().parameters["pause"] = 20;
    auto job = startRun(planRun(sample.input), false);
    std::size_t seen = 0;
    while (!job->finished())
        if (const auto curves = job->monitor().curves(); !curves.empty() && !job->finished())
            seen = std::max(seen, curves.front().values.size());
    const Result result = std::get<Result>(job->take());
    EXPECT_GT(seen, 0U);
    ASSERT_EQ(result.synthesis.curves.size(), 1U);
    EXPECT_EQ(result.synthesis.curves.front().values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

} // namespace texloom::test

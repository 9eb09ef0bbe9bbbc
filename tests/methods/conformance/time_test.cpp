// How a run is watched, cancelled and stopped.

#include "core/job/job.h"
#include "tests/methods/conformance/fixture.h"
#include "tests/methods/made_up_ports.h"
#include "tests/support/time_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace texloom::test {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

TEST_P(Conformance, cancelAnswersAtOnce) {
    const RunPlan plan = longPlan(method());
    const auto timeToCancel = [&]() -> std::chrono::nanoseconds {
        const auto job = startRun(plan, false);
        const auto begun = Clock::now();
        while (job->monitor().progress() < 0.02 && !job->finished() && Clock::now() - begun < 3s)
            std::this_thread::sleep_for(1ms);
        const Stopwatch asked;
        job->cancel();
        EXPECT_TRUE(std::holds_alternative<Cancelled>(job->take()));
        return asked.alone();
    };
    const auto limit = limitNow(method().info().cancelsWithin);
    if (!limit)
        GTEST_SKIP() << kTooBusy;
    EXPECT_LE(shortest(*limit, timeToCancel), *limit) << "until the job had ended";
}

TEST_P(Conformance, progressNeverFallsAndEndsAtOne) {
    Request request = requestFor({64, 64}, 3, reduced({256, 256}));
    fillPorts(method().info(), request);
    const auto job = startRun(planFor(method(), request, briefSettings(method(), request)), false);
    double last = 0;
    while (!job->finished()) {
        const double now = job->monitor().progress();
        EXPECT_GE(now, last);
        last = now;
        std::this_thread::yield();
    }
    EXPECT_EQ(job->monitor().progress(), 1);
    EXPECT_FALSE(job->monitor().stageTimes().empty());
    for (const StageTime& stage : job->monitor().stageTimes())
        EXPECT_FALSE(stage.name.empty());
    EXPECT_TRUE(std::holds_alternative<Result>(job->take()));
}

TEST_P(Conformance, stagesMakeUpTheWhole) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
        Request request = requestFor({48, 40}, 3, {101, 90});
        if (method().info().canWrap())
            request.wrap = wrap;
        fillPorts(method().info(), request);
        const RunPlan plan = planFor(method(), request, briefSettings(method(), request));
        JobMonitor monitor;
        JobContext context(
            {request.seed, 2, false}, [] { return false; }, monitor);
        context.step(0, 0.5); // half of a run, so that more than the whole would show, too
        method().run(plan.requestFor(0, method().info()), plan.steps.front().settings, context);
        context.stage(0, "what follows");
        EXPECT_NEAR(monitor.progress(), 0.5, 1e-6) << "half the sum of the stages' weights";
    }
}

/// Whether previews of a run come as often as they should.
bool previewsCome(const RunPlan& plan) {
    const auto job = startRun(plan, true);
    int previews = 0;
    const auto start = Clock::now();
    while (previews < 3 && !job->finished()) {
        if (const auto preview = job->monitor().takePreview()) {
            ++previews;
            EXPECT_EQ((preview->fullSize.width + preview->step - 1) / preview->step, preview->image.width());
        }
        std::this_thread::sleep_for(5ms);
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    // Previews may take a fiftieth of the time, so that a short run has few.
    return previews >= std::min(3, static_cast<int>(seconds / 2));
}

TEST_P(Conformance, previewsComeWhileItRuns) {
    const RunPlan plan = longPlan(method());
    bool often = false;
    // Who takes a core while a preview is made puts off the next one by fifty times as long.
    for (int attempt = 0; attempt < 3 && !often; ++attempt)
        often = previewsCome(plan);
    EXPECT_TRUE(often) << "fewer than three, or than one in two seconds, before the job ended";
}

TEST_P(Conformance, stopsEarlyWithWhatItHas) {
    // What has been learned until then still makes a picture of the whole size.
    const RunPlan plan = longPlan(method(), reduced({1024, 1024}));
    const auto job = startRun(plan, false);
    job->stopAndKeep();
    const Outcome<Result> outcome = job->take();
    ASSERT_TRUE(std::holds_alternative<Result>(outcome)) << "stopping early is not a failure";
    const auto& result = std::get<Result>(outcome);
    EXPECT_EQ(result.synthesis.image.channels(), plan.resultChannels());
    EXPECT_EQ(result.synthesis.image.size(), plan.request.size);
    // What takes longer stops when it is told to.
    EXPECT_TRUE(result.stoppedAt || result.seconds < 1);
    EXPECT_LT(result.stoppedAt.value_or(0), 1);
}

} // namespace
} // namespace texloom::test

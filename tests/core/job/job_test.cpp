#include "core/base/error.h"
#include "core/job/job.h"
#include "tests/support/says.h"
#include "tests/support/textures.h"
#include "tests/support/time_limit.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <latch>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace texloom::test {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// A promise of the design.
constexpr auto kCancelLimit = 100ms;

void work(std::chrono::microseconds time) {
    const auto end = Clock::now() + time;
    while (Clock::now() < end) {}
}

/// A context without a job around it.
struct Bench {
    explicit Bench(int threads, bool previews = false)
        : context(
              {.seed = 1, .threads = threads, .previews = previews}, [] { return false; }, monitor) {}
    JobMonitor monitor;
    JobContext context;
};

/// How long a job takes to end after it was cancelled in the midst of `body`.
template <class Body> std::chrono::nanoseconds timeToCancel(Body body) {
    std::latch started(1);
    std::atomic_flag once;
    Job<int> job({.threads = 2}, [&](JobContext& context) {
        body(context, [&] {
            if (!once.test_and_set())
                started.count_down();
        });
        return 0;
    });
    started.wait();
    const auto asked = Clock::now();
    job.cancel();
    EXPECT_TRUE(std::holds_alternative<Cancelled>(job.take()));
    return Clock::now() - asked;
}

template <class Body> void expectToCancelInTime(Body body) {
    const auto limit = limitNow(kCancelLimit);
    if (!limit)
        GTEST_SKIP() << kTooBusy;
    EXPECT_LT(shortest(*limit, [&] { return timeToCancel(body); }), *limit);
}

Failure failureOf(const std::function<int(JobContext&)>& body) {
    Job<int> job({}, body);
    const Outcome<int> outcome = job.take();
    const auto* failure = std::get_if<Failure>(&outcome);
    return failure ? *failure : Failure{"(no failure)", false};
}

} // namespace

TEST(JobContext, ProgressNeverFalls) {
    Bench bench(1);
    double last = 0;
    const auto expectNoFall = [&] {
        EXPECT_GE(bench.monitor.progress(), last);
        last = bench.monitor.progress();
        EXPECT_LE(last, 1);
    };
    for (const double weight : {0.2, 0.5, 0.6}) {
        bench.context.stage(weight, "part");
        expectNoFall();
        for (const double fraction : {0.1, 0.5, 0.2, -1.0, 0.9, 7.0, 0.0}) {
            bench.context.progress(fraction);
            expectNoFall();
        }
    }
}

TEST(JobContext, ProgressAddsTheStages) {
    Bench bench(1);
    bench.context.stage(0.25, "first");
    bench.context.progress(0.5);
    EXPECT_DOUBLE_EQ(bench.monitor.progress(), 0.125);
    bench.context.stage(0.75, "second");
    EXPECT_DOUBLE_EQ(bench.monitor.progress(), 0.25);
    bench.context.progress(0.5);
    EXPECT_DOUBLE_EQ(bench.monitor.progress(), 0.625);
}

TEST(JobContext, NamesTheStage) {
    Bench bench(1);
    EXPECT_EQ(bench.monitor.stage(), Message());
    bench.context.stage(0.5, "first");
    bench.context.stage(0.5, "second");
    EXPECT_EQ(bench.monitor.stage(), "second");
}

TEST(JobContext, TimesEachStage) {
    Bench bench(1);
    bench.context.stage(0.5, "first");
    work(20ms);
    bench.context.stage(0.5, "second");
    const std::vector<StageTime> stages = bench.context.stageTimes();
    ASSERT_EQ(stages.size(), 2U);
    EXPECT_EQ(stages[0].name, "first");
    EXPECT_GE(stages[0].seconds, 0.02);
    EXPECT_LT(stages[1].seconds, stages[0].seconds);
}

TEST(Job, ProgressEndsAtOne) {
    Job<int> job({}, [](JobContext& context) {
        context.stage(0.3, "only");
        return 4;
    });
    EXPECT_EQ(std::get<int>(job.take()), 4);
    EXPECT_EQ(job.monitor().progress(), 1);
}

TEST(Job, CancelEndsALoopInTime) {
    expectToCancelInTime([](JobContext& context, const auto& started) {
        for (;;) {
            started();
            context.check();
        }
    });
}

TEST(Job, CancelEndsParallelWorkInTime) {
    expectToCancelInTime([](JobContext& context, const auto& started) {
        context.parallel(0, 1000000, [&](int) {
            started();
            work(1ms);
        });
    });
}

TEST(Job, CancelEndsOrderedWorkInTime) {
    expectToCancelInTime([](JobContext& context, const auto& started) {
        const auto before = [](int i) { return i == 0 ? std::vector<int>{} : std::vector<int>{i - 1}; };
        context.parallelAfter(
            100000, before,
            [&](int) {
                started();
                work(1ms);
            },
            [](int) {});
    });
}

TEST(Job, DestroyingItCancelsAndJoins) {
    std::atomic<bool> left = false;
    {
        std::latch started(1);
        const Job<int> job({}, [&](JobContext& context) {
            struct AtEnd {
                std::atomic<bool>& flag;
                ~AtEnd() {
                    work(10ms);
                    flag = true;
                }
            } const atEnd{left};
            started.count_down();
            for (;;)
                context.check();
            return 0;
        });
        started.wait();
    }
    EXPECT_TRUE(left);
}

TEST(Job, AnErrorBecomesAFailureWithItsSentence) {
    const Failure failure = failureOf([](JobContext&) -> int { throw Error("The patch is too large."); });
    EXPECT_EQ(failure.message, "The patch is too large.");
    EXPECT_FALSE(failure.usage);
}

TEST(Job, AUsageErrorBecomesAFailureOfUsage) {
    const Failure failure = failureOf([](JobContext&) -> int { throw UsageError("There is no such axis."); });
    EXPECT_EQ(failure.message, "There is no such axis.");
    EXPECT_TRUE(failure.usage);
}

TEST(Job, MissingMemoryBecomesAFailureThatAdvises) {
    const Failure failure = failureOf([](JobContext&) -> int { throw std::bad_alloc(); });
    EXPECT_THAT(failure.message, says("not enough memory"));
    EXPECT_THAT(failure.message, says("smaller"));
}

TEST(Job, AnythingElseThrownBecomesAFailure) {
    const Failure failure =
        failureOf([](JobContext&) -> int { throw 7; }); // NOLINT(hicpp-exception-baseclass)
    EXPECT_FALSE(failure.message.empty());
    EXPECT_FALSE(failure.usage);
}

TEST(Job, AnErrorInParallelWorkBecomesAFailure) {
    const Failure failure = failureOf([](JobContext& context) {
        context.parallel(0, 100, [](int i) {
            if (i == 57)
                throw Error("Row 57 is broken.");
        });
        return 0;
    });
    EXPECT_EQ(failure.message, "Row 57 is broken.");
}

TEST(Job, AnErrorInParallelWorkStopsTheOtherThreads) {
    constexpr int kCount = 100000;
    std::atomic<int> done = 0;
    Job<int> job({0, 4, false}, [&](JobContext& context) {
        context.parallel(0, kCount, [&](int i) {
            if (i == kCount / 20)
                throw Error("A row is broken.");
            work(10us);
            ++done;
        });
        return 0;
    });
    EXPECT_TRUE(std::holds_alternative<Failure>(job.take()));
    EXPECT_LT(done, kCount / 2);
}

TEST(Job, AnErrorInOrderedWorkBecomesAFailure) {
    const Failure failure = failureOf([](JobContext& context) {
        context.parallelAfter(
            100, [](int) { return std::vector<int>{}; },
            [](int i) {
                if (i == 57)
                    throw Error("Patch 57 is broken.");
            },
            [](int) {});
        return 0;
    });
    EXPECT_EQ(failure.message, "Patch 57 is broken.");
}

TEST(Job, TellsOnceThatTheOutcomeIsThere) {
    std::atomic<int> told = 0;
    std::promise<JobRunner*> self;
    std::promise<bool> finished;
    Job<int> job(
        {}, [](JobContext&) { return 1; },
        [&] {
            ++told;
            finished.set_value(self.get_future().get()->finished());
        });
    self.set_value(&job);
    EXPECT_TRUE(finished.get_future().get());
    job.take();
    EXPECT_EQ(told, 1);
}

class JobThreads : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Job, JobThreads, ::testing::Values(1, 2, 7));

TEST_P(JobThreads, ParallelCoversEachIndexOnce) {
    Bench bench(GetParam());
    std::vector<std::atomic<int>> seen(1000);
    bench.context.parallel(-400, 600, [&](int i) { ++seen[static_cast<std::size_t>(i + 400)]; });
    for (const std::atomic<int>& count : seen)
        EXPECT_EQ(count, 1);
}

TEST_P(JobThreads, ParallelOverNothingDoesNothing) {
    Bench bench(GetParam());
    bench.context.parallel(5, 5, [](int) { ADD_FAILURE(); });
}

TEST_P(JobThreads, OrderedWorkKeepsToItsOrder) {
    for (int graph = 0; graph < 20; ++graph) {
        const Random random(static_cast<std::uint64_t>(graph));
        constexpr int kCount = 300;
        std::vector<std::vector<int>> before(kCount);
        for (int i = 1; i < kCount; ++i)
            for (std::uint32_t n = random.below(5, i, 0); n > 0; --n) {
                const int earlier = static_cast<int>(random.below(static_cast<std::uint32_t>(i), i, 1, n));
                std::vector<int>& list = before[static_cast<std::size_t>(i)];
                if (std::find(list.begin(), list.end(), earlier) == list.end())
                    list.push_back(earlier);
            }
        std::vector<std::atomic<int>> done(kCount);
        std::atomic<int> tooEarly = 0;
        Bench bench(GetParam());
        bench.context.parallelAfter(
            kCount, [&](int i) { return before[static_cast<std::size_t>(i)]; },
            [&](int i) {
                for (const int earlier : before[static_cast<std::size_t>(i)])
                    tooEarly += done[static_cast<std::size_t>(earlier)] == 0 ? 1 : 0;
                ++done[static_cast<std::size_t>(i)];
            },
            [](int) {});
        EXPECT_EQ(tooEarly, 0);
        for (const std::atomic<int>& count : done)
            ASSERT_EQ(count, 1);
    }
}

TEST_P(JobThreads, NothingRunsBetween) {
    Bench bench(GetParam());
    std::atomic<int> running = 0, overlaps = 0, moments = 0;
    int last = 0;
    bench.context.parallelAfter(
        300, [](int i) { return i < 3 ? std::vector<int>{} : std::vector<int>{i - 3}; },
        [&](int) {
            ++running;
            work(1ms);
            --running;
        },
        [&](int done) {
            overlaps += running == 0 ? 0 : 1;
            ++moments;
            EXPECT_GE(done, last);
            last = done;
        });
    EXPECT_EQ(overlaps, 0);
    EXPECT_GE(moments, 2);
    EXPECT_EQ(last, 300);
}

TEST_P(JobThreads, RunsNoMoreBodiesAtOnceThanThreads) {
    Bench bench(GetParam());
    std::atomic<int> running = 0, most = 0;
    bench.context.parallel(0, 400, [&](int) {
        const int now = ++running;
        int seen = most;
        while (seen < now && !most.compare_exchange_weak(seen, now)) {}
        work(100us);
        --running;
    });
    EXPECT_LE(most, GetParam());
}

TEST(JobContext, OrderedWorkOverNothingDoesNothing) {
    Bench bench(2);
    bench.context.parallelAfter(
        0, [](int) { return std::vector<int>{}; }, [](int) { ADD_FAILURE(); }, [](int) {});
}

TEST(JobContext, TakesUpTheCurvesOfTheCheckpointOnce) {
    const Message energy("Energy");
    JobMonitor before;
    std::shared_ptr<const Checkpoint> kept;
    JobContext broken(
        {.keep = [&](const Checkpoint& one) { kept = std::make_shared<const Checkpoint>(one); }},
        [] { return false; }, before);
    broken.step(1, 1);
    broken.curve(energy, 8);
    broken.curve(energy, 4);
    broken.checkpoint(0ms, [] { return "half"; });
    broken.curve(energy, 2); // after the last checkpoint: lost

    JobMonitor after;
    int again = 0;
    JobContext context(
        {.keep = [&](const Checkpoint&) { ++again; }, .resumed = kept}, [] { return false; }, after);
    context.step(0, 0.5); // ended before the checkpoint; it is made again
    EXPECT_EQ(context.resumed(), nullptr);
    context.checkpoint(0ms, [] { return "less than half"; });
    EXPECT_EQ(again, 0) << "the later one is kept";
    context.curve(energy, 99);
    context.step(1, 0.5);
    context.curve(energy, 8); // of what is done again before the work is taken up
    ASSERT_NE(context.resumed(), nullptr);
    EXPECT_EQ(*context.resumed(), "half");
    context.curve(energy, 2);
    EXPECT_EQ(*context.resumed(), "half");
    ASSERT_EQ(context.curves().size(), 1U);
    EXPECT_EQ(context.curves().front().values, (std::vector<double>{8, 4, 2}));
    context.checkpoint(0ms, [] { return "more than half"; });
    EXPECT_EQ(again, 1);
}

TEST(JobContext, ShowsNoPreviewWhenNobodyLooks) {
    Bench bench(1, false);
    bench.context.preview(noise({8, 8}, 1));
    EXPECT_FALSE(bench.monitor.takePreview());
}

TEST(JobContext, PreviewHoldsEveryStepThPixel) {
    Bench bench(1, true);
    const Image image = noise({2000, 90}, 2);
    bench.context.preview(image);
    const std::optional<Preview> preview = bench.monitor.takePreview();
    ASSERT_TRUE(preview);
    EXPECT_EQ(preview->fullSize, image.size());
    EXPECT_EQ(preview->image.size(),
              (Size{(2000 + preview->step - 1) / preview->step, (90 + preview->step - 1) / preview->step}));
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < preview->image.height(); ++y)
            for (int x = 0; x < preview->image.width(); ++x)
                ASSERT_EQ(preview->image(x, y, c), image(x * preview->step, y * preview->step, c));
}

TEST(JobContext, PreviewsPauseBetween) {
    Bench bench(1, true);
    const Image image = noise({8, 8}, 1);
    bench.context.preview(image);
    bench.monitor.takePreview();
    bench.context.preview(image);
    EXPECT_FALSE(bench.monitor.takePreview());
}

TEST(Latest, KeepsTheNewest) {
    Latest<int> latest;
    latest.put(1);
    latest.put(2);
    EXPECT_EQ(latest.take(), 2);
}

TEST(Latest, GivesEachValueOnce) {
    Latest<int> latest;
    EXPECT_EQ(latest.take(), std::nullopt);
    latest.put(1);
    EXPECT_TRUE(latest.waiting());
    latest.take();
    EXPECT_FALSE(latest.waiting());
    EXPECT_EQ(latest.take(), std::nullopt);
}

TEST(Latest, HandsValuesBetweenThreadsInOrder) {
    Latest<int> latest;
    constexpr int kLast = 20000;
    std::thread writer([&] {
        for (int i = 1; i <= kLast; ++i)
            latest.put(i);
    });
    int newest = 0;
    while (newest < kLast)
        if (const std::optional<int> value = latest.take()) {
            ASSERT_GT(*value, newest);
            newest = *value;
        }
    writer.join();
}

} // namespace texloom::test

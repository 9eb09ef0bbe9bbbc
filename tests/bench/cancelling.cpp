#include "core/job/job.h"
#include "tests/methods/conformance/fixture.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace texloom::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

/// How long a run of 4096² takes to end once it is told to, at moments all over its first seconds. What is
/// promised is in MethodInfo::cancelsWithin.
void answer(benchmark::State& state, const Method& method) {
    constexpr int kMoments = 24;
    constexpr std::chrono::milliseconds kApart{113};
    const RunPlan plan = test::longPlan(method);
    std::vector<double> answers;
    for (auto _ : state) {
        answers.clear();
        for (int moment = 0; moment < kMoments; ++moment) {
            const auto job = startRun(plan, false);
            std::this_thread::sleep_for(moment * kApart);
            const auto asked = Clock::now();
            job->cancel();
            static_cast<void>(job->take());
            answers.push_back(Milliseconds(Clock::now() - asked).count());
        }
    }
    std::sort(answers.begin(), answers.end());
    state.counters["median [ms]"] = answers[answers.size() / 2];
    state.counters["longest [ms]"] = answers.back();
    state.counters["promised [ms]"] = static_cast<double>(method.info().cancelsWithin.count());
}

} // namespace
} // namespace texloom::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    for (const texloom::Method& method : texloom::methods())
        benchmark::RegisterBenchmark(
            method.id().c_str(),
            [&method](benchmark::State& state) { texloom::bench::answer(state, method); })
            ->Iterations(1)
            ->Unit(benchmark::kSecond)
            ->UseRealTime();
    benchmark::RunSpecifiedBenchmarks();
}

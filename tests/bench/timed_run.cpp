#include "tests/bench/timed_run.h"

#include "core/job/job.h"

#include <chrono>
#include <thread>
#include <variant>

namespace texloom::bench {

void timeRun(benchmark::State& state, const std::string& id, const Request& request) {
    using Clock = std::chrono::steady_clock;
    const Method& method = findMethod(id);
    const Values settings = method.resolved({}, request.exemplars.front().image->size());
    double first = 0;
    for (auto _ : state) {
        const Clock::time_point begin = Clock::now();
        method.check(request, settings);
        Job<Synthesis> job({request.seed, 2, true},
                           [&](JobContext& context) { return method.run(request, settings, context); });
        while (!job.finished() && !job.monitor().takePreview())
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        first = std::chrono::duration<double>(Clock::now() - begin).count();
        Outcome<Synthesis> outcome = job.take();
        if (const auto* failure = std::get_if<Failure>(&outcome))
            state.SkipWithError(failure->message.text().c_str());
    }
    state.counters["first preview [s]"] = first;
}

} // namespace texloom::bench

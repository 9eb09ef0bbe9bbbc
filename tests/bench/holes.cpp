#include "core/job/job.h"
#include "core/methods/fill_request.h"
#include "core/methods/method.h"
#include "tests/support/textures.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <variant>

namespace texloom::bench {
namespace {

/// A picture of 1024² with a hole of 128² in its middle, which is filled from the picture itself.
Request pierced() {
    constexpr Size kPicture{1024, 1024};
    Image known = test::constant(kPicture, 1, 1);
    for (int y = 448; y < 576; ++y)
        for (int x = 448; x < 576; ++x)
            known(x, y, 0) = 0;
    Request request;
    request.exemplars.push_back({"blobs", std::make_shared<const Image>(test::blobs(kPicture, 3)), {}});
    request.size = kPicture;
    request.seed = 3;
    request.inputs.set(kInitialPort, request.exemplars.front().image);
    request.inputs.set(kKnownPort, std::make_shared<const Image>(std::move(known)));
    return request;
}

/// The goals are 2 s for all, and 0.3 s to the first preview.
void fillHole(benchmark::State& state, const std::string& id) {
    using Clock = std::chrono::steady_clock;
    const Request request = pierced();
    const Method& method = findMethod(id);
    const Values settings = method.resolved({}, request.size);
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
BENCHMARK_CAPTURE(fillHole, patchmatch, "patchmatch")->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(fillHole, quilting, "quilting")->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(fillHole, efrosLeung, "efros-leung")->Unit(benchmark::kSecond)->UseRealTime();

} // namespace
} // namespace texloom::bench

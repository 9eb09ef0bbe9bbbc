#include "core/job/job.h"
#include "core/methods/method.h"
#include "tests/support/textures.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <utility>
#include <variant>

namespace texloom::bench {
namespace {

/// A whole run of a method on two threads, as a job. @param exemplar, output sides in pixels.
void run(benchmark::State& state, const std::string& id, int exemplar, int output, const Values& some) {
    Request request;
    request.exemplars.push_back(
        {"blobs", std::make_shared<const Image>(test::blobs({exemplar, exemplar}, 3)), {}});
    request.size = {output, output};
    request.seed = 3;
    const Method& method = findMethod(id);
    const Values settings = method.resolved(some, {exemplar, exemplar});
    method.check(request, settings);
    for (auto _ : state) {
        Job<Synthesis> job({request.seed, 2, false},
                           [&](JobContext& context) { return method.run(request, settings, context); });
        Outcome<Synthesis> outcome = job.take();
        if (const auto* failure = std::get_if<Failure>(&outcome))
            state.SkipWithError(failure->message.text().c_str());
        benchmark::DoNotOptimize(outcome);
    }
    state.counters["Mpx/s"] = benchmark::Counter(static_cast<double>(request.size.area()) * 1e-6,
                                                 benchmark::Counter::kIsIterationInvariantRate);
}

Values with(const std::string& name, const std::string& choice) {
    return {{name, choice}};
}

/// 4096² from 1024². The goal is 6 s for mosaics and low frequencies, 2 s for anamorphoses.
BENCHMARK_CAPTURE(run, mosaicInBothDirections, "random-mosaic", 1024, 4096, with("pieces", "both"))
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(run, chaosMosaic, "random-mosaic", 1024, 4096, with("pieces", "chaos"))
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(run, lowFrequency, "low-frequency", 1024, 4096, Values{})
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(run, anamorphosis, "anamorphosis", 1024, 4096, Values{})
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(run, turbulence, "anamorphosis", 1024, 4096, with("kind", "turbulence"))
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
/// Set and tiling together.
BENCHMARK_CAPTURE(run, wangTiles, "wang-tiles", 256, 4096, Values{})->Unit(benchmark::kSecond)->UseRealTime();
/// The goals are 3.4 s of processor time from 128² to 512², and 20 s from 256² to 1024².
BENCHMARK_CAPTURE(run, graphCut512, "graph-cut", 128, 512, Values{})->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(run, graphCut1024, "graph-cut", 256, 1024, Values{})
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

} // namespace
} // namespace texloom::bench

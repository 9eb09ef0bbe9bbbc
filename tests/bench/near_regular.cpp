#include "core/analysis/lattice_detector.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "tests/support/lattices.h"

#include <benchmark/benchmark.h>

namespace texloom::bench {
namespace {

Image tiles(int side) {
    return test::regularTexture({side, side}, 3, {{21.3, 0}, {0, 17.6}}, {0.02, 0.3, 0}, 1);
}

/// Argument: the exemplar's side.
void latticeOfOneExemplar(benchmark::State& state) {
    const Image exemplar = tiles(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(analyzeLattice(exemplar));
}
BENCHMARK(latticeOfOneExemplar)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);

/// Arguments: exemplar's side, output's side, threads.
void nearRegular(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0)), output = static_cast<int>(state.range(1));
    Request request;
    request.exemplars.push_back({"tiles", std::make_shared<const Image>(tiles(side))});
    request.size = {output, output};
    const Method& method = findMethod("near-regular");
    const Values settings = method.resolved({}, {side, side});
    for (auto _ : state) {
        Job<Synthesis> job({1, static_cast<int>(state.range(2)), false},
                           [&](JobContext& context) { return method.run(request, settings, context); });
        benchmark::DoNotOptimize(job.take());
    }
}
BENCHMARK(nearRegular)
    ->Args({128, 256, 1})
    ->Args({128, 256, 2})
    ->Args({512, 2048, 2})
    ->Args({512, 4096, 2})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texloom::bench

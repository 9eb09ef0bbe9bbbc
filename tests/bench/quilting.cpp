#include "core/job/job.h"
#include "core/methods/method.h"
#include "tests/support/textures.h"

#include <benchmark/benchmark.h>

namespace texloom::bench {
namespace {

/// Arguments: exemplar's side, output's side, patch, threads, whether previews are asked for.
void quilting(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0)), output = static_cast<int>(state.range(1));
    Request request;
    request.exemplars.push_back({"blobs", std::make_shared<const Image>(test::blobs({side, side}, 3)), {}});
    request.size = {output, output};
    const Method& method = findMethod("quilting");
    const Values settings = method.resolved({{"patch", static_cast<int>(state.range(2))}}, {side, side});
    for (auto _ : state) {
        Job<Synthesis> job({1, static_cast<int>(state.range(3)), state.range(4) != 0},
                           [&](JobContext& context) { return method.run(request, settings, context); });
        benchmark::DoNotOptimize(job.take());
    }
}
BENCHMARK(quilting)
    ->Args({128, 512, 32, 1, 0})
    ->Args({256, 1024, 40, 1, 0})
    ->Args({256, 1024, 40, 2, 0})
    ->Args({512, 4096, 64, 2, 0})
    ->Args({512, 4096, 64, 2, 1})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texloom::bench

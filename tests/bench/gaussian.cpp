#include "core/methods/conditional_gaussian/conditional_patch.h"
#include "tests/support/textures.h"

#include <benchmark/benchmark.h>

namespace texloom::bench {
namespace {

/// Arguments: patch n, neighbours m. The cost grows as m²n².
void conditionOnePatch(benchmark::State& state) {
    const int patch = static_cast<int>(state.range(0)), half = patch / 2;
    const Image source = test::noise({256, 256}, 3);
    std::vector<ImageView> patches;
    for (int i = 0; i < state.range(1); ++i)
        patches.push_back(source.view().crop(i, 2 * i % 100, {patch, patch}));
    const Image known(source.view().crop(100, 100, {patch, patch}));
    Image fresh({patch, patch}, 3);
    for (auto _ : state)
        conditional_gaussian::conditionPatch(patches, known, {half, half, 0, 0}, {.sigma = 0.01}, {}, fresh);
}
BENCHMARK(conditionOnePatch)->ArgsProduct({{20, 40, 80}, {10, 30, 100}})->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace texloom::bench

#include "core/match/patch_columns.h"
#include "core/math/matching_pursuit.h"
#include "tests/bench/timed_run.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

namespace texloom::bench {
namespace {

constexpr int kPatch = 12, kAtoms = 384, kChannels = 3;

/// The patches of an output of so many pixels a side, and a dictionary of patches.
struct Work {
    explicit Work(int side)
        : image(test::blobs({side, side}, kChannels)), grid({side, side}, {}, kPatch, kPatch / 2),
          dictionary(grid.length(kChannels), kAtoms) {
        const Image other = test::blobs({256, 256}, kChannels, 2);
        const PatchColumns patches({256, 256}, {true, true}, kPatch, kPatch);
        patches.of(other).read(0, dictionary);
        dictionary.colwise().normalize();
    }
    Image image;
    PatchColumns grid;
    Eigen::MatrixXf dictionary;
};

template <class Body> void inJob(const Body& body) {
    JobMonitor monitor;
    JobContext context(
        {3, 2, false}, [] { return false; }, monitor);
    context.stage(1, "measuring");
    body(context);
}

/// The bare product DᵀP: the floor to compare pursuits with. Argument: side of the output.
void productOfAtomsAndPatches(benchmark::State& state) {
    const Work work(static_cast<int>(state.range(0)));
    inJob([&](JobContext& context) {
        for (auto _ : state)
            benchmark::DoNotOptimize(correlations(work.dictionary, work.grid.of(work.image), context));
    });
}
BENCHMARK(productOfAtomsAndPatches)
    ->Arg(128)
    ->Arg(256)
    ->Arg(512)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Arguments: side of the output; whether uses are limited so that every atom is used up.
void pursuitOfAllPatches(benchmark::State& state) {
    const Work work(static_cast<int>(state.range(0)));
    PursuitLimits limits{4, {}};
    if (state.range(1) != 0)
        limits.uses.assign(kAtoms, 4 * work.grid.count() / kAtoms + 1);
    inJob([&](JobContext& context) {
        for (auto _ : state)
            benchmark::DoNotOptimize(
                constrainedPursuit(work.dictionary, work.grid.of(work.image), limits, context));
    });
}
BENCHMARK(pursuitOfAllPatches)
    ->ArgsProduct({{128, 256, 512}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Arguments: sides of exemplar and output. The goals are 30 s for 128 px, 180 s for 256 to 512 px, and 2 s
/// to the first preview.
void sparseSynthesis(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0)), output = static_cast<int>(state.range(1));
    timeRun(state, "sparse", test::requestOf(test::blobs({side, side}, kChannels), {output, output}, {}, 1));
}
BENCHMARK(sparseSynthesis)
    ->Args({128, 128})
    ->Args({256, 512})
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

} // namespace
} // namespace texloom::bench

#include "core/match/boundary_cut.h"
#include "core/match/patch_distances.h"
#include "core/math/fft.h"
#include "core/math/poisson.h"
#include "tests/support/textures.h"

#include <benchmark/benchmark.h>

namespace texloom::bench {
namespace {

using test::noise;

/// The bare transforms that one search of a three-channel exemplar needs in full: the floor to compare
/// searches with.
void transformsOfOneSearch(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    const RealFft2d fft({side, side});
    FftBuffer<float> image(fft.imageSize());
    std::fill_n(image.data(), image.size(), 0.5F);
    FftBuffer<std::complex<float>> spectrum(fft.spectrumSize());
    for (auto _ : state) {
        for (int channel = 0; channel < 3; ++channel) {
            fft.forwardRows(image.data(), side, spectrum.data(), [] {});
            fft.forwardColumns(spectrum.data(), 0, fft.columns());
            fft.backwardColumns(spectrum.data(), 0, fft.columns());
            fft.backwardRows(spectrum.data(), side, image.data(), [] {});
        }
    }
}
BENCHMARK(transformsOfOneSearch)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMicrosecond);

/// Arguments: exemplar's side, patch.
void searchOfOnePatch(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0)), patch = static_cast<int>(state.range(1));
    const Image exemplar = noise({side, side}, 3);
    const Image known(exemplar.view().crop(1, 1, {patch, patch}));
    PatchDistances distances(exemplar, {}, channelMeans(exemplar), patch);
    const Overlap overlap{patch / 4, patch / 4, 0, 0};
    distances.prepare(overlap);
    PatchDistances::Scratch scratch = distances.scratch();
    for (auto _ : state)
        distances.compute(known, overlap, 0, scratch, [] {});
}
BENCHMARK(searchOfOnePatch)->Args({128, 32})->Args({256, 40})->Args({512, 64})->Unit(benchmark::kMicrosecond);

/// Argument: patch; overlap a quarter, L-shaped, then closing on all sides.
void cutOfOnePatch(benchmark::State& state) {
    const int patch = static_cast<int>(state.range(0)), width = patch / 4;
    const bool closing = state.range(1) != 0;
    const Image error = noise({patch, patch}, 1);
    const Overlap overlap = closing ? Overlap{width, width, width, width} : Overlap{width, width, 0, 0};
    for (auto _ : state)
        benchmark::DoNotOptimize(minimumErrorCut(error.view().plane(0), overlap));
}
BENCHMARK(cutOfOnePatch)->ArgsProduct({{32, 64, 128}, {0, 1}})->Unit(benchmark::kMicrosecond);

/// Argument: rows of a band across 1000 pixels. The cost grows as the number of pixels.
void poissonOfOneBand(benchmark::State& state) {
    constexpr int kSide = 1000;
    const auto rows = static_cast<std::size_t>(state.range(0));
    std::vector<std::uint8_t> unknown(std::size_t{kSide} * kSide, 0);
    std::fill_n(unknown.begin() + kSide, rows * kSide, 1);
    const std::vector<float> divergence(rows * kSide, 0.01F);
    const Image before = noise({kSide, kSide}, 1);
    for (auto _ : state) {
        Image values = before;
        solvePoisson(unknown, divergence, values);
    }
}
BENCHMARK(poissonOfOneBand)->Arg(50)->Arg(200)->Arg(800)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace texloom::bench

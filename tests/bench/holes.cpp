#include "core/methods/fill_request.h"
#include "tests/bench/timed_run.h"
#include "tests/support/textures.h"

#include <memory>

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
    timeRun(state, id, pierced());
}
BENCHMARK_CAPTURE(fillHole, patchmatch, "patchmatch")->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(fillHole, quilting, "quilting")->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(fillHole, efrosLeung, "efros-leung")->Unit(benchmark::kSecond)->UseRealTime();

} // namespace
} // namespace texloom::bench

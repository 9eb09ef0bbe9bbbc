#include "tests/core/session/sample_run.h"

#include "core/base/error.h"

#include <utility>

namespace texloom::test {

SampleRun::SampleRun() {
    input.steps.front().method = "quilting";
    input.steps.front().parameters = {{"patch", 12}};
    input.exemplars.push_back({loadExemplar(write("bark", {48, 44}, 3)), {}, {}});
    input.size = {64, 60};
    input.seed = 3;
    input.threads = 2;
}

std::filesystem::path SampleRun::write(const std::string& name, Size size, int channels,
                                       std::uint64_t seed) const {
    const std::filesystem::path path = folder / (name + ".png");
    writeImage(path, blobs(size, channels, seed), {});
    return path;
}

void SampleRun::addCompanion(const std::string& name, Size size) {
    input.exemplars.front().companions.push_back(loadData(write(name, size, 3, 8)));
}

Result SampleRun::run() const {
    Outcome<Result> outcome = startRun(planRun(input), false)->take();
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    return std::get<Result>(std::move(outcome));
}

} // namespace texloom::test

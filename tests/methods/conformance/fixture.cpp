#include "tests/methods/conformance/fixture.h"

#include "core/base/error.h"
#include "core/job/job.h"
#include "tests/methods/made_up_ports.h"
#include "tests/support/textures.h"

#include <algorithm>
#include <limits>
#include <map>

namespace texloom::test {

namespace {

ExemplarFile madeUp(const std::shared_ptr<const Image>& image) {
    ExemplarFile file;
    file.path = "made up";
    file.image = image;
    return file;
}

InputFiles filesOf(const Assets& assets) {
    InputFiles files;
    for (const auto& [port, given] : assets.byPort())
        for (const Asset& asset : given) {
            InputFile file;
            if (const auto* image = std::get_if<std::shared_ptr<const Image>>(&asset))
                file.file = madeUp(*image);
            file.asset = asset;
            files[port].push_back(std::move(file));
        }
    return files;
}

/// What the window and the command line would have for this request.
RunInput inputFor(const Method& method, const Request& request, const Values& settings) {
    RunInput input;
    input.steps.front() = {method.id(), settings};
    for (const Exemplar& exemplar : request.exemplars) {
        RunExemplar& given = input.exemplars.emplace_back();
        given.image = madeUp(exemplar.image);
        given.inputs = filesOf(exemplar.inputs);
        if (const auto mask = given.inputs.find(std::string(kMaskPort)); mask != given.inputs.end()) {
            given.mask = mask->second.front().file;
            given.inputs.erase(mask);
        }
        given.weight = exemplar.weight;
    }
    input.inputs = filesOf(request.inputs);
    input.size = request.size;
    input.wrap = request.wrap;
    input.seed = request.seed;
    input.region = request.region;
    input.judged = false;
    return input;
}

} // namespace

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

Request requestFor(Size exemplar, int channels, Size output, std::uint64_t seed) {
    Request request;
    request.exemplars.push_back({"made up", shared(blobs(exemplar, channels))});
    request.size = output;
    request.seed = seed;
    return request;
}

Values briefSettings(const Method& method, const Request& request) {
    const Size exemplar = request.exemplars.empty() ? Size{} : request.exemplars.front().image->size();
    Values settings = method.resolved({}, exemplar);
    constexpr int kIterations = 3, kVoxels = 32;
    for (auto& [name, value] : settings)
        if (name.ends_with("iterations"))
            value = std::min(std::get<int>(value), kIterations);
        else if (method.param(name).unit() == "voxels")
            value = std::min(std::get<int>(value), kVoxels);
    return settings;
}

bool learns(const MethodInfo& info) {
    return std::any_of(info.takes.begin(), info.takes.end(), [](const Port& port) {
        return port.id == kExemplarPort || (port.kind == AssetKind::Model && port.least > 0);
    });
}

RunPlan planFor(const Method& method, const Request& request, const Values& settings, int threads) {
    RunInput input = inputFor(method, request, settings);
    input.threads = threads;
    return planRun(input, std::numeric_limits<std::uint64_t>::max());
}

Synthesis runWith(const Method& method, Request request, int threads) {
    const Values settings = briefSettings(method, request);
    return runWith(method, std::move(request), settings, threads);
}

Synthesis runWith(const Method& method, Request request, const Values& settings, int threads) {
    if (!request.size.empty() && request.size.longerSide() <= kLargestSide)
        fillPorts(method.info(), request);
    else if (!method.info().takesExemplars())
        request.exemplars.clear();
    const auto job = startRun(planFor(method, request, settings, threads), false);
    Outcome<Result> outcome = job->take();
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    return std::get<Result>(std::move(outcome)).synthesis;
}

const Synthesis& usualResult(const Method& method) {
    static std::map<std::string, Synthesis> made;
    const auto found = made.find(method.id());
    if (found != made.end())
        return found->second;
    return made.emplace(method.id(), runWith(method, requestFor({50, 61}, 3, {97, 80}), 2)).first->second;
}

Size reduced(Size size) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return {size.width / 2, size.height / 2};
#else
    return size;
#endif
}

RunPlan longPlan(const Method& method, Size output) {
    Request request = requestFor({256, 256}, 3, output);
    fillPorts(method.info(), request);
    return planFor(method, request, {});
}

Volume sampled(const VolumeSource& source, const Box& box, int threads) {
    JobMonitor monitor;
    JobContext context(
        {0, threads, false}, [] { return false; }, monitor);
    return source.sample(box, context);
}

Box boxOf(const VolumeSource& source) {
    return source.bounds().value_or(Box{-5, 3, -2, {12, 10, 9}});
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, Conformance, testing::ValuesIn(everyMethod()), testName);

} // namespace texloom::test

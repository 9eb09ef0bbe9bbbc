// The promises that every registered method keeps, as they are kept by what the window and the command line
// run. A new method is tested here by being registered.

#include "core/base/error.h"
#include "core/io/model_file.h"
#include "core/job/job.h"
#include "core/session/run/run.h"
#include "core/volume/mesh.h"
#include "core/volume/volume_source.h"
#include "tests/methods/every_method.h"
#include "tests/methods/made_up_ports.h"
#include "tests/methods/process_memory.h"
#include "tests/support/textures.h"
#include "tests/support/time_limit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace texloom::test {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;
using testing::HasSubstr;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

Request requestFor(Size exemplar, int channels, Size output, std::uint64_t seed = 7) {
    Request request;
    request.exemplars.push_back({"made up", shared(blobs(exemplar, channels))});
    request.size = output;
    request.seed = seed;
    return request;
}

/// The defaults, but with no more than three iterations and one pass: they are alike in all that is asked
/// here.
Values briefSettings(const Method& method, const Request& request) {
    Values settings = method.resolved({}, request.exemplars.front().image->size());
    for (auto& [name, value] : settings)
        if (name.ends_with("iterations"))
            value = std::min(std::get<int>(value), 3);
        else if (name == "passes")
            value = 1;
    return settings;
}

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

/// The plan of a run, however much memory this machine has. @param threads 0: one per core
RunPlan planFor(const Method& method, const Request& request, const Values& settings, int threads = 0) {
    RunInput input = inputFor(method, request, settings);
    input.threads = threads;
    return planRun(input, std::numeric_limits<std::uint64_t>::max());
}

Synthesis runWith(const Method& method, Request request, int threads) {
    if (!request.size.empty() && request.size.longerSide() <= kLargestSide)
        fillPorts(method.info(), request);
    const auto job = startRun(planFor(method, request, briefSettings(method, request), threads), false);
    Outcome<Result> outcome = job->take();
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    return std::get<Result>(std::move(outcome)).synthesis;
}

/// A run that keeps nearly every method busy for seconds, so that it can be watched and stopped.
RunPlan longPlan(const Method& method) {
    Request request = requestFor({256, 256}, 3, {4096, 4096});
    fillPorts(method.info(), request);
    return planFor(method, request, {});
}

/// The voxels of a box, on so many threads.
Volume sampled(const VolumeSource& source, const Box& box, int threads = 2) {
    JobMonitor monitor;
    JobContext context(
        {0, threads, false}, [] { return false; }, monitor);
    return source.sample(box, context);
}

/// A box that a source has.
Box boxOf(const VolumeSource& source) {
    return source.bounds().value_or(Box{-5, 3, -2, {12, 10, 9}});
}

void expectSameAsset(const Asset& a, const Asset& b) {
    ASSERT_EQ(a.index(), b.index());
    if (const auto* model = std::get_if<std::shared_ptr<const Model>>(&a)) {
        EXPECT_EQ(**model, *std::get<std::shared_ptr<const Model>>(b));
    } else if (const auto* volume = std::get_if<std::shared_ptr<const VolumeSource>>(&a)) {
        const Box box = boxOf(**volume);
        EXPECT_TRUE(sameVoxels(sampled(**volume, box, 1),
                               sampled(*std::get<std::shared_ptr<const VolumeSource>>(b), box, 5)));
    } else if (const auto* image = std::get_if<std::shared_ptr<const Image>>(&a)) {
        EXPECT_TRUE(samePixels(**image, *std::get<std::shared_ptr<const Image>>(b)));
    }
}

class Conformance : public testing::TestWithParam<std::string> {
protected:
    const Method& method() const { return findMethod(GetParam()); }
    void expectSame(const Synthesis& a, const Synthesis& b) const {
        EXPECT_TRUE(samePixels(a.image, b.image));
        EXPECT_EQ(a.map, b.map);
        for (const auto& [port, assets] : a.outputs.byPort()) {
            ASSERT_EQ(assets.size(), b.outputs.at(port).size()) << port;
            for (std::size_t i = 0; i < assets.size(); ++i)
                expectSameAsset(assets[i], b.outputs.at(port)[i]);
        }
    }
};

TEST_P(Conformance, sameRecipeGivesTheSameBitsForAnyNumberOfThreads) {
    if (method().info().repeats == Repeats::Nearly)
        GTEST_SKIP() << "skipped: " << GetParam() << " says that it repeats but for rounding";
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
        Request request = requestFor({48, 40}, 3, {101, 90});
        if (method().info().canWrap())
            request.wrap = wrap;
        const Synthesis one = runWith(method(), request, 1);
        expectSame(one, runWith(method(), request, 2));
        expectSame(one, runWith(method(), request, 7));
        expectSame(one, runWith(method(), request, 1));
    }
}

TEST_P(Conformance, anotherSeedMattersAsTheMethodSays) {
    const Synthesis one = runWith(method(), requestFor({48, 48}, 3, {96, 96}, 1), 1);
    const Synthesis two = runWith(method(), requestFor({48, 48}, 3, {96, 96}, 2), 1);
    EXPECT_EQ(samePixels(one.image, two.image), !method().info().usesSeed);
}

TEST_P(Conformance, cancelAnswersAtOnce) {
    const RunPlan plan = longPlan(method());
    const auto timeToCancel = [&]() -> std::chrono::nanoseconds {
        const auto job = startRun(plan, false);
        const auto begun = Clock::now();
        while (job->monitor().progress() < 0.02 && !job->finished() && Clock::now() - begun < 3s)
            std::this_thread::sleep_for(1ms);
        const auto asked = Clock::now();
        job->cancel();
        EXPECT_TRUE(std::holds_alternative<Cancelled>(job->take()));
        return Clock::now() - asked;
    };
    const auto limit = limitNow(method().info().cancelsWithin);
    if (!limit)
        GTEST_SKIP() << kTooBusy;
    EXPECT_LE(shortest(*limit, timeToCancel), *limit) << "until the job had ended";
}

TEST_P(Conformance, progressNeverFallsAndEndsAtOne) {
    Request request = requestFor({64, 64}, 3, {512, 512});
    fillPorts(method().info(), request);
    const auto job = startRun(planFor(method(), request, briefSettings(method(), request)), false);
    double last = 0;
    while (!job->finished()) {
        const double now = job->monitor().progress();
        EXPECT_GE(now, last);
        last = now;
        std::this_thread::yield();
    }
    EXPECT_EQ(job->monitor().progress(), 1);
    EXPECT_FALSE(job->monitor().stageTimes().empty());
    for (const StageTime& stage : job->monitor().stageTimes())
        EXPECT_FALSE(stage.name.empty());
    EXPECT_TRUE(std::holds_alternative<Result>(job->take()));
}

TEST_P(Conformance, stagesMakeUpTheWhole) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
        Request request = requestFor({48, 40}, 3, {101, 90});
        if (method().info().canWrap())
            request.wrap = wrap;
        fillPorts(method().info(), request);
        const RunPlan plan = planFor(method(), request, briefSettings(method(), request));
        JobMonitor monitor;
        JobContext context(
            {request.seed, 2, false}, [] { return false; }, monitor);
        context.step(0, 0.5); // half of a run, so that more than the whole would show, too
        method().run(plan.requestFor(0, method().info()), plan.steps.front().settings, context);
        context.stage(0, "what follows");
        EXPECT_NEAR(monitor.progress(), 0.5, 1e-6) << "half the sum of the stages' weights";
    }
}

TEST_P(Conformance, previewsComeWhileItRuns) {
    const auto job = startRun(longPlan(method()), true);
    int previews = 0;
    const auto start = Clock::now();
    while (previews < 3 && !job->finished()) {
        if (const auto preview = job->monitor().takePreview()) {
            ++previews;
            EXPECT_EQ((preview->fullSize.width + preview->step - 1) / preview->step, preview->image.width());
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    // Previews may take a fiftieth of the time, so that a short run has few.
    EXPECT_GE(previews, std::min(3, static_cast<int>(seconds / 2))) << "before the job ended";
}

TEST_P(Conformance, givesWhatItSays) {
    const Synthesis result = runWith(method(), requestFor({50, 61}, 3, {97, 80}), 2);
    EXPECT_EQ(result.mapKind == MapKind::Exact || result.mapKind == MapKind::Dominant,
              method().info().copiesPixels());
    for (const Port& port : method().info().gives) {
        const std::vector<Asset>& given = result.outputs.at(port.id);
        const bool own = port.id != kImagePort && port.id != kMapPort; // those two have members of their own
        EXPECT_GE(static_cast<int>(given.size()), own ? port.least : 0) << port.id;
        EXPECT_LE(static_cast<int>(given.size()), port.most) << port.id;
        for (const Asset& asset : given)
            EXPECT_TRUE(isOf(port.kind, asset)) << port.id;
    }
    for (const auto& [id, given] : result.outputs.byPort())
        EXPECT_NE(method().info().output(id), nullptr) << id << " is not declared";
}

TEST_P(Conformance, modelsAreOfTheKindThatTheirPortSays) {
    const Synthesis result = runWith(method(), requestFor({50, 61}, 3, {97, 80}), 2);
    for (const Port& port : method().info().gives)
        if (port.kind == AssetKind::Model) {
            ASSERT_NE(result.outputs.first<Model>(port.id), nullptr) << port.id;
            EXPECT_EQ(result.outputs.first<Model>(port.id)->kind, port.id);
        }
    for (const Port& port : method().info().takes) {
        if (port.kind != AssetKind::Model)
            continue;
        Request request = requestFor({50, 61}, 3, {97, 80});
        auto other = std::make_shared<Model>();
        other->kind = "another";
        request.inputs.set(port.id, std::shared_ptr<const Model>(other));
        try {
            runWith(method(), request, 1);
            ADD_FAILURE() << "a model of another kind was taken";
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr(port.id));
            EXPECT_THAT(error.what(), HasSubstr("another"));
        }
    }
}

TEST_P(Conformance, boxesOfVolumesEqualThatPartOfLargerOnes) {
    const Synthesis result = runWith(method(), requestFor({50, 61}, 3, {97, 80}), 2);
    for (const auto& [port, assets] : result.outputs.byPort()) {
        const auto source = result.outputs.first<VolumeSource>(port);
        if (!source)
            continue;
        const Box whole = boxOf(*source);
        const Volume all = sampled(*source, whole);
        const Box part{whole.x + whole.size.width / 3,
                       whole.y + whole.size.height / 2,
                       whole.z + whole.size.depth / 4,
                       {whole.size.width / 2, whole.size.height / 3, whole.size.depth / 2}};
        const Volume alone = sampled(*source, part);
        for (int c = 0; c < all.channels(); ++c)
            for (int z = 0; z < part.size.depth; ++z)
                for (int y = 0; y < part.size.height; ++y)
                    for (int x = 0; x < part.size.width; ++x)
                        ASSERT_EQ(alone(x, y, z, c), all(static_cast<int>(part.x - whole.x) + x,
                                                         static_cast<int>(part.y - whole.y) + y,
                                                         static_cast<int>(part.z - whole.z) + z, c));
    }
}

TEST_P(Conformance, whatHasNoPortIsRefusedByName) {
    Request request = requestFor({50, 61}, 3, {97, 80});
    request.inputs.set("nonesuch", shared(constant({97, 80}, 3, 0.5F)));
    try {
        runWith(method(), request, 1);
        ADD_FAILURE() << "an input of no port was taken";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("nonesuch"));
    }
}

TEST_P(Conformance, stopsEarlyWithWhatItHas) {
    const RunPlan plan = longPlan(method());
    const auto job = startRun(plan, false);
    job->stopAndKeep();
    const Outcome<Result> outcome = job->take();
    ASSERT_TRUE(std::holds_alternative<Result>(outcome)) << "stopping early is not a failure";
    const auto& result = std::get<Result>(outcome);
    EXPECT_EQ(result.synthesis.image.channels(), plan.request.resultChannels());
    EXPECT_EQ(result.synthesis.image.size(), plan.request.size);
    EXPECT_LT(result.stoppedAt.value_or(0), 1);
}

TEST_P(Conformance, exactMapGivesTheResult) {
    const Request request = requestFor({50, 61}, 4, {133, 97});
    const Synthesis result = runWith(method(), request, 2);
    EXPECT_EQ(result.image.size(), request.size);
    EXPECT_EQ(result.image.channels(), request.channels());
    if (result.mapKind == MapKind::None)
        return;
    ASSERT_EQ(result.map.size(), request.size);
    if (result.mapKind == MapKind::Exact) {
        EXPECT_TRUE(samePixels(result.map.apply(request.exemplars.front().image->view()), result.image));
    }
}

/// The seam's mean difference against the largest between two neighbouring lines inside.
double worstInsideX(const ImageView& image) {
    double worst = 0;
    for (int x = 0; x + 1 < image.width; ++x) {
        double sum = 0;
        for (int c = 0; c < image.channels; ++c)
            for (int y = 0; y < image.height; ++y)
                sum += std::abs(static_cast<double>(image(x + 1, y, c) - image(x, y, c)));
        worst = std::max(worst, sum);
    }
    return worst;
}

double seamX(const ImageView& image) {
    double sum = 0;
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            sum += std::abs(static_cast<double>(image(0, y, c) - image(image.width - 1, y, c)));
    return sum;
}

Image transposed(const ImageView& image) {
    Image turned({image.height, image.width}, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                turned(y, x, c) = image(x, y, c);
    return turned;
}

TEST_P(Conformance, wrappedOutputTilesOnTheChosenAxes) {
    if (!method().info().canWrap())
        GTEST_SKIP() << "skipped: " << GetParam() << " does not say that it wraps";
    for (const Wrap wrap : {Wrap{true, false}, Wrap{false, true}, Wrap{true, true}})
        for (const Size size : {Size{151, 148}, Size{64, 200}}) {
            Request request = requestFor({64, 64}, 3, size);
            request.wrap = wrap;
            const Image image = runWith(method(), request, 2).image;
            if (wrap.x) {
                EXPECT_LE(seamX(image), worstInsideX(image));
            }
            if (wrap.y) {
                EXPECT_LE(seamX(transposed(image)), worstInsideX(transposed(image)));
            }
        }
}

TEST_P(Conformance, regionsEqualTheCropOfTheWhole) {
    Request request = requestFor({60, 52}, 3, {141, 120});
    const Region parts[] = {{0, 0, {40, 30}}, {57, 43, {1, 1}}, {33, 20, {70, 64}}, {110, 5, {31, 115}}};
    if (!method().info().makesParts()) {
        request.region = parts[0];
        EXPECT_THROW(runWith(method(), request, 1), UsageError);
        return;
    }
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{true, true}}) {
        if (method().info().canWrap())
            request.wrap = wrap;
        request.region.reset();
        const Synthesis whole = runWith(method(), request, 2);
        for (const Region& part : parts) {
            request.region = part;
            const Synthesis alone = runWith(method(), request, 2);
            EXPECT_TRUE(samePixels(alone.image, whole.image.view().crop(part.x, part.y, part.size)));
            ASSERT_EQ(alone.map.size(), part.size);
            EXPECT_EQ(alone.map.at(0, 0), whole.map.at(part.x, part.y));
        }
    }
    request.region = Region{100, 100, {42, 10}};
    EXPECT_THROW(runWith(method(), request, 1), UsageError);
}

TEST_P(Conformance, memoryStaysWithinTheEstimate) {
    if (kSanitized)
        GTEST_SKIP() << "skipped: a sanitizer's own memory is not the method's";
    Request request = requestFor({200, 180}, 3, {1500, 1400});
    fillPorts(method().info(), request);
    const std::uint64_t bytes =
        planFor(method(), request, briefSettings(method(), request), 2).estimate.bytes;
    const auto growth = peakGrowth([&] { runWith(method(), request, 2); });
    if (!growth)
        GTEST_SKIP() << "skipped: the kernel does not let the peak be reset";
    EXPECT_GT(*growth, bytes / 20) << "the estimate has nothing to do with the run";
    EXPECT_LE(*growth, bytes);
}

TEST_P(Conformance, valuesOutOfRangeAreRefusedByNameAndLimit) {
    for (const Param& param : method().params()) {
        if (!param.hasRange())
            continue;
        for (const double value : {param.smallest() - 1, param.largest() + 1})
            try {
                method().resolved({{param.name(), value}}, {64, 64});
                ADD_FAILURE() << param.name() << " = " << value << " was taken";
            } catch (const UsageError& error) {
                EXPECT_THAT(error.what(), HasSubstr(param.name() + " = "));
                EXPECT_THAT(error.what(), HasSubstr(param.limits().text()));
            }
    }
}

TEST_P(Conformance, everyParameterIsExplained) {
    for (const Param& param : method().params()) {
        EXPECT_FALSE(param.title().empty()) << param.name();
        EXPECT_GT(param.help().size(), 20U) << param.name();
        EXPECT_NO_THROW(param.checked(param.defaultFor(0))) << param.name();
        for (const int side : {1, 7, 64, 1000, 60000})
            EXPECT_NO_THROW(param.checked(param.defaultFor(side)))
                << param.name() << " for " << side << " px";
    }
    EXPECT_FALSE(method().info().summary.empty());
    EXPECT_FALSE(method().info().citation.empty());
}

TEST_P(Conformance, tinyExemplarsAreRefusedInASentenceOrWork) {
    for (const Size size : {Size{1, 1}, Size{2, 2}, Size{3, 40}, Size{9, 9}})
        try {
            const Synthesis result = runWith(method(), requestFor(size, 3, {40, 40}), 1);
            EXPECT_EQ(result.image.size(), (Size{40, 40}));
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr("px"));
        }
}

TEST_P(Conformance, emptyMaskIsRefused) {
    if (!method().info().heedsMasks())
        GTEST_SKIP() << "skipped: " << GetParam() << " uses no mask";
    Request request = requestFor({64, 64}, 3, {64, 64});
    request.exemplars.front().inputs.set(kMaskPort, shared(constant({64, 64}, 1, 0)));
    EXPECT_THROW(runWith(method(), request, 1), UsageError);
    request.exemplars.front().inputs.set(kMaskPort, shared(constant({64, 63}, 1, 1)));
    EXPECT_THROW(runWith(method(), request, 1), UsageError);
}

TEST_P(Conformance, whatTheMaskHidesIsNeverCopied) {
    if (!method().info().heedsMasks() || !method().info().copiesPixels())
        GTEST_SKIP() << "skipped: " << GetParam() << " copies nothing or uses no mask";
    Request request = requestFor({96, 90}, 3, {130, 110});
    Image mask = constant({96, 90}, 1, 1);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 96; ++x)
            if (x > 84 || (x < 6 && y > 70) || (x == 40 && y > 86))
                mask(x, y, 0) = 0;
    request.exemplars.front().inputs.set(kMaskPort, shared(mask));
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
        request.wrap = wrap;
        const Synthesis result = runWith(method(), request, 2);
        for (int y = 0; y < result.map.height(); ++y)
            for (int x = 0; x < result.map.width(); ++x)
                ASSERT_NE(mask(result.map.at(x, y).x, result.map.at(x, y).y, 0), 0)
                    << result.map.at(x, y).x << ", " << result.map.at(x, y).y;
    }
}

TEST_P(Conformance, exemplarsCountAsMuchAsTheyWeigh) {
    if (!method().info().heedsWeights())
        GTEST_SKIP() << "skipped: " << GetParam() << " takes all exemplars alike";
    Request request = requestFor({40, 40}, 3, {80, 70});
    request.exemplars.push_back({"another", shared(blobs({36, 44}, 3, 2))});
    const auto weighed = [&](double first, double second) {
        request.exemplars.front().weight = first;
        request.exemplars.back().weight = second;
        return runWith(method(), request, 2);
    };
    const Synthesis plain = weighed(1, 1), first = weighed(20, 0.5), second = weighed(0.5, 20);
    EXPECT_TRUE(samePixels(plain.image, weighed(3, 3).image));
    EXPECT_FALSE(samePixels(first.image, second.image));
    if (!method().info().copiesPixels())
        return;
    const auto pixelsOfFirst = [](const PositionMap& map) {
        int count = 0;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x)
                count += map.at(x, y).exemplar == 0;
        return count;
    };
    EXPECT_GT(pixelsOfFirst(first.map), pixelsOfFirst(second.map));
}

TEST_P(Conformance, sizesThatMakeNoSenseAreRefused) {
    for (const Size size : {Size{0, 10}, Size{10, 0}, Size{-3, 5}, Size{200000, 200000}})
        EXPECT_THROW(runWith(method(), requestFor({64, 64}, 3, size), 1), UsageError);
}

TEST_P(Conformance, oddSizesChannelsAndValuesGiveSoundResults) {
    for (const int channels : {1, 2, 5})
        for (const Size size : {Size{1, 1}, Size{3, 200}, Size{97, 1}, Size{131, 113}}) {
            const Synthesis result = runWith(method(), requestFor({53, 47}, channels, size), 2);
            EXPECT_EQ(result.image.size(), size);
            const ValueRange range = valueRange(result.image);
            EXPECT_TRUE(std::isfinite(range.smallest) && std::isfinite(range.largest));
        }
}

TEST_P(Conformance, constantExemplarGivesThatConstant) {
    Request request = requestFor({40, 40}, 3, {90, 70});
    request.exemplars.front().image = shared(constant({40, 40}, 3, 0.25F));
    const ValueRange range = valueRange(runWith(method(), request, 2).image);
    EXPECT_NEAR(range.smallest, 0.25, 1e-4);
    EXPECT_NEAR(range.largest, 0.25, 1e-4);
}

TEST_P(Conformance, valuesAboveOneAreKept) {
    Request request = requestFor({48, 48}, 3, {96, 96});
    Image bright = blobs({48, 48}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x)
                bright(x, y, c) = 40 * bright(x, y, c);
    request.exemplars.front().image = shared(std::move(bright));
    EXPECT_GT(valueRange(runWith(method(), request, 1).image).largest, 20);
}

TEST_P(Conformance, initialImageOfAnotherSizeIsRefused) {
    Request request = requestFor({64, 64}, 3, {80, 80});
    request.inputs.set(kInitialPort, shared(constant({80, 79}, 3, 0.5F)));
    EXPECT_THROW(runWith(method(), request, 1), UsageError);
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, Conformance, testing::ValuesIn(everyMethod()), testName);

} // namespace
} // namespace texloom::test

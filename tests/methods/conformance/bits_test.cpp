// The same bits for any number of threads, and for a part as for the whole.

#include "core/base/error.h"
#include "core/io/model_file.h"
#include "tests/methods/conformance/fixture.h"
#include "tests/methods/made_up_ports.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace texloom::test {
namespace {

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

void expectSame(const Synthesis& a, const Synthesis& b) {
    EXPECT_TRUE(samePixels(a.image, b.image));
    EXPECT_EQ(a.map, b.map);
    for (const auto& [port, assets] : a.outputs.byPort()) {
        ASSERT_EQ(assets.size(), b.outputs.at(port).size()) << port;
        for (std::size_t i = 0; i < assets.size(); ++i)
            expectSameAsset(assets[i], b.outputs.at(port)[i]);
    }
}

/// As a recipe that runs again has it: the same, or, of a method that says so, but for rounding.
void expectRepeated(const MethodInfo& info, const Synthesis& a, const Synthesis& b) {
    if (info.repeats == Repeats::Bits)
        return expectSame(a, b);
    constexpr double kRounding = 1e-4;
    ASSERT_EQ(a.image.size(), b.image.size());
    ASSERT_EQ(a.image.channels(), b.image.channels());
    for (int c = 0; c < a.image.channels(); ++c)
        for (int y = 0; y < a.image.height(); ++y)
            for (int x = 0; x < a.image.width(); ++x)
                ASSERT_NEAR(a.image(x, y, c), b.image(x, y, c), kRounding);
}

TEST_P(Conformance, sameRecipeGivesTheSameForAnyNumberOfThreads) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
        Request request = requestFor({48, 40}, 3, {101, 90});
        if (method().info().canWrap())
            request.wrap = wrap;
        const Synthesis one = runWith(method(), request, 1);
        expectRepeated(method().info(), one, runWith(method(), request, 7));
        expectRepeated(method().info(), one, runWith(method(), request, 2));
        expectRepeated(method().info(), one, runWith(method(), request, 1));
    }
}

/// Methods that take so long that they must keep checkpoints; what they declare does not tell.
bool mustKeepCheckpoints(const std::string& id) {
    static const std::set<std::string> all = {"gram-cnn",      "slow-diffusion", "solid-optimise",
                                              "solid-texture", "sparse",         "texture-network"};
    return all.contains(id);
}

TEST_P(Conformance, whatGoesOnFromACheckpointEndsAsThoughNothingHadHappened) {
    Request request = requestFor({48, 40}, 3, {101, 90});
    fillPorts(method().info(), request);
    const RunPlan plan = planFor(method(), request, briefSettings(method(), request));
    const auto made = [&](JobOptions options) {
        options.seed = request.seed;
        options.threads = 2;
        JobMonitor monitor;
        JobContext context(
            options, [] { return false; }, monitor);
        return method().run(plan.requestFor(0, method().info()), plan.steps.front().settings, context);
    };
    std::vector<Checkpoint> kept;
    JobOptions keeping;
    keeping.keep = [&](const Checkpoint& checkpoint) { kept.push_back(checkpoint); };
    keeping.keepEvery = std::chrono::milliseconds(0);
    const Synthesis whole = made(keeping);
    if (kept.empty() && !mustKeepCheckpoints(GetParam()))
        GTEST_SKIP() << "skipped: " << GetParam() << " keeps no checkpoints";
    ASSERT_FALSE(kept.empty());
    for (const std::size_t from : {std::size_t{0}, kept.size() / 2, kept.size() - 1}) {
        JobOptions resumed;
        resumed.resumed = std::make_shared<const Checkpoint>(kept[from]);
        expectRepeated(method().info(), made(resumed), whole);
    }
}

bool seedMatters(const Method& method, const Values& settings) {
    const Synthesis one = runWith(method, requestFor({48, 48}, 3, {96, 96}, 1), settings, 1);
    const Synthesis two = runWith(method, requestFor({48, 48}, 3, {96, 96}, 2), settings, 1);
    return !samePixels(one.image, two.image);
}

/// The settings, each with one parameter at another choice, or at its largest value, that can be run.
std::vector<Values> neighboursOf(const Method& method, const Values& settings) {
    std::vector<Values> all;
    const auto add = [&](const Param& param, const Value& value) {
        Values other = settings;
        other[param.name()] = value;
        all.push_back(std::move(other));
    };
    for (const Param& param : method.params()) {
        for (const Choice& choice : param.choices())
            if (choice.id != "given")
                add(param, choice.id);
        if (param.type() == Param::Type::Real && param.hasRange() && param.applies(settings))
            add(param, param.largest());
    }
    return all;
}

/// A method whose seed matters may need settings for it: one that takes the best by default.
TEST_P(Conformance, anotherSeedMattersAsTheMethodSays) {
    const Values settings = briefSettings(method(), requestFor({48, 48}, 3, {96, 96}));
    const bool matters = seedMatters(method(), settings);
    if (!method().info().usesSeed || matters) {
        EXPECT_EQ(matters, method().info().usesSeed);
        return;
    }
    const std::vector<Values> others = neighboursOf(method(), settings);
    EXPECT_TRUE(std::any_of(others.begin(), others.end(),
                            [this](const Values& other) { return seedMatters(method(), other); }));
}

TEST_P(Conformance, boxesOfVolumesEqualThatPartOfLargerOnes) {
    const Synthesis& result = usualResult(method());
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
            if (method().info().copiesPixels()) {
                ASSERT_EQ(alone.map.size(), part.size);
                EXPECT_EQ(alone.map.at(0, 0), whole.map.at(part.x, part.y));
            }
            for (const Port& port : method().info().gives)
                if (const Image* own = alone.outputs.image(port.id)) {
                    const Image& all = *whole.outputs.image(port.id);
                    const bool laidOut = all.size() == request.size;
                    const ImageView wanted =
                        laidOut ? all.view().crop(part.x, part.y, part.size) : all.view();
                    EXPECT_TRUE(samePixels(*own, wanted)) << port.id;
                }
        }
    }
    request.region = Region{100, 100, {42, 10}};
    EXPECT_THROW(runWith(method(), request, 1), UsageError);
}

} // namespace
} // namespace texloom::test

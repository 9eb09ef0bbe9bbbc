// Texture networks: that training lowers the loss, what a trained model makes, how training ends, refusals.

#include "core/base/at.h"
#include "core/generator/generator_weights.h"
#include "core/io/image_file.h"
#include "core/io/model_file.h"
#include "core/math/channel_pca.h"
#include "core/methods/generator_training.h"
#include "core/methods/method.h"
#include "core/session/export/export.h"
#include "core/session/run/exemplar_file.h"
#include "core/session/run/run.h"
#include "tests/support/method_run.h"
#include "tests/support/stopped_run.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace texloom::test::texture_network_tests {
namespace {

using testing::HasSubstr;

constexpr const char* kPort = "texture-generator";

const Method& textureNetwork() {
    return findMethod("texture-network");
}

/// Small and quick settings, with others in their place.
Values quick(const Values& changes = {}) {
    const Values settings{{"iterations", 4}, {"train-size", 32}, {"batch", 1},      {"scales", 2},
                          {"channels", 4},   {"levels", 1},      {"decay-every", 3}};
    return with(settings, changes);
}

Synthesis made(const Request& request, const Values& settings, const JobOptions& options = {.threads = 2}) {
    return resultOf(textureNetwork(), request, settings, options);
}

std::string refusal(const Request& request, const Values& settings) {
    return refusalOf(textureNetwork(), request, settings);
}

/// Upright stripes, four pixels from one to the next.
Image stripes(int side) {
    Image image({side, side}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                image(x, y, c) = static_cast<float>(0.5 + (0.4 - 0.1 * c) * std::sin(1.5708 * x + 0.3));
    return image;
}

double meanOf(const std::vector<double>& values, std::size_t first, std::size_t count) {
    double sum = 0;
    for (std::size_t i = first; i < first + count; ++i)
        sum += values[i] / static_cast<double>(count);
    return sum;
}

/// A request for what a model makes, without an exemplar.
Request requestFrom(const std::shared_ptr<const Model>& model, Size output, std::uint64_t seed = 3) {
    Request request;
    request.inputs.set(kPort, model);
    request.size = output;
    request.seed = seed;
    return request;
}

std::shared_ptr<const Model> trained(const Values& changes = {}, int channels = 3) {
    return made(requestOf(blobs({48, 40}, channels), {8, 8}), quick(changes)).outputs.first<Model>(kPort);
}

TEST(TextureNetwork, trainingOnStripesLowersTheLossTenfold) {
    for (const char* padding : {"none", "circular"}) {
        const Synthesis result = made(
            requestOf(stripes(64), {64, 64}),
            quick({{"iterations", 200}, {"loss", std::string("gram")}, {"padding", std::string(padding)}}));
        const std::vector<double>& loss = result.curves.front().values;
        ASSERT_EQ(loss.size(), 200U);
        EXPECT_LT(10 * meanOf(loss, 190, 10), meanOf(loss, 0, 2)) << padding;
    }
}

TEST(TextureNetwork, everyLossAndSettingTakesPart) {
    const Request request = requestOf(blobs({48, 40}, 3), {40, 30});
    const Image plain = made(request, quick()).image;
    for (const Values& change : std::vector<Values>{{{"loss", std::string("gram")}},
                                                    {{"loss", std::string("patches")}},
                                                    {{"statistic", std::string("gram")}},
                                                    {{"pooling", std::string("maximum")}},
                                                    {{"even-gradients", true}},
                                                    {{"levels", 2}},
                                                    {{"descriptor", std::string("random")}},
                                                    {{"exemplar-side", 32}},
                                                    {{"train-size", 40}},
                                                    {{"batch", 2}},
                                                    {{"rate", 0.05}},
                                                    {{"decay", 0.5}},
                                                    {{"decay-every", 2}},
                                                    {{"padding", std::string("circular")}},
                                                    {{"scales", 3}},
                                                    {{"channels", 5}},
                                                    {{"noise-channels", 2}}})
        EXPECT_FALSE(samePixels(made(request, quick(change)).image, plain)) << change.begin()->first;
}

TEST(TextureNetwork, modelMakesWhatItsTrainingMade) {
    const Request request = requestOf(blobs({48, 40}, 3), {70, 50});
    const Synthesis learned = made(request, quick());
    const auto model = learned.outputs.first<Model>(kPort);
    EXPECT_EQ(model->notes.at("iterations"), "4");
    EXPECT_EQ(model->notes.at("exemplar-size"), "48x40");
    EXPECT_EQ(model->notes.at("padding"), "none");
    EXPECT_EQ(model->notes.at("descriptor"), "own");
    const auto read = std::make_shared<const Model>(modelFromBytes(model->bytes(), "a file"));
    const Synthesis again = made(requestFrom(read, request.size), {});
    EXPECT_TRUE(samePixels(again.image, learned.image));
    EXPECT_TRUE(again.curves.empty()) << "nothing was trained";
    EXPECT_TRUE(again.notes.empty());
    EXPECT_EQ(*again.outputs.first<Model>(kPort), *model);
    Request beside = request;
    beside.inputs.set(kPort, read);
    const Synthesis same = made(beside, {});
    EXPECT_TRUE(samePixels(same.image, learned.image));
    ASSERT_EQ(same.notes.size(), 1U);
    EXPECT_THAT(same.notes.front().text(), HasSubstr("the exemplar is not looked at"));
}

TEST(TextureNetwork, modelOfTheUsualSizeIsUnderHalfAMegabyte) {
    const Synthesis learned = made(requestOf(blobs({48, 40}, 3), {8, 8}),
                                   {{"iterations", 1}, {"batch", 1}, {"loss", std::string("patches")}});
    EXPECT_LT(learned.outputs.first<Model>(kPort)->bytes().size(), 500'000U);
}

TEST(TextureNetwork, bundledModelHasItsExemplarsColours) {
    const auto model =
        std::make_shared<const Model>(readModel(bundled("../models/crazy_paving.safetensors")));
    EXPECT_LT(model->bytes().size(), 500'000U);
    const Image image = made(requestFrom(model, {256, 256}), {}).image;
    const Image exemplar = *loadExemplar(bundled("crazy_paving.png")).image;
    const std::vector<double> means = channelMeans(image), wanted = channelMeans(exemplar);
    const Eigen::MatrixXd spread = channelCovariance(image), wantedSpread = channelCovariance(exemplar);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(means[at(c)], wanted[at(c)], 0.5 * std::sqrt(wantedSpread(c, c)));
        EXPECT_GT(spread(c, c), 0.4 * wantedSpread(c, c));
        EXPECT_LT(spread(c, c), 2 * wantedSpread(c, c));
    }
}

TEST(TextureNetwork, anyPartAloneEqualsTheWholes) {
    const auto model = trained();
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{true, true}}) {
        Request request = requestFrom(model, {300, 275});
        request.wrap = wrap;
        const Image whole = made(request, {}).image;
        for (const Region& part :
             {Region{0, 0, {1, 1}}, Region{250, 120, {50, 155}}, Region{7, 11, {290, 3}}}) {
            request.region = part;
            EXPECT_TRUE(samePixels(made(request, {}, {.threads = 1}).image,
                                   whole.view().crop(part.x, part.y, part.size)));
        }
    }
    EXPECT_TRUE(samePixels(made(requestFrom(model, {90, 80}), {}).image,
                           made(requestFrom(model, {300, 275}), {}).image.view().crop(0, 0, {90, 80})))
        << "a larger texture begins with the smaller one";
}

TEST(TextureNetwork, seedsGiveTexturesThatHaveNothingInCommon) {
    const auto model = trained({{"iterations", 60}, {"rate", 0.05}});
    const Image one = made(requestFrom(model, {128, 128}, 1), {}).image;
    const Image two = made(requestFrom(model, {128, 128}, 2), {}).image;
    Image both({128, 128}, 2);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            both(x, y, 0) = one(x, y, 0);
            both(x, y, 1) = two(x, y, 0);
        }
    const Eigen::MatrixXd covariance = channelCovariance(both);
    ASSERT_GT(covariance(0, 0), 1e-6);
    EXPECT_LT(std::abs(covariance(0, 1)) / std::sqrt(covariance(0, 0) * covariance(1, 1)), 0.15);
}

TEST(TextureNetwork, trainedFurtherGoesOnFromTheModel) {
    Request request = requestOf(blobs({48, 48}, 3), {32, 32});
    const Values settings = quick({{"iterations", 60}, {"rate", 0.05}});
    const Synthesis first = made(request, settings);
    request.inputs.set(kPort, first.outputs.first<Model>(kPort));
    request.seed = 4;
    Values further = settings;
    further["further"] = true;
    const Synthesis second = made(request, further);
    EXPECT_LT(meanOf(second.curves.front().values, 0, 4), 0.5 * meanOf(first.curves.front().values, 0, 4));
    EXPECT_NE(*second.outputs.first<Model>(kPort), *first.outputs.first<Model>(kPort));
}

TEST(TextureNetwork, cancelledTrainingLeavesACheckpointToGoOnFrom) {
    const Request request = requestOf(blobs({48, 40}, 3), {40, 30});
    const Values settings = quick({{"iterations", 12}});
    const Values all = checked(textureNetwork(), request, settings);
    const Synthesis whole = made(request, settings);
    JobMonitor monitor;
    std::shared_ptr<const Checkpoint> last;
    JobOptions options{request.seed, 2};
    int kept = 0;
    options.keepEvery = std::chrono::milliseconds(0);
    options.keep = [&](const Checkpoint& checkpoint) {
        last = std::make_shared<const Checkpoint>(checkpoint);
        ++kept;
    };
    JobContext context(
        options, [&] { return kept == 5; }, monitor);
    EXPECT_THROW(textureNetwork().run(request, all, context), Cancelled);
    ASSERT_TRUE(last);
    JobOptions resumed{request.seed, 1};
    resumed.resumed = last;
    const Synthesis result = made(request, settings, resumed);
    EXPECT_TRUE(samePixels(result.image, whole.image));
    EXPECT_EQ(*result.outputs.first<Model>(kPort), *whole.outputs.first<Model>(kPort));
    EXPECT_EQ(result.curves.front().values, whole.curves.front().values);
}

TEST(TextureNetwork, stripsLearnOnceAndMakeTheWhole) {
    RunPlan plan = madeUpPlan("texture-network", quick(), {40, 30});
    std::vector<std::size_t> trainings;
    const auto make = [&trainings](const RunPlan& part) {
        JobMonitor monitor;
        JobContext context(
            {part.request.seed, 2, false}, [] { return false; }, monitor);
        Result result = runPlan(part, context);
        trainings.push_back(monitor.curves().size());
        return result;
    };
    const Image whole = make(plan).synthesis.image;
    plan.stripRows = 12;
    const TemporaryFolder folder;
    ExportOptions options;
    options.image = folder / "strips.exr";
    options.depth = Depth::Float;
    options.space = "raw";
    options.sidecar = false;
    trainings.clear();
    exportStrips(plan, options, make);
    EXPECT_THAT(trainings, testing::ElementsAre(1U, 0U, 0U));
    EXPECT_TRUE(samePixels(readImage(options.image).image, whole));
}

TEST(TextureNetwork, stoppedTrainingKeepsItsGenerator) {
    const Result result = stoppedAtOnce("texture-network", quick({{"iterations", 100000}}), {40, 30});
    ASSERT_TRUE(result.stoppedAt);
    EXPECT_LT(*result.stoppedAt, 0.5);
    EXPECT_EQ(result.synthesis.outputs.at(kPort).size(), 1U);
    EXPECT_EQ(result.synthesis.image.size(), (Size{40, 30}));
    EXPECT_THAT(result.synthesis.notes.front().text(), HasSubstr("of 100000 iterations"));
}

TEST(TextureNetwork, stepThatBreaksDownLeavesTheLastGoodGenerator) {
    JobMonitor monitor;
    JobContext context(
        {1, 1, false}, [] { return false; }, monitor);
    const GeneratorShape shape{2, 1, 3, 2, 3};
    GeneratorTraining training(GeneratorWeights::drawn(shape, 1), 9, context);
    std::shared_ptr<Model> good;
    const auto rate = [](int) { return 0.01; };
    training.run(
        [&](int number) {
            const Box box{0, 0, 0, {8, 8, 1}};
            Volume gradient = training.trainer().forward(box, GeneratorNoise(5), context);
            if (number == 3) {
                good = training.weights().model();
                gradient(2, 2, 0, 1) = std::numeric_limits<float>::quiet_NaN();
                // The statistics, too, are those of before.
                training.trainer().forward(box, GeneratorNoise(6), context);
            }
            training.trainer().backward(gradient, context);
            return 1.0;
        },
        rate);
    EXPECT_EQ(training.iterationsDone(), 3);
    EXPECT_THAT(training.notes().front().text(), HasSubstr("after 3 of 9 iterations"));
    EXPECT_THAT(training.notes().front().text(), HasSubstr("not numbers"));
    GeneratorWeights kept = training.weights();
    kept.everyRunning([](const std::string&, const std::vector<float>& values) {
        for (const float value : values)
            EXPECT_TRUE(std::isfinite(value));
    });
    ASSERT_TRUE(good);
    const std::string one = "scale0.joined.1.weights";
    EXPECT_EQ(kept.model()->arrays.at(one), good->arrays.at(one));
}

TEST(TextureNetwork, otherNumbersOfChannelsAreSeenByAnotherDescriptor) {
    for (const int channels : {1, 2, 5}) {
        const Synthesis result = made(requestOf(blobs({40, 40}, channels), {20, 16}), quick());
        EXPECT_EQ(result.image.channels(), channels);
        EXPECT_EQ(result.outputs.first<Model>(kPort)->notes.at("descriptor"),
                  channels == 1 ? "own" : "exemplar");
    }
}

TEST(TextureNetwork, refusesInASentence) {
    Request request = requestOf(blobs({15, 40}, 3), {32, 32});
    EXPECT_THAT(refusal(request, quick()), HasSubstr("15 × 40 px here; its sides must have at least 16 px"));
    request = requestOf(blobs({200, 30}, 3), {32, 32});
    EXPECT_THAT(refusal(request, quick({{"exemplar-side", 100}})), HasSubstr("100 × 15 px"));
    EXPECT_THAT(refusal(requestFrom(trained(), {8, 8}), {{"further", true}}),
                HasSubstr("neither an exemplar"));
    Request none;
    none.size = {8, 8};
    EXPECT_THAT(refusal(none, {}), HasSubstr("neither an exemplar to learn from nor a trained generator"));
    request = requestOf(blobs({40, 40}, 3), {32, 32});
    EXPECT_THAT(refusal(request, quick({{"further", true}})), HasSubstr("no generator to train further"));
    request.inputs.set(kPort, trained({{"loss", std::string("patches")}}, 1));
    EXPECT_THAT(refusal(request, quick()), HasSubstr("makes 1 channel, and the exemplar has 3"));
    auto other = std::make_shared<Model>(*trained());
    other->kind = "solid-generator";
    request.inputs.set(kPort, std::shared_ptr<const Model>(other));
    EXPECT_THAT(refusal(request, quick()), HasSubstr("solid-generator"));
    request = requestOf(blobs({20, 20}, 3), {32, 32});
    EXPECT_THAT(refusal(request, quick({{"train-size", 16}, {"levels", 4}})), HasSubstr("px"));
}

} // namespace
} // namespace texloom::test::texture_network_tests

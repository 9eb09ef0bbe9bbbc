// Companion maps that count where pieces of methods that copy pixels are compared, joined and cut.

#include "core/session/run/companion_stack.h"
#include "core/session/run/run.h"
#include "tests/core/session/sample_run.h"
#include "tests/support/says.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace texloom {
namespace {

using test::SampleRun;
using test::says;

/// A run of an exemplar that says nothing, with a companion that has structure.
struct SilentRun : SampleRun {
    explicit SilentRun(const std::string& method) {
        input.steps.front() = {method, {}};
        const Image grey = test::constant({64, 64}, 3, 0.5F);
        writeImage(folder / "silent.png", grey, {});
        input.exemplars = {{loadExemplar(folder / "silent.png"), {}, {}}};
        input.size = {96, 96};
        addCompanion("silent_height", {64, 64});
    }

    Result weighed(double weight) {
        input.steps.front().parameters[std::string(kCompanionWeight)] = weight;
        return run();
    }
};

/// The mean square of the differences of neighbours.
double roughness(const Image& image) {
    double sum = 0;
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 1; y < image.height(); ++y)
            for (int x = 1; x < image.width(); ++x) {
                const auto here = static_cast<double>(image(x, y, c));
                sum += std::pow(here - static_cast<double>(image(x - 1, y, c)), 2) +
                       std::pow(here - static_cast<double>(image(x, y - 1, c)), 2);
            }
    return sum / static_cast<double>(image.size().area() * image.channels());
}

class CompanionWeight : public testing::TestWithParam<std::string> {};

TEST_P(CompanionWeight, joinsMapsWhereTheImageSaysNothing) {
    SilentRun sample(GetParam());
    const Image& map = *sample.input.exemplars.front().companions.front().image;
    const double own = roughness(map);
    const double without = roughness(sample.weighed(0).companion(0)) - own;
    const Result result = sample.weighed(1);
    EXPECT_LT(roughness(result.companion(0)) - own, 0.5 * without);
    EXPECT_EQ(result.synthesis.image.channels(), 3);
    EXPECT_EQ(result.companion(0).channels(), map.channels());
    for (const Picture& picture : result.synthesis.pictures)
        EXPECT_LE(picture.image.channels(), 4) << picture.name.text();
}

INSTANTIATE_TEST_SUITE_P(Methods, CompanionWeight,
                         testing::Values("quilting", "graph-cut", "patchmatch", "efros-leung", "near-regular",
                                         "wang-tiles"),
                         [](const testing::TestParamInfo<std::string>& tested) {
                             std::string name = tested.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(CompanionWeight, of0MakesTheBitsOfARunWithoutMaps) {
    for (const char* method : {"quilting", "graph-cut", "patchmatch"}) {
        SampleRun sample;
        sample.input.steps.front() = {method, {}};
        const Result alone = sample.run();
        sample.addCompanion("bark_height", {48, 44});
        const Result with = sample.run();
        EXPECT_TRUE(samePixels(alone.synthesis.image, with.synthesis.image)) << method;
        EXPECT_EQ(alone.synthesis.map, with.synthesis.map) << method;
        sample.input.steps.front().parameters[std::string(kCompanionWeight)] = 1.0;
        EXPECT_FALSE(alone.synthesis.map == sample.run().synthesis.map) << method;
    }
}

/// The variance of channels, summed over them.
double variance(const ImageView& image) {
    double all = 0;
    for (int c = 0; c < image.channels; ++c) {
        double sum = 0, squares = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                sum += static_cast<double>(image(x, y, c));
                squares += std::pow(static_cast<double>(image(x, y, c)), 2);
            }
        const auto pixels = static_cast<double>(image.size().area());
        all += squares / pixels - std::pow(sum / pixels, 2);
    }
    return all;
}

TEST(CompanionWeight, isTheShareOfAllMapsTogetherInTheVariance) {
    SampleRun sample;
    sample.addCompanion("bark_normal", {48, 44});
    sample.addCompanion("bark_height", {48, 44});
    writeImage(sample.folder / "flat.png", test::constant({48, 44}, 1, 0.25F), {});
    std::vector<ExemplarFile>& companions = sample.input.exemplars.front().companions;
    companions.push_back(loadData(sample.folder / "flat.png"));
    const Image stack = *stackedExemplars(sample.input.exemplars, {true, 0.6}).front();
    ASSERT_EQ(stack.channels(), 10);
    const double image = variance(stack.view().channelRange(0, 3));
    EXPECT_NEAR(variance(stack.view().channelRange(3, 3)), 0.3 * image, 1e-4 * image);
    EXPECT_NEAR(variance(stack.view().channelRange(6, 3)), 0.3 * image, 1e-4 * image);
    EXPECT_EQ(stack(3, 4, 9), (*companions.back().image)(3, 4, 0));
    const Image plain = *stackedExemplars(sample.input.exemplars, {true}).front();
    EXPECT_EQ(plain(3, 4, 5), (*companions.front().image)(3, 4, 2));
}

TEST(CompanionWeight, SaysThatAnImageToStartFromHasNoMaps) {
    SampleRun sample;
    sample.addCompanion("bark_height", {48, 44});
    RecipeFile file;
    file.path = sample.write("start", sample.input.size, 3);
    const InputFile start = loadInput(portOf(sample.input.steps, kInitialPort), file, {});
    sample.input.inputs[std::string(kInitialPort)] = {start};
    sample.input.steps.front().parameters[std::string(kCompanionWeight)] = 1.0;
    const RunPlan plan = planRun(sample.input);
    EXPECT_EQ(plan.request.channels(), 3);
    ASSERT_EQ(plan.notes.size(), 1U);
    EXPECT_THAT(plan.notes.front(), says("no companion maps"));
}

} // namespace
} // namespace texloom

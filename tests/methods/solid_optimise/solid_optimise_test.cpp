// Solids whose slices look like exemplars.

#include "core/match/tap_sums.h"
#include "core/methods/method.h"
#include "core/methods/solid_request.h"
#include "core/volume/volume_source.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::solid_optimise_tests {
namespace {

Request requestFor(std::vector<Image> exemplars) {
    Request request;
    for (Image& exemplar : exemplars)
        request.exemplars.push_back({"made up", std::make_shared<const Image>(std::move(exemplar))});
    request.size = {32, 32};
    request.seed = 3;
    return request;
}

Synthesis made(const Request& request, const Values& settings) {
    return resultOf(findMethod("solid-optimise"), request, settings);
}

Volume solidOf(const Synthesis& synthesis, int side) {
    JobMonitor monitor;
    JobContext context(
        {0, 2, false}, [] { return false; }, monitor);
    return synthesis.outputs.first<VolumeSource>("volume")->sample({0, 0, 0, {side, side, side}}, context);
}

/// Light and dark columns, 4 px wide.
Image columns() {
    Image image({32, 32}, 1);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            image(x, y, 0) = x / 4 % 2 == 0 ? 0.2F : 0.8F;
    return image;
}

/// Mean square difference between voxels that follow each other along an axis.
double changeAlong(const Volume& solid, const SliceVoxel& step) {
    const int side = solid.width();
    double sum = 0;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                sum += std::pow(static_cast<double>(
                                    solid((x + step.x) % side, (y + step.y) % side, (z + step.z) % side, 0)) -
                                    static_cast<double>(solid(x, y, z, 0)),
                                2);
    return sum / (side * side * side);
}

TEST(SumTaps, addsInTheOrderOfTheTaps) {
    const Image image = noise({75, 5}, 1);
    const float weights[] = {0.5F, -2, 0.25F};
    const float* taps[] = {image.view().plane(0).row(0) + 1, image.view().plane(0).row(3),
                           image.view().plane(0).row(2) + 2};
    float found[70];
    sumTaps(taps, weights, 3, 70, found);
    for (int i = 0; i < 70; ++i)
        EXPECT_EQ(found[i],
                  (0 + weights[0] * taps[0][i] + weights[1] * taps[1][i]) + weights[2] * taps[2][i]);
}

TEST(SliceGoals, turnAndShareExemplarsAsTheSettingsSay) {
    SliceSettings settings;
    const Request request = requestFor({noise({20, 30}, 1, 1), noise({24, 24}, 1, 2)});
    settings.turnZ = SliceTurn::Right;
    settings.exemplarX = SliceExemplar::Free;
    const std::vector<SliceGoal> goals = sliceGoals(request, settings, [] {});
    ASSERT_EQ(goals.size(), 2U);
    EXPECT_EQ(goals[0].axis, Axis::Y);
    EXPECT_TRUE(samePixels(goals[0].exemplar, *request.exemplars[1].image)) << "y has the second of its own";
    EXPECT_EQ(goals[1].exemplar.size(), (Size{30, 20}));
    EXPECT_EQ(goals[1].exemplar(29, 0, 0), (*request.exemplars[0].image)(0, 0, 0))
        << "the top left goes to the right";
    EXPECT_EQ(sliceGoalSizes(request, settings)[1], (Size{30, 20}));
}

TEST(SolidOptimise, columnsOfTwoDirectionsAreConstantAlongTheirLength) {
    // Columns stand on y in slices square to x and to z; seen from above, along y, nothing is wanted.
    for (const char* model : {"patch-distribution", "kopf"}) {
        const Values settings = {{"model", std::string(model)},
                                 {"side", 32},
                                 {"iterations", 15},
                                 {"exemplar-y", std::string("free")}};
        const Volume solid = solidOf(made(requestFor({columns()}), settings), 32);
        EXPECT_LT(changeAlong(solid, {0, 1, 0}), 0.2 * changeAlong(solid, {1, 0, 0})) << model;
    }
}

TEST(SolidOptimise, hasTheExemplarsColours) {
    const Image exemplar = blobs({48, 48}, 3);
    const std::vector<double> wanted = channelMeans(exemplar);
    for (const char* model : {"patch-distribution", "heeger-bergen", "kopf", "wei"}) {
        const Volume solid = solidOf(
            made(requestFor({exemplar}), {{"model", std::string(model)}, {"side", 24}, {"iterations", 6}}),
            24);
        for (int c = 0; c < 3; ++c) {
            double mean = 0;
            for (int z = 0; z < 24; ++z)
                for (int y = 0; y < 24; ++y)
                    for (int x = 0; x < 24; ++x)
                        mean += static_cast<double>(solid(x, y, z, c)) / (24 * 24 * 24);
            EXPECT_NEAR(mean, wanted[static_cast<std::size_t>(c)], 0.08) << model;
        }
    }
}

TEST(SolidOptimise, comesCloserToTheExemplar) {
    const Synthesis synthesis =
        made(requestFor({blobs({48, 48}, 3)}), {{"side", 24}, {"iterations", 12}, {"scales", 1}});
    const std::vector<double>& distances = synthesis.curves.front().values;
    EXPECT_LT(distances.back(), 0.7 * distances.front());
}

TEST(SolidOptimise, refusesWhatCannotBe) {
    const Method& method = findMethod("solid-optimise");
    const Request request = requestFor({blobs({48, 48}, 3)});
    EXPECT_THAT(refusalOf(method, request, {{"exemplar-x", std::string("third")}}),
                testing::HasSubstr("exemplar 3"));
    EXPECT_THAT(refusalOf(method, request, {{"weight-x", 0.0}, {"weight-y", 0.0}, {"weight-z", 0.0}}),
                testing::HasSubstr("free"));
    EXPECT_THAT(refusalOf(method, requestFor({blobs({9, 48}, 3)}), {}), testing::HasSubstr("9 × 48 px"));
}

} // namespace
} // namespace texloom::test::solid_optimise_tests

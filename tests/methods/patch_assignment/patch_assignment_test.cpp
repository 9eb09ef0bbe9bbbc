#include "core/analysis/map_usage.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::patch_assignment_tests {

namespace {

Synthesis made(const Request& request, const Values& settings) {
    return resultOf(findMethod("patch-assignment"), request, settings);
}

/// Uses of patches beyond their share, over the whole output.
double tooMany(const Synthesis& result) {
    return result.figures.front().value;
}

/// A texture that is black over a large part.
Image partlyFlat(Size size) {
    Image image = blobs(size, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = size.height / 5; y < size.height * 4 / 5; ++y)
            for (int x = size.width / 5; x < size.width * 4 / 5; ++x)
                image(x, y, c) = 0;
    return image;
}

const Values kShort = {{"coarse-iterations", 8}, {"fine-iterations", 5}};
const Values kOneScale = {{"scales", 1}, {"fine-iterations", 12}};

} // namespace

TEST(PatchAssignment, energyNeverRisesWithinAScale) {
    const Synthesis result = made(requestOf(blobs({48, 48}, 3), {48, 48}), kOneScale);
    const std::vector<double>& energy = result.curves.front().values;
    ASSERT_GE(energy.size(), 3U);
    for (std::size_t i = 1; i < energy.size(); ++i)
        EXPECT_LE(energy[i], energy[i - 1] * (1 + 1e-5)) << "iteration " << i;
}

TEST(PatchAssignment, keepsTheColoursThatNearestPatchesLose) {
    // A few bright dots on grey: nearest neighbours prefer the grey.
    Image dots = constant({48, 48}, 1, 0.3F);
    for (int y = 4; y < 48; y += 12)
        for (int x = 4; x < 48; x += 12)
            for (int v = 0; v < 3; ++v)
                for (int u = 0; u < 3; ++u)
                    dots(x + u, y + v, 0) = 1;
    const Request request = requestOf(dots, {48, 48});
    const double wanted = channelMeans(dots)[0] - 0.3;
    const double assigned = channelMeans(made(request, kShort).image)[0] - 0.3;
    const double nearest =
        channelMeans(made(request, with(kShort, {{"relaxed", true}, {"rho", 0.0}})).image)[0] - 0.3;
    EXPECT_GT(assigned, 0.5 * wanted);
    EXPECT_LT(nearest, assigned);
}

TEST(PatchAssignment, nearOptimalCostIsAboveTheExactByEpsilonAtMost) {
    const Request request = requestOf(blobs({64, 64}, 3), {64, 64});
    const Values once = {{"scales", 1}, {"fine-iterations", 1}};
    const ValueRange range = valueRange(*request.exemplars.front().image);
    const double exact = made(request, once).curves.front().values.front();
    const double near = made(request, with(once, {{"epsilon", 0.5}})).curves.front().values.front();
    EXPECT_GE(near, exact * (1 - 1e-6));
    EXPECT_LE(near, exact + 0.5 * static_cast<double>(range.largest - range.smallest) + 1e-3);
}

TEST(PatchAssignment, everyPatchIsUsedAsOftenAsTheExemplarHasIt) {
    for (const Image& exemplar : {blobs({48, 48}, 3), partlyFlat({48, 48})})
        for (const Size size : {Size{48, 48}, Size{96, 96}, Size{70, 58}}) {
            const Request request = requestOf(exemplar, size);
            for (const Values& more : std::vector<Values>{{},
                                                          {{"solve", std::string("whole")}},
                                                          {{"epsilon", 1.0}},
                                                          {{"relaxed", true}, {"rho", 60.0}}})
                EXPECT_EQ(tooMany(made(request, with(kShort, more))), 0) << size.width;
            EXPECT_GT(tooMany(made(request, with(kShort, {{"relaxed", true}, {"rho", 0.0}}))), 0);
        }
}

TEST(PatchAssignment, narrowedIsSaidAndComesNearTheWhole) {
    const Request request = requestOf(blobs({48, 48}, 3), {64, 64});
    const Synthesis whole = made(request, with(kShort, {{"solve", std::string("whole")}}));
    const Synthesis narrowed = made(request, with(kShort, {{"solve", std::string("narrowed")}}));
    EXPECT_TRUE(whole.notes.empty());
    ASSERT_EQ(narrowed.notes.size(), 1U);
    EXPECT_LT(tooMany(narrowed), 0.2 * 32 * 32);
}

TEST(PatchAssignment, runsGoOnToTheLastRoundWhereNothingIsSettled) {
    const Request request = requestOf(blobs({64, 64}, 3), {64, 64});
    const Values near = with(kOneScale, {{"epsilon", 2.0}});
    const auto rounds = [&](const Values& more) {
        return made(request, with(near, more)).curves.front().values.size();
    };
    EXPECT_LT(rounds({}), rounds({{"settle", 0.0}, {"constant-epsilon", true}}));
}

TEST(PatchAssignment, theMeanIsTheSmoothestAggregation) {
    const Request request = requestOf(noise({48, 48}, 3), {48, 48});
    const auto variance = [&](const char* aggregation) {
        const Image image = made(request, with(kShort, {{"aggregation", std::string(aggregation)}})).image;
        double square = 0;
        const double mean = channelMeans(image)[0];
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x)
                square += std::pow(static_cast<double>(image(x, y, 0)) - mean, 2);
        return square;
    };
    const double mean = variance("mean");
    EXPECT_LT(mean, variance("median"));
    EXPECT_LT(mean, variance("robust"));
    EXPECT_LT(mean, variance("robust-falloff"));
}

TEST(PatchAssignment, everySwitchGivesASoundResult) {
    const Request request = requestOf(blobs({40, 44}, 3), {60, 50});
    const Image plain = made(request, kShort).image;
    const ValueRange range = valueRange(*request.exemplars.front().image);
    const std::vector<Values> switches = {
        {{"grid", std::string("random")}}, {{"grid", std::string("hybrid")}},      {{"epsilon", 2.0}},
        {{"relaxed", true}, {"rho", 1.0}}, {{"supply", std::string("bootstrap")}}, {{"patch", 12}},
        {{"finish", std::string("copy")}}};
    for (const Values& settings : switches) {
        const Image image = made(request, with(kShort, settings)).image;
        EXPECT_FALSE(samePixels(image, plain)) << settings.begin()->first;
        EXPECT_GE(valueRange(image).smallest, range.smallest - 1e-4F);
        EXPECT_LE(valueRange(image).largest, range.largest + 1e-4F);
    }
}

TEST(PatchAssignment, maskSaysHowOftenPatchesAreUsed) {
    Request request = requestOf(blobs({64, 64}, 3), {64, 64});
    Image mask = constant({64, 64}, 1, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            mask(x, y, 0) = x < 20 ? 0.0F : x < 40 ? 0.2F : 1.0F;
    request.exemplars.front().inputs.set(kMaskPort, std::make_shared<const Image>(mask));
    const Synthesis result = made(request, kShort);
    const Image use = occurrence(result.map, 0);
    const auto mean = [&](int left, int right) {
        double sum = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = left; x < right; ++x)
                sum += static_cast<double>(use(x, y, 0));
        return sum / (64 * (right - left));
    };
    EXPECT_EQ(mean(0, 20), 0);
    EXPECT_LT(mean(26, 34), 0.5 * mean(46, 60));
    EXPECT_GT(mean(26, 34), 0);
}

TEST(PatchAssignment, copyHasAnExactMap) {
    const Request request = requestOf(blobs({48, 48}, 3), {70, 60});
    const Synthesis result = made(request, with(kShort, {{"finish", std::string("copy")}}));
    EXPECT_EQ(result.mapKind, MapKind::Exact);
    EXPECT_TRUE(samePixels(result.map.apply(request.exemplars.front().image->view()), result.image));
}

} // namespace texloom::test::patch_assignment_tests

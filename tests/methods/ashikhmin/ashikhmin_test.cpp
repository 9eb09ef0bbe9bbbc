#include "core/job/job.h"
#include "core/methods/ashikhmin/synthesizer.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace texloom::test::ashikhmin_tests {
namespace {

using ashikhmin::kTargetPort;
using ashikhmin::Settings;
using ashikhmin::Synthesizer;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

Request requestFor(Image exemplar, Size output, Wrap wrap = {}) {
    return requestOf(std::move(exemplar), output, wrap, 5);
}

Synthesis made(const Request& request, const Settings& settings, int threads = 2,
               ScanOrder::Order order = ScanOrder::Order::Wavefront) {
    Job<Synthesis> job({request.seed, threads, false}, [&](JobContext& context) {
        return Synthesizer(request, settings, context).run(order);
    });
    return std::get<Synthesis>(job.take());
}

TEST(CoherentCandidates, areAtMostAsManyAsTheNeighbours) {
    PositionMap map({30, 30}, {{100, 100}});
    const Random random(1);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 30; ++x)
            map.at(x, y) = {static_cast<std::uint16_t>(random.below(100, x, y)),
                            static_cast<std::uint16_t>(random.below(100, x, y, 1)), 0};
    std::vector<Continuation> found;
    for (const int side : {3, 5, 9}) {
        coherentCandidates(map, causalRuns(side), 15, 15, {}, found);
        EXPECT_LE(static_cast<int>(found.size()), (side * side - 1) / 2);
        EXPECT_GE(static_cast<int>(found.size()), (side * side - 1) / 2 - 2);
        coherentCandidates(map, causalRuns(side), 0, 0, {}, found);
        EXPECT_TRUE(found.empty());
        coherentCandidates(map, causalRuns(side), 0, 0, {true, true}, found);
        EXPECT_FALSE(found.empty());
    }
}

TEST(CoherentCandidates, copyWithOneOffsetHasOneContinuation) {
    PositionMap map({20, 20}, {{100, 100}});
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x)
            map.at(x, y) = {static_cast<std::uint16_t>(x + 30), static_cast<std::uint16_t>(y + 7), 0};
    std::vector<Continuation> found;
    coherentCandidates(map, causalRuns(9), 11, 9, {}, found);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().source(), (Source{41, 16, 0}));
}

TEST(Ashikhmin, resultTakesTheShapeOfTheTarget) {
    // Half dark, half bright, in an exemplar that is so from left to right and a target that is from top to
    // bottom.
    Image exemplar = blobs({64, 64}, 1), target({60, 60}, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            exemplar(x, y, 0) += x < 32 ? 0.0F : 3.0F;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x)
            target(x, y, 0) = y < 30 ? 3.5F : 0.5F;
    Request request = requestFor(exemplar, target.size());
    request.inputs.set(kTargetPort, shared(target));
    const auto right = [&](double weight) {
        Settings settings;
        settings.neighbourhood = 5;
        settings.targetWeight = weight;
        settings.jump = 1;
        settings.passes = 3;
        const Image image = made(request, settings).image;
        int count = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 60; ++x)
                count += (image(x, y, 0) > 2) == (target(x, y, 0) > 2);
        return count;
    };
    EXPECT_GT(right(10), 60 * 60 * 85 / 100);
    EXPECT_GT(right(10), right(0));
}

/// Where the target is a piece of the exemplar, that piece is the one picture whose every term is zero.
TEST(Ashikhmin, targetCutOutOfTheExemplarIsGivenBack) {
    const Image exemplar = blobs({40, 36}, 3);
    const Size size{24, 20};
    const Source corner{7, 6, 0};
    Image target(size, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 3; ++c)
                target(x, y, c) = exemplar(corner.x + x, corner.y + y, c);
    Request request = requestFor(exemplar, size);
    request.inputs.set(kTargetPort, shared(target));
    Settings settings;
    settings.neighbourhood = 9;
    settings.targetWeight = 10;
    settings.jump = 1;
    settings.passes = 10;
    const Synthesis result = made(request, settings);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            ASSERT_EQ(result.map.at(x, y), (Source{static_cast<std::uint16_t>(corner.x + x),
                                                   static_cast<std::uint16_t>(corner.y + y), 0}))
                << x << ", " << y;
    EXPECT_TRUE(samePixels(result.image, target));
}

/// The shares of pixels whose left neighbour's source is the one to the left of theirs.
double continued(const PositionMap& map) {
    int count = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 1; x < map.width(); ++x)
            count += map.at(x, y).x == map.at(x - 1, y).x + 1 && map.at(x, y).y == map.at(x - 1, y).y;
    return count / static_cast<double>(map.size().area());
}

TEST(Ashikhmin, piecesGrowAndStayThroughMorePasses) {
    const Request request = requestFor(blobs({64, 64}, 2), {60, 60});
    Settings settings;
    settings.passes = 1;
    const double first = continued(made(request, settings).map);
    EXPECT_GT(first, 0.5);
    settings.passes = 6;
    EXPECT_GT(continued(made(request, settings).map), first - 0.1);
}

TEST(Ashikhmin, wavefrontGivesThePixelsOfRasterOrder) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}})
        for (const int passes : {1, 3})
            for (const Size size : {Size{120, 77}, Size{20, 60}, Size{5, 5}, Size{1, 40}, Size{90, 3}}) {
                const Request request = requestFor(blobs({40, 40}, 3), size, wrap);
                Settings settings;
                settings.neighbourhood = 7;
                settings.passes = passes;
                settings.jump = 0.1;
                const Synthesis raster = made(request, settings, 1, ScanOrder::Order::Raster);
                for (const int threads : {1, 2, 5}) {
                    const Synthesis wavefront = made(request, settings, threads);
                    EXPECT_TRUE(samePixels(raster.image, wavefront.image))
                        << size.width << " × " << size.height;
                    EXPECT_EQ(raster.map, wavefront.map);
                }
            }
}

TEST(Ashikhmin, everyPixelContinuesANeighbourOrTheExemplarEnded) {
    const Request request = requestFor(blobs({50, 50}, 3), {90, 90});
    Settings settings;
    settings.passes = 1;
    const PositionMap map = made(request, settings).map;
    std::vector<Continuation> found;
    int strays = 0;
    for (int y = 1; y < 90; ++y)
        for (int x = 1; x < 90; ++x) {
            coherentCandidates(map, causalRuns(9), x, y, {}, found);
            const Source source = map.at(x, y);
            const bool coherent = std::any_of(
                found.begin(), found.end(), [&](const Continuation& one) { return one.source() == source; });
            const bool ended = std::any_of(found.begin(), found.end(), [&](const Continuation& one) {
                return one.x < 4 || one.y < 4 || one.x >= 46 || one.y >= 46;
            });
            strays += !coherent && !ended;
        }
    EXPECT_EQ(strays, 0);
}

TEST(Ashikhmin, jumpsMakeSmallerPieces) {
    const Request request = requestFor(blobs({64, 64}, 3), {120, 120});
    Settings still, jumping;
    jumping.jump = 1;
    EXPECT_LT(continued(made(request, jumping).map), continued(made(request, still).map));
}

TEST(Ashikhmin, refusalsNameTheValueAndTheLimit) {
    EXPECT_THAT(
        refusalOf(findMethod("ashikhmin"), requestFor(blobs({12, 30}, 3), {64, 64}), {{"neighbourhood", 13}}),
        testing::AllOf(testing::HasSubstr("13 px"), testing::HasSubstr("at most 11 px")));
}

} // namespace
} // namespace texloom::test::ashikhmin_tests

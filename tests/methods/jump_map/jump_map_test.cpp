#include "core/job/job.h"
#include "core/methods/jump_map/walker.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::jump_map_tests {
namespace {

using jump_map::Jump;
using jump_map::JumpLists;
using jump_map::Settings;
using jump_map::Walker;

Request requestFor(Image exemplar, Size output, Wrap wrap = {}) {
    return requestOf(std::move(exemplar), output, wrap, 5);
}

Synthesis walked(const Request& request, const Settings& settings, int threads = 2,
                 ScanOrder::Order order = ScanOrder::Order::Wavefront) {
    Job<Synthesis> job({request.seed, threads, false},
                       [&](JobContext& context) { return Walker(request, settings, context).run(order); });
    return std::get<Synthesis>(job.take());
}

TEST(JumpLists, leadToPlacesThatLookAlikeAndLieApart) {
    // Two tiles' noise: every place looks exactly like those a period away.
    const Image image = periodic({60, 60}, {12, 12}, 1);
    Interleaved pixels(image.size(), 1);
    pixels.load(image, 0, 0, image.size());
    NeighbourhoodSource source;
    source.pictures.push_back(&pixels);
    const NeighbourhoodSet set(Neighbourhood({{squareRuns(5), false, {}}}, {1}), {source}, [] {});
    JobMonitor monitor;
    JobContext context(
        {1, 2, false}, [] { return false; }, monitor);
    context.stage(1, "testing");
    const JumpLists lists(set, 4, 10, context);
    for (const Source& from : set.sources()) {
        const std::span<const Jump> jumps = lists.of(from);
        ASSERT_FALSE(jumps.empty());
        for (std::size_t i = 0; i < jumps.size(); ++i) {
            ASSERT_EQ((jumps[i].to.x - from.x) % 12, 0);
            ASSERT_EQ((jumps[i].to.y - from.y) % 12, 0);
            ASSERT_EQ(jumps[i].likeness, 1);
            for (std::size_t j = 0; j <= i; ++j) {
                const Source& other = j < i ? jumps[j].to : from;
                ASSERT_GE(std::hypot(jumps[i].to.x - other.x, jumps[i].to.y - other.y), 10);
            }
        }
    }
}

TEST(JumpMap, periodIsContinued) {
    const Image exemplar = periodic({64, 63}, {8, 9}, 2);
    Settings settings;
    settings.jump = 0.5;
    const Image image = walked(requestFor(exemplar, {150, 140}), settings).image;
    int broken = 0;
    for (int y = 0; y + 9 < 140; ++y)
        for (int x = 0; x + 8 < 150; ++x)
            broken += image(x, y, 0) != image(x + 8, y, 0) || image(x, y, 0) != image(x, y + 9, 0);
    EXPECT_EQ(broken, 0);
}

/// The share of pixels that continue their left neighbour's copy.
double continued(const PositionMap& map) {
    int count = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 1; x < map.width(); ++x)
            count += map.at(x, y).x == map.at(x - 1, y).x + 1 && map.at(x, y).y == map.at(x - 1, y).y;
    return count / static_cast<double>(map.size().area());
}

TEST(JumpMap, likelierJumpsCopySmallerPieces) {
    const Request request = requestFor(blobs({64, 64}, 3), {150, 150});
    Settings still, jumping;
    still.jump = 0;
    jumping.jump = 1;
    const double few = continued(walked(request, still).map), many = continued(walked(request, jumping).map);
    EXPECT_GT(few, 0.8);
    EXPECT_LT(many, few - 0.1);
}

TEST(JumpMap, wavefrontGivesThePixelsOfRasterOrder) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}})
        for (const Size size : {Size{120, 77}, Size{20, 60}, Size{5, 5}, Size{1, 40}, Size{90, 3}}) {
            const Request request = requestFor(blobs({40, 40}, 3), size, wrap);
            const Synthesis raster = walked(request, {}, 1, ScanOrder::Order::Raster);
            for (const int threads : {1, 2, 5}) {
                const Synthesis wavefront = walked(request, {}, threads);
                EXPECT_TRUE(samePixels(raster.image, wavefront.image)) << size.width << " × " << size.height;
                EXPECT_EQ(raster.map, wavefront.map);
            }
        }
}

} // namespace
} // namespace texloom::test::jump_map_tests

#include "core/base/error.h"
#include "core/job/job.h"
#include "core/math/grid_flow.h"
#include "core/methods/cut_canvas.h"
#include "core/methods/method.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace texloom::test::graph_cut_tests {
namespace {

using graph_cut::Canvas;
using graph_cut::Patch;
using graph_cut::SeamCost;
using graph_cut::Step;

/// Runs `work` with a context.
template <class Work> void inJob(const Work& work) {
    Job<int> job({3, 2, false}, [&](JobContext& context) {
        work(context);
        return 0;
    });
    ASSERT_TRUE(std::holds_alternative<int>(job.take()));
}

Synthesis made(const Request& request, const Values& settings = {}) {
    return resultOf(findMethod("graph-cut"), request, settings);
}

/// The cost of all seams of a map, in the whole numbers that cuts are made with.
std::int64_t seamsOf(const PositionMap& map, const SeamCost& cost) {
    std::int64_t sum = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
            if (x + 1 < map.width() && map.at(x, y).valid() && map.at(x + 1, y).valid())
                sum += cost.capacity(map.at(x, y), map.at(x + 1, y), Step{1, 0});
            if (y + 1 < map.height() && map.at(x, y).valid() && map.at(x, y + 1).valid())
                sum += cost.capacity(map.at(x, y), map.at(x, y + 1), Step{0, 1});
        }
    return sum;
}

TEST(GraphCut, cutIsTheBestOfAllLabellings) {
    // Two patches lie side by side with an old seam; a third covers the middle 3 × 4 of them and a column
    // that is new. All 2^12 ways to take its pixels are tried.
    for (std::uint64_t seed = 1; seed < 12; ++seed) {
        const Request request = requestOf(noise({12, 12}, 2, seed), {7, 4});
        inJob([&](JobContext& context) {
            Canvas canvas(request, true);
            canvas.paste({0, -3, -2, {0, 0, {3, 4}}}, nullptr, context);
            canvas.paste({0, 1, -6, {3, 0, {3, 4}}}, nullptr, context);
            const PositionMap before = canvas.map();
            const SeamCost cost(request, true);
            const Patch patch{0, 0, -5, {3, 0, {4, 4}}};
            std::int64_t best = std::numeric_limits<std::int64_t>::max();
            for (int labels = 0; labels < 1 << 12; ++labels) {
                PositionMap map = before;
                for (int i = 0; i < 16; ++i) {
                    const int x = 3 + i / 4, y = i % 4;
                    if (i >= 12 || (labels >> i & 1) != 0)
                        map.at(x, y) = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y + 5), 0};
                }
                best = std::min(best, seamsOf(map, cost));
            }
            const std::int64_t untouched = [&] {
                // Seams that no labelling changes: those left of the patch's neighbours.
                PositionMap left = before;
                left.shrink({3, 4});
                return seamsOf(left, cost);
            }();
            const std::int64_t value = canvas.paste(patch, nullptr, context);
            EXPECT_EQ(seamsOf(canvas.map(), cost), best) << seed;
            EXPECT_EQ(value, best - untouched) << seed;
        });
    }
}

TEST(GraphCut, seamNodesLetOldSeamsStayOrGo) {
    for (std::uint64_t seed = 1; seed < 9; ++seed) {
        const Request request = requestOf(noise({12, 12}, 1, seed), {6, 2});
        inJob([&](JobContext& context) {
            Canvas canvas(request, false);
            canvas.paste({0, -4, 0, {0, 0, {3, 2}}}, nullptr, context);
            canvas.paste({0, 2, -7, {3, 0, {3, 2}}}, nullptr, context);
            const PositionMap before = canvas.map();
            const SeamCost cost(request, false);
            std::int64_t best = std::numeric_limits<std::int64_t>::max();
            for (int labels = 0; labels < 1 << 8; ++labels) {
                PositionMap map = before;
                for (int i = 0; i < 8; ++i)
                    if ((labels >> i & 1) != 0 || i == 3)
                        map.at(1 + i / 2, i % 2) = {static_cast<std::uint16_t>(2 + i / 2),
                                                    static_cast<std::uint16_t>(8 + i % 2), 0};
                best = std::min(best, seamsOf(map, cost));
            }
            canvas.paste(
                {0, -1, -8, {1, 0, {4, 2}}}, [](int x, int y) { return x == 2 && y == 1; }, context);
            EXPECT_EQ(seamsOf(canvas.map(), cost), best) << seed;
        });
    }
}

TEST(GraphCut, pasteThatFitsLeavesNoSeam) {
    const Image exemplar = blobs({40, 30}, 3);
    const Request request = requestOf(exemplar, {36, 28});
    inJob([&](JobContext& context) {
        Canvas canvas(request, true);
        canvas.paste({0, -2, -1, {-2, -1, {20, 30}}}, nullptr, context);
        EXPECT_EQ(canvas.paste({0, -2, -1, {8, -1, {30, 30}}}, nullptr, context), 0);
        EXPECT_EQ(canvas.totalCost(context), 0);
        EXPECT_TRUE(samePixels(canvas.image(), exemplar.view().crop(2, 1, {36, 28})));
    });
}

TEST(GraphCut, refinementNeverMakesSeamsCostMore) {
    for (const char* placement : {"random", "entire", "sub-patch"}) {
        const Synthesis result = made(requestOf(blobs({48, 48}, 3), {120, 100}),
                                      {{"placement", std::string(placement)}, {"refine", 25}, {"patch", 16}});
        ASSERT_EQ(result.curves.size(), 1U);
        const std::vector<double>& costs = result.curves.front().values;
        for (std::size_t i = 1; i < costs.size(); ++i)
            EXPECT_LE(costs[i], costs[i - 1] * (1 + 1e-6)) << placement;
        if (placement == std::string("random")) {
            EXPECT_LT(costs.back(), costs.front());
        }
    }
}

TEST(GraphCut, periodicExemplarIsContinuedWithoutASeam) {
    const Image exemplar = periodic({48, 45}, {8, 9}, 1);
    for (const char* placement : {"entire", "sub-patch"}) {
        const Synthesis result =
            made(requestOf(exemplar, {120, 90}),
                 {{"placement", std::string(placement)}, {"tolerance", 0.001}, {"patch", 16}, {"refine", 0}});
        for (int y = 0; y + 9 < 90; ++y)
            for (int x = 0; x + 8 < 120; ++x) {
                ASSERT_EQ(result.image(x, y, 0), result.image(x + 8, y, 0)) << x << "," << y;
                ASSERT_EQ(result.image(x, y, 0), result.image(x, y + 9, 0)) << x << "," << y;
            }
    }
}

TEST(GraphCut, initialImageDecidesWhatIsPasted) {
    // Dark on the left, bright on the right, in the exemplar and, the other way round, in the initial image.
    Image exemplar = blobs({80, 40}, 1), initial({80, 80}, 1);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 80; ++x)
            exemplar(x, y, 0) = 0.2F * exemplar(x, y, 0) + (x < 40 ? 0.0F : 0.8F);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x)
            initial(x, y, 0) = x < 40 ? 0.9F : 0.1F;
    Request request = requestOf(exemplar, {80, 80});
    request.inputs.set(kInitialPort, std::make_shared<const Image>(initial));
    const Values settings{{"placement", std::string("sub-patch")}, {"patch", 20}, {"refine", 0}};
    const auto leftMinusRight = [](const Image& image) {
        double sum = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                sum += (x < image.width() / 2 ? 1.0 : -1.0) * static_cast<double>(image(x, y, 0));
        return sum / static_cast<double>(image.size().area());
    };
    EXPECT_GT(leftMinusRight(made(request, settings).image), 0.1);
    EXPECT_THROW(made(request, {{"placement", std::string("random")}}), UsageError);
}

} // namespace
} // namespace texloom::test::graph_cut_tests

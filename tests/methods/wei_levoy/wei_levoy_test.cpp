#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/methods/wei_levoy/settings.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test::wei_levoy_tests {
namespace {

using wei_levoy::Search;
using wei_levoy::Settings;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

Request requestFor(Image exemplar, Size output, Wrap wrap = {}) {
    return requestOf(std::move(exemplar), output, wrap, 5);
}

Synthesis made(const Request& request, const Settings& settings, int threads = 2,
               ScanOrder::Order order = ScanOrder::Order::Wavefront) {
    Job<Synthesis> job({request.seed, threads, false}, [&](JobContext& context) {
        return CausalSynthesis(request, settings.options(), context).run(order);
    });
    Synthesis result = std::get<Synthesis>(job.take());
    result.curves = job.monitor().curves();
    return result;
}

Settings single(int neighbourhood, Search search, int passes = 1) {
    Settings settings;
    settings.neighbourhood = neighbourhood;
    settings.levels = 1;
    settings.search = search;
    settings.passes = passes;
    return settings;
}

int turned(int at, int length) {
    return (at % length + length) % length;
}

/// One pixel after another, from the definition: the exemplar's pixel with the least sum of squared
/// differences over the rows above and the pixels to the left, and over the rest in later passes.
Image naive(const Image& exemplar, Image output, int side, int passes) {
    const int reach = side / 2;
    for (int pass = 0; pass < passes; ++pass)
        for (int row = 0; row < output.height(); ++row)
            for (int i = 0; i < output.width(); ++i) {
                const int y = row, x = (i + row * (reach + 1)) % output.width();
                double best = HUGE_VAL;
                int bestX = 0, bestY = 0;
                for (int v = reach; v < exemplar.height() - (pass > 0 ? reach : 0); ++v)
                    for (int u = reach; u < exemplar.width() - reach; ++u) {
                        double sum = 0;
                        for (int dy = -reach; dy <= reach; ++dy)
                            for (int dx = -reach; dx <= reach; ++dx) {
                                if ((dy == 0 && dx == 0) || (pass == 0 && (dy > 0 || (dy == 0 && dx > 0))))
                                    continue;
                                for (int c = 0; c < output.channels(); ++c) {
                                    const double d =
                                        static_cast<double>(output(turned(x + dx, output.width()),
                                                                   turned(y + dy, output.height()), c)) -
                                        static_cast<double>(exemplar(u + dx, v + dy, c));
                                    sum += d * d;
                                }
                            }
                        if (sum < best - 1e-9) {
                            best = sum;
                            bestX = u;
                            bestY = v;
                        }
                    }
                for (int c = 0; c < output.channels(); ++c)
                    output(x, y, c) = exemplar(bestX, bestY, c);
            }
    return output;
}

/// The white noise that a run begins with.
Image startOf(const Request& request) {
    const Image& exemplar = *request.exemplars.front().image;
    Image start(request.size, exemplar.channels());
    const Random random(request.seed);
    const auto count = static_cast<double>(exemplar.size().area());
    for (int y = 0; y < start.height(); ++y)
        for (int x = 0; x < start.width(); ++x) {
            const auto at = static_cast<int>(random.uniform(x, y) * count);
            for (int c = 0; c < start.channels(); ++c)
                start(x, y, c) = exemplar(at % exemplar.width(), at / exemplar.width(), c);
        }
    return start;
}

TEST(WeiLevoy, exactSearchIsTheDefinition) {
    for (const int channels : {1, 3})
        for (const int passes : {1, 2}) {
            const Request request = requestFor(noise({24, 24}, channels), {24, 24});
            const Image expected = naive(*request.exemplars.front().image, startOf(request), 5, passes);
            EXPECT_TRUE(samePixels(made(request, single(5, Search::Exact, passes)).image, expected))
                << channels << " channels, " << passes << " passes";
        }
}

TEST(WeiLevoy, wavefrontGivesThePixelsOfRasterOrder) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}})
        for (const Size size : {Size{120, 77}, Size{20, 60}, Size{5, 5}, Size{1, 40}, Size{90, 3}}) {
            const Request request = requestFor(blobs({40, 40}, 3), size, wrap);
            Settings settings;
            settings.neighbourhood = 7;
            settings.passes = 2;
            const Synthesis raster = made(request, settings, 1, ScanOrder::Order::Raster);
            for (const int threads : {1, 2, 5}) {
                const Synthesis wavefront = made(request, settings, threads);
                EXPECT_TRUE(samePixels(raster.image, wavefront.image)) << size.width << " × " << size.height;
                EXPECT_EQ(raster.map, wavefront.map);
            }
        }
}

TEST(WeiLevoy, treeFindsNeighbourhoodsNearlyAsNearAsTheNearest) {
    const Request request = requestFor(blobs({64, 64}, 3), {96, 96});
    const double exact = made(request, single(7, Search::Exact)).curves.front().values.front();
    const double tree = made(request, single(7, Search::Tree)).curves.front().values.front();
    EXPECT_GT(exact, 0);
    EXPECT_LT(tree, 1.25 * exact);
}

TEST(WeiLevoy, periodicExemplarIsContinuedWithItsPeriod) {
    const Image exemplar = periodic({64, 64}, {8, 8}, 1);
    Settings settings;
    settings.levels = 3;
    settings.search = Search::Exact;
    // On the coarsest scale neighbourhoods show the whole width: in a wider output pieces of different phase
    // may grow from the noise side by side, and nothing moves the walls between them.
    const Image image = made(requestFor(exemplar, {16, 160}), settings).image;
    // The noise that the coarsest scale begins with is seen in its first rows.
    for (int y = 4 * 18; y + 8 < 160; ++y)
        for (int x = 0; x + 8 < 16; ++x) {
            ASSERT_EQ(image(x, y, 0), image(x + 8, y, 0)) << x << "," << y;
            ASSERT_EQ(image(x, y, 0), image(x, y + 8, 0)) << x << "," << y;
        }
}

TEST(WeiLevoy, partOfTheExemplarStaysAsItIs) {
    // Two periods by two: round its borders, too, the part looks like the exemplar everywhere.
    const Image exemplar = periodic({64, 60}, {20, 18}, 3);
    const Image part(exemplar.view().crop(10, 12, {40, 36}));
    Request request = requestFor(exemplar, part.size());
    request.inputs.set(kInitialPort, shared(part));
    EXPECT_TRUE(samePixels(made(request, single(5, Search::Exact)).image, part));
    EXPECT_TRUE(samePixels(made(request, single(5, Search::Exact, 2)).image, part));
}

TEST(WeiLevoy, refusalsNameTheValueAndTheLimit) {
    const Method& method = findMethod("wei-levoy");
    const Request request = requestFor(blobs({12, 30}, 3), {64, 64});
    EXPECT_THAT(refusalOf(method, request, {{"neighbourhood", 13}}),
                testing::AllOf(testing::HasSubstr("13 px"), testing::HasSubstr("at most 11 px")));
    EXPECT_EQ(refusalOf(method, request, {{"neighbourhood", 11}}), "was taken");
    EXPECT_THAT(refusalOf(method, request, {{"neighbourhood", 22}}), testing::HasSubstr("3 to 21 px"));
}

} // namespace
} // namespace texloom::test::wei_levoy_tests

#include "core/analysis/layout_quality.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/quilting/settings.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace texloom::test::quilting_tests {
namespace {

using quilting::Settings;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

Quilt quilt(const Request& request, const Settings& settings, int threads = 2,
            PatchQuilter::Order order = PatchQuilter::Order::Wavefront) {
    const std::vector<PatchSource> exemplars = patchSources(request);
    const QuiltOptions options = settings.quiltOptions(request);
    Job<Quilt> job({request.seed, threads, false}, [&](JobContext& context) {
        return PatchQuilter(exemplars, options, context).run(1, order);
    });
    return std::get<Quilt>(job.take());
}

/// By the method, which says what its map is.
Synthesis run(const Request& request, const Values& settings) {
    return resultOf(findMethod("quilting"), request, settings);
}

TEST(Quilting, wavefrontGivesThePixelsOfRasterOrder) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}})
        for (const double overlap : {0.1, 0.25, 0.5})
            for (const Size size : {Size{90, 77}, Size{20, 60}, Size{16, 16}, Size{150, 31}}) {
                const Request request = requestOf(blobs({40, 40}, 3), size, wrap);
                const Settings settings{16, overlap, 0.3, PatchStitch::Cut, 3};
                const Quilt raster = quilt(request, settings, 1, PatchQuilter::Order::Raster);
                for (const int threads : {1, 2, 5}) {
                    const Quilt wavefront = quilt(request, settings, threads);
                    EXPECT_TRUE(samePixels(raster.image, wavefront.image));
                    EXPECT_EQ(raster.map, wavefront.map);
                }
            }
}

/// The share of pixels that are black.
double blackShare(const Image& image) {
    double black = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            black += image(x, y, 0) == 0 ? 1 : 0;
    return black / static_cast<double>(image.size().area());
}

TEST(Quilting, aFlatPartWithoutAnEndDoesNotTakeOver) {
    // Of the exemplar's right and lower border: it does not show what lies behind black.
    for (const auto& [left, top] : {std::pair{40, 40}, std::pair{60, 0}, std::pair{0, 60}}) {
        Image exemplar = noise({80, 80}, 1);
        for (int y = top; y < 80; ++y)
            for (int x = left; x < 80; ++x)
                exemplar(x, y, 0) = 0;
        const double wanted = blackShare(exemplar);
        double balanced = 0, published = 0;
        for (const std::uint64_t seed : {1, 2, 3}) {
            Request request = requestOf(exemplar, {240, 240});
            request.seed = seed;
            Settings settings{14, 0.25, 0.1, PatchStitch::Cut, 3};
            balanced += blackShare(quilt(request, settings).image) / 3;
            settings.contrast = 0;
            published += blackShare(quilt(request, settings).image) / 3;
        }
        EXPECT_GT(published, 2.5 * wanted) << left;
        EXPECT_LT(balanced, 1.6 * wanted) << left;
        EXPECT_GT(balanced, 0.5 * wanted) << left;
    }
}

TEST(Quilting, periodicExemplarIsContinuedWithItsPeriod) {
    const Request request = requestOf(periodic({48, 45}, {8, 9}, 2), {101, 87});
    const Image image = quilt(request, {20, 0.25, 0, PatchStitch::Cut, 3}).image;
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y + 9 < image.height(); ++y)
            for (int x = 0; x + 8 < image.width(); ++x) {
                ASSERT_EQ(image(x, y, c), image(x + 8, y, c)) << x << "," << y;
                ASSERT_EQ(image(x, y, c), image(x, y + 9, c)) << x << "," << y;
            }
}

TEST(Quilting, wholePeriodsCloseOverTheBorderWithoutATrace) {
    const Request request = requestOf(periodic({48, 45}, {8, 9}, 1), {96, 90}, {true, true});
    const Image image = quilt(request, {20, 0.25, 0, PatchStitch::Cut, 3}).image;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            ASSERT_EQ(image(x, y, 0), image((x + 8) % 96, y, 0)) << x << "," << y;
            ASSERT_EQ(image(x, y, 0), image(x, (y + 9) % 90, 0)) << x << "," << y;
        }
}

TEST(Quilting, startingFromAPartOfTheExemplarGivesItBack) {
    // The second output cuts the last patches off: only what lies within it may count.
    const Image exemplar = blobs({64, 52}, 3);
    for (const Size size : {Size{64, 52}, Size{61, 50}}) {
        const Image part(exemplar.view().crop(0, 0, size));
        Request request = requestOf(exemplar, size);
        request.inputs.set(kInitialPort, shared(part));
        EXPECT_TRUE(samePixels(quilt(request, {16, 0.25, 0, PatchStitch::Cut, 3}).image, part));
    }
}

TEST(Quilting, initialImageIsComparedOverWholePatches) {
    const Image exemplar = blobs({64, 64}, 1);
    Request request = requestOf(exemplar, {64, 64});
    Image blurredHalves(exemplar.size(), 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            blurredHalves(x, y, 0) = 0.5F * (exemplar(x, y, 0) + exemplar(std::min(63, x + 1), y, 0));
    request.inputs.set(kInitialPort, shared(blurredHalves));
    const Quilt result = quilt(request, {16, 0.25, 0, PatchStitch::Cut, 3});
    int near = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            near += std::abs(result.map.at(x, y).x - x) <= 1 && std::abs(result.map.at(x, y).y - y) <= 1;
    EXPECT_GT(near, 64 * 64 * 9 / 10);
}

TEST(Quilting, maskedPixelsAreNeverCopied) {
    Request request = requestOf(blobs({60, 60}, 3), {150, 150});
    Image mask = constant({60, 60}, 1, 1);
    for (int y = 20; y < 30; ++y)
        for (int x = 25; x < 40; ++x)
            mask(x, y, 0) = 0;
    request.exemplars.front().inputs.set(kMaskPort, shared(mask));
    const Quilt result = quilt(request, {12, 0.25, 0.1, PatchStitch::Cut, 3});
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 150; ++x) {
            const Source source = result.map.at(x, y);
            ASSERT_EQ(mask(source.x, source.y, 0), 1) << x << "," << y;
        }
}

TEST(Quilting, everyExemplarIsUsedAndTheMapSaysWhich) {
    Request request = requestOf(blobs({40, 40}, 3, 1), {200, 200});
    request.exemplars.push_back({"another", shared(blobs({50, 33}, 3, 1))});
    const Quilt result = quilt(request, {12, 0.25, 0.5, PatchStitch::Cut, 3});
    std::set<int> used;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
            used.insert(result.map.at(x, y).exemplar);
    EXPECT_EQ(used, (std::set<int>{0, 1}));
    const std::vector<ImageView> images = {*request.exemplars[0].image, *request.exemplars[1].image};
    EXPECT_TRUE(samePixels(result.map.apply(images), result.image));
}

TEST(Quilting, zeroToleranceAlwaysTakesTheNearestPatch) {
    // The second patch of the first row, from the definition of the distance.
    const Image exemplar = blobs({40, 40}, 2);
    const Settings settings{16, 0.25, 0, PatchStitch::Cut, 3, 0, 0};
    const Quilt result = quilt(requestOf(exemplar, {28, 16}), settings, 1);
    const Source first = result.map.at(0, 0);
    double best = HUGE_VAL;
    Source nearest;
    for (std::uint16_t v = 0; v <= 24; ++v)
        for (std::uint16_t u = 0; u <= 24; ++u) {
            double distance = 0;
            for (int c = 0; c < 2; ++c)
                for (int y = 0; y < 16; ++y)
                    for (int x = 0; x < 4; ++x) {
                        const double d = static_cast<double>(exemplar(first.x + 12 + x, first.y + y, c)) -
                                         static_cast<double>(exemplar(u + x, v + y, c));
                        distance += d * d;
                    }
            if (distance < best) {
                best = distance;
                nearest = {u, v, 0};
            }
        }
    const Source drawn = result.map.at(20, 8);
    EXPECT_EQ(drawn.x - 8, nearest.x);
    EXPECT_EQ(drawn.y - 8, nearest.y);
}

TEST(Quilting, largeToleranceDrawsFromAllPatches) {
    std::set<std::pair<int, int>> drawn;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Request request = requestOf(noise({20, 20}, 1), {28, 16});
        request.seed = seed;
        const Source source = quilt(request, {16, 0.25, 10, PatchStitch::Cut, 3}, 1).map.at(27, 8);
        drawn.insert({source.x, source.y});
    }
    EXPECT_GT(drawn.size(), 12U);
}

TEST(Quilting, smoothedCutBlendsOnlyNearTheCut) {
    const Request request = requestOf(blobs({64, 64}, 3), {160, 160});
    const Synthesis hard = run(request, {{"patch", 24}, {"stitch", std::string("cut")}});
    const Synthesis soft =
        run(request, {{"patch", 24}, {"stitch", std::string("smooth-cut")}, {"softness", 2}});
    EXPECT_EQ(soft.mapKind, MapKind::Dominant);
    EXPECT_EQ(hard.mapKind, MapKind::Exact);
    const Image fromMap = soft.map.apply(request.exemplars.front().image->view());
    std::int64_t blended = 0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x)
            blended += fromMap(x, y, 0) != soft.image(x, y, 0);
    EXPECT_GT(blended, 0);
    EXPECT_LT(blended, 160 * 160 / 2);
    const ValueRange exemplar = valueRange(*request.exemplars.front().image);
    const ValueRange result = valueRange(soft.image);
    EXPECT_GE(result.smallest, exemplar.smallest);
    EXPECT_LE(result.largest, exemplar.largest);
}

TEST(Quilting, everyStitchIsTheSameForAnyNumberOfThreads) {
    for (const PatchStitch stitch : {PatchStitch::Average, PatchStitch::None, PatchStitch::Poisson,
                                     PatchStitch::Midway, PatchStitch::Feather})
        for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
            const Request request = requestOf(blobs({40, 40}, 3), {75, 64}, wrap);
            const Settings settings{16, 0.25, 0.3, stitch, 3};
            const Quilt one = quilt(request, settings, 1), many = quilt(request, settings, 3);
            EXPECT_TRUE(samePixels(one.image, many.image));
            EXPECT_EQ(one.map, many.map);
        }
}

TEST(Quilting, mapsAreExactWherePixelsAreNotBlended) {
    const Request request = requestOf(blobs({64, 64}, 3), {120, 100});
    for (const Choice& stitch : patchStitchChoices()) {
        const Synthesis result = run(request, {{"patch", 24}, {"stitch", stitch.id}});
        const Image fromMap = result.map.apply(request.exemplars.front().image->view());
        const bool exact = stitch.id == "cut" || stitch.id == "none";
        EXPECT_EQ(result.mapKind, exact ? MapKind::Exact : MapKind::Dominant) << stitch.id;
        EXPECT_EQ(samePixels(fromMap, result.image), exact) << stitch.id;
        // Where nothing overlaps, nothing is blended.
        for (int y = 6; y < 18; ++y)
            for (int x = 6; x < 18; ++x)
                EXPECT_EQ(fromMap(x, y, 1), result.image(x, y, 1)) << stitch.id;
        EXPECT_EQ(result.figures.size(), stitch.id == "cut" || stitch.id == "smooth-cut" ? 2U : 1U);
    }
}

/// How many pixels of the output show what a pixel at most `reach` patches away shows as well.
double repeatedShare(const PositionMap& map, int step, int reach) {
    std::int64_t repeated = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
            bool found = false;
            for (int v = std::max(0, y - reach * step); v <= y && !found; ++v)
                for (int u = std::max(0, x - reach * step);
                     u < std::min(map.width(), x + reach * step) && !found; ++u)
                    found = (u != x || v != y) && map.at(u, v) == map.at(x, y);
            repeated += found ? 1 : 0;
        }
    return static_cast<double>(repeated) / static_cast<double>(map.size().area());
}

TEST(Quilting, varietyKeepsPiecesFromComingAgainNearBy) {
    double plain = 0, varied = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        Request request = requestOf(blobs({64, 64}, 3), {120, 120});
        request.seed = seed;
        plain += repeatedShare(quilt(request, {16, 0.25, 0.1, PatchStitch::Cut, 3, 0, 0}).map, 12, 2);
        varied += repeatedShare(quilt(request, {16, 0.25, 0.1, PatchStitch::Cut, 3, 0, 2}).map, 12, 2);
    }
    EXPECT_LT(varied, 0.5 * plain);
}

TEST(Quilting, varietyGivesTheSameBitsInAnyOrder) {
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{false, true}, Wrap{true, true}}) {
        const Request request = requestOf(blobs({40, 40}, 3), {150, 90}, wrap);
        const Settings settings{16, 0.25, 0.3, PatchStitch::Cut, 3, 1, 2};
        const Quilt raster = quilt(request, settings, 1, PatchQuilter::Order::Raster);
        for (const int threads : {2, 5})
            EXPECT_EQ(raster.map, quilt(request, settings, threads).map);
    }
}

TEST(Quilting, contrastIsKeptWhereFlatPatchesWouldWin) {
    // Blobs, of which a third is nearly flat; nothing fits well.
    Image exemplar = noise({72, 72}, 1);
    for (int y = 0; y < 72; ++y)
        for (int x = 0; x < 24; ++x)
            exemplar(x, y, 0) = 0.5F + 0.05F * (exemplar(x, y, 0) - 0.5F);
    const Request request = requestOf(exemplar, {200, 200});
    const ImageView one = *request.exemplars.front().image;
    const Image faded = quilt(request, {16, 0.25, 0.1, PatchStitch::Cut, 3, 0, 0}).image;
    const Image kept = run(request, {{"patch", 16}}).image;
    EXPECT_LT(contrastKept(faded, {&one, 1}), 0.7);
    EXPECT_GT(contrastKept(kept, {&one, 1}), 0.85);
}

TEST(Quilting, refusalsNameTheValueAndTheLimit) {
    const Method& method = findMethod("quilting");
    const Request request = requestOf(blobs({30, 30}, 3), {64, 64});
    EXPECT_THAT(refusalOf(method, request, {{"patch", 31}}),
                testing::AllOf(testing::HasSubstr("31"), testing::HasSubstr("30")));
    EXPECT_EQ(refusalOf(method, request, {{"patch", 30}}), "was taken");
    EXPECT_THAT(refusalOf(method, requestOf(blobs({30, 30}, 3), {64, 20}, {false, true}), {{"patch", 24}}),
                testing::AllOf(testing::HasSubstr("20"), testing::HasSubstr("24")));
    EXPECT_THAT(refusalOf(method, request, {{"overlap", 0.7}}), testing::HasSubstr("0.02 to 0.5"));
    EXPECT_THAT(refusalOf(method, request, {{"tolerance", -1}}), testing::HasSubstr("tolerance = -1"));
}

} // namespace
} // namespace texloom::test::quilting_tests

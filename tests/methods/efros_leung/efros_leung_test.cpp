#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/methods/pixel_grower.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace texloom::test::efros_leung_tests {
namespace {

using pixel_growth::Grower;
using pixel_growth::Order;
using pixel_growth::Search;
using pixel_growth::Settings;
using pixel_growth::Start;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

Request requestFor(Image exemplar, Size output, Wrap wrap = {}) {
    return requestOf(std::move(exemplar), output, wrap, 5);
}

Synthesis grown(const Request& request, const Settings& settings, int threads = 2, const Start& start = {}) {
    Job<Synthesis> job({request.seed, threads, false},
                       [&](JobContext& context) { return Grower(request, settings, start, context).run(); });
    Outcome<Synthesis> outcome = job.take();
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    return std::get<Synthesis>(std::move(outcome));
}

/// A part of the bundled gravel.
Image gravelOf(Size size) {
    const LoadedImage whole =
        readImage(std::string(TEXLOOM_SOURCE_DIR) + "/resources/exemplars/gravel_gray.png");
    Image part(size, whole.image.channels());
    for (int c = 0; c < part.channels(); ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                part(x, y, c) = whole.image(x, y, c);
    return part;
}

/// A scan, and an output of which about half is known.
struct Scene {
    Image exemplar;
    PatchSource source;
    WindowScan scan;
    Image output;
    PixelCanvas canvas;
    KnownPixels known;

    Scene(Image from, int window, double sigma, Size size)
        : exemplar(std::move(from)), source{exemplar.view(), {}}, scan({&source, 1}, window, sigma, [] {}),
          output(noise(size, exemplar.channels(), 9)), canvas(size, exemplar.channels(), {exemplar.size()}),
          known(size) {
        canvas.pixels = scan.turned(output, [] {});
        const Random random(3);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                known.at(x, y) = random.below(2, x, y) == 0;
    }

    /// d(p, q) from its definition, times the weights' sum.
    double distance(int px, int py, int qx, int qy, double sigma, Wrap wrap) const {
        double sum = 0;
        const int reach = scan.window() / 2;
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                int x = px + dx, y = py + dy;
                const Size size = output.size();
                if ((!wrap.x && (x < 0 || x >= size.width)) || (!wrap.y && (y < 0 || y >= size.height)) ||
                    (dx == 0 && dy == 0))
                    continue;
                x = (x + size.width) % size.width;
                y = (y + size.height) % size.height;
                if (!static_cast<const KnownPixels&>(known).at(x, y))
                    continue;
                for (int c = 0; c < output.channels(); ++c) {
                    const double d = static_cast<double>(output(x, y, c)) -
                                     static_cast<double>(exemplar(qx + dx, qy + dy, c));
                    sum += std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)) * d * d;
                }
            }
        return sum;
    }
};

TEST(WindowScan, findsWhatTheDefinitionFinds) {
    for (const int channels : {1, 3})
        for (const double tolerance : {0.0, 0.3, 5.0})
            for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
                const double sigma = 1.3;
                const Scene scene(noise({12, 12}, channels), 5, sigma, {12, 12});
                for (int py = 0; py < 12; ++py)
                    for (int px = 0; px < 12; ++px) {
                        WindowScan::Query query;
                        std::vector<WindowScan::Found> found, hinted;
                        scene.scan.look(scene.canvas, scene.known, px, py, wrap, query);
                        if (query.blank())
                            continue;
                        scene.scan.within(tolerance, {}, {}, query, found, [] {});
                        const Source hint{5, 6, 0};
                        scene.scan.within(tolerance, {}, {&hint, 1}, query, hinted, [] {});
                        ASSERT_FALSE(found.empty());
                        ASSERT_EQ(found.size(), hinted.size());
                        double least = HUGE_VAL;
                        for (int qy = 2; qy < 10; ++qy)
                            for (int qx = 2; qx < 10; ++qx)
                                least = std::min(least, scene.distance(px, py, qx, qy, sigma, wrap));
                        std::size_t expected = 0;
                        for (int qy = 2; qy < 10; ++qy)
                            for (int qx = 2; qx < 10; ++qx) {
                                const double d = scene.distance(px, py, qx, qy, sigma, wrap);
                                // What lies on the limit may be rounded either way.
                                if (std::abs(d - (1 + tolerance) * least) < 1e-4 * least && d > least)
                                    continue;
                                expected += d <= (1 + tolerance) * least;
                                for (const WindowScan::Found& one : found)
                                    if (one.source == Source{static_cast<std::uint16_t>(qx),
                                                             static_cast<std::uint16_t>(qy), 0}) {
                                        ASSERT_NEAR(static_cast<double>(one.distance), d, 1e-4 * d);
                                    }
                            }
                        ASSERT_NEAR(static_cast<double>(found.size()), static_cast<double>(expected), 1);
                    }
            }
}

TEST(WindowScan, radiusLeavesOutWhatIsFar) {
    const Scene scene(noise({30, 20}, 2), 5, 1.3, {30, 20});
    for (const int radius : {3, 7})
        for (int py = 0; py < 20; py += 3)
            for (int px = 0; px < 30; px += 3) {
                WindowScan::Query query;
                std::vector<WindowScan::Found> all, found;
                scene.scan.look(scene.canvas, scene.known, px, py, {}, query);
                // So much tolerance that every window fits.
                scene.scan.within(1e6, {}, {}, query, all, [] {});
                const Source far{25, 10, 0};
                scene.scan.within(1e6, {{30, 20}, px, py, radius}, {&far, 1}, query, found, [] {});
                ASSERT_FALSE(found.empty());
                std::erase_if(all, [&](const WindowScan::Found& one) {
                    return std::abs(one.source.x - px) > radius || std::abs(one.source.y - py) > radius;
                });
                ASSERT_EQ(found.size(), all.size());
            }
    // Exemplars of other sizes are not limited, and where there is nothing near all is looked at.
    WindowScan::Query query;
    std::vector<WindowScan::Found> found;
    scene.scan.look(scene.canvas, scene.known, 9, 9, {}, query);
    for (const WindowScan::Nearby& nearby :
         {WindowScan::Nearby{{31, 20}, 9, 9, 2}, WindowScan::Nearby{{30, 20}, 0, 0, 1}}) {
        scene.scan.within(1e6, nearby, {}, query, found, [] {});
        EXPECT_EQ(found.size(), 26U * 16U);
    }
}

TEST(EfrosLeung, periodIsContinued) {
    for (const Order order : {Order::Onion, Order::Raster})
        for (const Search search : {Search::Exact, Search::Pca}) {
            Settings settings;
            settings.tolerance = 0;
            settings.order = order;
            settings.search = search;
            settings.seedSize = 7;
            const Image image = grown(requestFor(periodic({40, 42}, {5, 7}, 3), {60, 60}), settings).image;
            int broken = 0;
            for (int y = 0; y + 7 < 60; ++y)
                for (int x = 0; x + 5 < 60; ++x)
                    broken += image(x, y, 1) != image(x + 5, y, 1) || image(x, y, 1) != image(x, y + 7, 1);
            // Principal components may miss the window that fits, for one pixel in twenty at most; a pixel is
            // met in three of the comparisons.
            EXPECT_LE(broken, search == Search::Exact ? 0 : 3 * 60 * 60 / 20);
        }
}

/// A picture with a hole, and what is known of it.
struct Hole {
    Image picture, known;
    explicit Hole(const Image& image) : picture(image), known(constant(image.size(), 1, 1)) {
        for (int y = 25; y < 45; ++y)
            for (int x = 20; x < 50; ++x) {
                known(x, y, 0) = 0;
                for (int c = 0; c < image.channels(); ++c)
                    picture(x, y, c) = 77;
            }
    }
};

TEST(EfrosLeung, whatIsKnownStaysAsItIs) {
    const Hole hole(blobs({70, 70}, 3));
    for (const Order order : {Order::Onion, Order::Raster}) {
        Request request = requestFor(hole.picture, {70, 70});
        request.exemplars.front().inputs.set(kMaskPort, shared(hole.known));
        Settings settings;
        settings.order = order;
        const Synthesis result = grown(request, settings, 2, {&hole.picture, &hole.known});
        for (int y = 0; y < 70; ++y)
            for (int x = 0; x < 70; ++x)
                if (hole.known(x, y, 0) != 0) {
                    ASSERT_EQ(result.image(x, y, 2), hole.picture(x, y, 2));
                } else {
                    ASSERT_LT(result.image(x, y, 2), 2);
                }
        EXPECT_EQ(result.mapKind, MapKind::Exact);
        EXPECT_TRUE(samePixels(result.map.apply(hole.picture.view()), result.image));
    }
}

TEST(EfrosLeung, holeInAPeriodIsFilledWithoutATrace) {
    const Image whole = periodic({70, 70}, {5, 7}, 2);
    const Hole hole(whole);
    Request request = requestFor(hole.picture, {70, 70});
    request.exemplars.front().inputs.set(kMaskPort, shared(hole.known));
    Settings settings;
    settings.tolerance = 0;
    EXPECT_TRUE(samePixels(grown(request, settings, 2, {&hole.picture, &hole.known}).image, whole));
}

/// Where a coarser scale guesses the hole's own pixels, nothing fits better than these.
TEST(EfrosLeung, aGuessThatFitsIsKept) {
    const Image whole = gravelOf({70, 70});
    const Hole hole(whole);
    const Request request = requestFor(whole, {70, 70}); // of which nothing is hidden
    PositionMap guess({70, 70}, {{70, 70}});
    for (int y = 25; y < 45; ++y)
        for (int x = 20; x < 50; ++x)
            guess.at(x, y) = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0};
    for (const Order order : {Order::Onion, Order::Raster}) {
        Settings settings;
        settings.window = 9;
        settings.order = order;
        settings.tolerance = 0;
        const Start start{&hole.picture, &hole.known, &guess};
        const Synthesis one = grown(request, settings, 1, start);
        EXPECT_TRUE(samePixels(one.image, whole));
        EXPECT_TRUE(samePixels(grown(request, settings, 3, start).image, one.image));
    }
}

TEST(WindowScan, whatIsGuessedCountsLess) {
    Scene scene(noise({20, 20}, 1), 5, 1.3, {20, 20});
    std::fill(scene.known.flags.begin(), scene.known.flags.end(), KnownPixels::kMade);
    const auto distance = [&] {
        WindowScan::Query query;
        std::vector<WindowScan::Found> found;
        const Source one{9, 9, 0};
        scene.scan.look(scene.canvas, scene.known, 10, 10, {}, query);
        scene.scan.withinOf({&one, 1}, 0, query, found);
        return static_cast<double>(found.front().distance);
    };
    const double made = distance();
    scene.known.at(9, 10) = KnownPixels::kGuessed;
    const double guessed = distance();
    scene.known.at(9, 10) = 0;
    const double unknown = distance();
    EXPECT_LT(unknown, made);
    EXPECT_NEAR(guessed, (made + unknown) / 2, 1e-4 * made);
}

TEST(EfrosLeung, sourcesOfAHoleLieWithinTheRadius) {
    const Hole hole(blobs({70, 70}, 3));
    Request request = requestFor(hole.picture, {70, 70});
    request.exemplars.front().inputs.set(kMaskPort, shared(hole.known));
    for (const Search search : {Search::Exact, Search::Pca}) {
        Settings settings;
        settings.radius = 24;
        settings.search = search;
        const PositionMap map = grown(request, settings, 2, {&hole.picture, &hole.known}).map;
        int far = 0;
        for (int y = 25; y < 45; ++y)
            for (int x = 20; x < 50; ++x)
                far += std::abs(map.at(x, y).x - x) > 24 || std::abs(map.at(x, y).y - y) > 24;
        // The tree may find nothing near.
        EXPECT_LE(far, search == Search::Exact ? 0 : 60);
    }
}

TEST(EfrosLeung, sameBitsForAnyNumberOfThreads) {
    for (const Order order : {Order::Onion, Order::Raster})
        for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{true, true}}) {
            Settings settings;
            settings.order = order;
            settings.window = 9;
            const Request request = requestFor(blobs({30, 30}, 3), {71, 50}, wrap);
            const Synthesis one = grown(request, settings, 1), many = grown(request, settings, 5);
            EXPECT_TRUE(samePixels(one.image, many.image));
            EXPECT_EQ(one.map, many.map);
        }
}

/// Grows by rows, so that what was known when a pixel was made can be told afterwards.
TEST(EfrosLeung, likelyWindowsAreAmongThoseThatFit) {
    Settings settings;
    settings.order = Order::Raster;
    settings.search = Search::Pca;
    const Size size{64, 64};
    const Image exemplar = gravelOf({96, 96});
    const Synthesis made = grown(requestFor(exemplar, size), settings);
    Scene scene(exemplar, settings.window, settings.sigma * settings.window, size);
    scene.canvas.pixels = scene.scan.turned(made.image, [] {});
    int met = 0, asked = 0;
    for (int y = 6; y < size.height; y += 3)
        for (int x = 0; x < size.width; x += 3) {
            KnownPixels earlier(size);
            for (int v = 0; v < size.height; ++v)
                for (int u = 0; u < size.width; ++u)
                    earlier.at(u, v) = v < y || (v == y && u < x);
            WindowScan::Query query;
            std::vector<WindowScan::Found> fitting;
            scene.scan.look(scene.canvas, earlier, x, y, {}, query);
            scene.scan.within(2 * settings.tolerance, {}, {}, query, fitting, [] {});
            ++asked;
            met += std::any_of(fitting.begin(), fitting.end(),
                               [&](const WindowScan::Found& one) { return one.source == made.map.at(x, y); });
        }
    EXPECT_GE(met, asked * 95 / 100) << "of " << asked;
}

TEST(EfrosLeung, aPictureIsNotHealedFromItsOwnHole) {
    Image photo = gravelOf({64, 64});
    Image known = constant(photo.size(), 1, 1);
    for (int y = 28; y < 36; ++y)
        for (int x = 26; x < 38; ++x) {
            photo(x, y, 0) = 5; // what is to go
            known(x, y, 0) = 0;
        }
    Request request = requestFor(photo, photo.size());
    request.inputs.set(kInitialPort, shared(photo));
    request.inputs.set("known", shared(known));
    const Method& method = findMethod("efros-leung");
    const Synthesis healed = resultOf(method, request, {{"window", 9}});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            ASSERT_NE(healed.image(x, y, 0), 5);
            if (known(x, y, 0) != 0) {
                ASSERT_EQ(healed.image(x, y, 0), photo(x, y, 0));
            }
        }
    // A mask of one's own says more: here, that all may be copied.
    request.exemplars.front().inputs.set(kMaskPort, shared(constant(photo.size(), 1, 1)));
    EXPECT_NO_THROW(method.check(request, method.resolved({{"window", 63}}, photo.size())));
    request.exemplars.front().inputs.clear(kMaskPort);
    EXPECT_THROW(method.check(request, method.resolved({{"window", 63}}, photo.size())), UsageError);
}

/// Squares of 12 × 10 px, in which windows of 9 px see one colour.
Image chessboard(Size size) {
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(x, y, 0) = static_cast<float>((x / 12 + y / 10) % 2);
    return image;
}

/// The share of pixels that are not as those a period to the right and below.
double broken(const Image& image) {
    int count = 0, asked = 0;
    for (int y = 0; y + 20 < image.height(); ++y)
        for (int x = 0; x + 24 < image.width(); ++x, ++asked)
            count += image(x, y, 0) != image(x + 24, y, 0) || image(x, y, 0) != image(x, y + 20, 0);
    return static_cast<double>(count) / asked;
}

TEST(EfrosLeung, coarseScalesKeepWhatIsLargerThanAWindow) {
    const Request request = requestFor(chessboard({96, 80}), {120, 120});
    const Method& method = findMethod("efros-leung");
    const double byScales = broken(resultOf(method, request, {{"window", 9}, {"scales", 3}}).image);
    const double once = broken(resultOf(method, request, {{"window", 9}, {"scales", 1}}).image);
    EXPECT_LT(byScales, 0.05);
    EXPECT_GT(once, 0.3);
}

TEST(EfrosLeung, oneScaleGrowsAsPublished) {
    const Request request = requestFor(blobs({40, 40}, 3), {60, 50}, {true, false});
    Settings settings;
    settings.window = 9;
    const Synthesis once = resultOf(findMethod("efros-leung"), request, {{"window", 9}, {"scales", 1}});
    EXPECT_TRUE(samePixels(once.image, grown(request, settings).image));
}

TEST(EfrosLeung, allScalesCopyWhatMasksAllow) {
    Image mask = constant({64, 64}, 1, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 24; ++x)
            mask(x, y, 0) = 0;
    for (const Wrap wrap : {Wrap{}, Wrap{true, true}})
        for (const char* order : {"onion", "raster"}) {
            Request request = requestFor(gravelOf({64, 64}), {101, 90}, wrap);
            request.exemplars.push_back(request.exemplars.front());
            request.exemplars.front().inputs.set(kMaskPort, shared(mask));
            const Method& method = findMethod("efros-leung");
            const Values values{{"window", 9}, {"order", order}};
            const Synthesis one = resultOf(method, request, values, {.threads = 1});
            const Synthesis many = resultOf(method, request, values, {.threads = 5});
            EXPECT_EQ(one.map, many.map);
            ASSERT_EQ(one.mapKind, MapKind::Exact);
            const ImageView exemplar = request.exemplars.front().image->view();
            EXPECT_TRUE(samePixels(one.map.apply(std::vector{exemplar, exemplar}), one.image));
            for (int y = 0; y < 90; ++y)
                for (int x = 0; x < 101; ++x)
                    ASSERT_FALSE(one.map.at(x, y).exemplar == 0 && one.map.at(x, y).x < 24);
        }
}

TEST(EfrosLeung, refusalsNameTheValueAndTheLimit) {
    EXPECT_THAT(
        refusalOf(findMethod("efros-leung"), requestFor(blobs({12, 30}, 3), {64, 64}), {{"window", 13}}),
        testing::AllOf(testing::HasSubstr("13 px"), testing::HasSubstr("at most 11 px")));
}

} // namespace
} // namespace texloom::test::efros_leung_tests

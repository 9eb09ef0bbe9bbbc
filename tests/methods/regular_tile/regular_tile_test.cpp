#include "core/base/error.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/methods/regular_tile/tile_search.h"
#include "tests/support/lattices.h"
#include "tests/support/says.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace texloom::regular_tile {
namespace {

using test::blobs;
using test::regularTexture;
using test::says;

/// The border along `side` by its definition, pixel by pixel (fig. 4.3).
double costByHand(const ImageView& f, Vec2 side, Vec2 step, int border, int x, int y) {
    double sum = 0;
    const int dx = static_cast<int>(std::lround(step.x)), dy = static_cast<int>(std::lround(step.y));
    for (int oy = -60; oy <= 60; ++oy)
        for (int ox = -60; ox <= 60; ++ox) {
            const Vec2 at{double(ox), double(oy)};
            const double along = dot(at, side) / side.length(), beside = cross(at, side) / side.length();
            if (along < 0 || along >= side.length() || beside < -0.5 * border || beside >= 0.5 * border)
                continue;
            const int px = x + ox, py = y + oy;
            if (px < 0 || py < 0 || px >= f.width || py >= f.height || px + dx < 0 || py + dy < 0 ||
                px + dx >= f.width || py + dy >= f.height)
                return HUGE_VAL;
            for (int c = 0; c < f.channels; ++c)
                sum += std::pow(double(f(px, py, c)) - double(f(px + dx, py + dy, c)), 2);
        }
    return sum;
}

TEST(TileSearch, costEqualsBruteForce) {
    const Image image = blobs({48, 44}, 3);
    for (const Lattice& lattice :
         {Lattice{{11, 0}, {0, 9}}, Lattice{{10, -4}, {5, 9}}, Lattice{{9.6, 3.3}, {-4.2, 8}}}) {
        const Image costs = tileCosts(image, lattice, 6, [] {});
        int inside = 0;
        for (int y = 0; y < 44; ++y)
            for (int x = 0; x < 48; ++x) {
                const double left = costByHand(image, lattice.v2, lattice.v1, 6, x, y);
                const double top = costByHand(image, lattice.v1, lattice.v2, 6, x, y);
                if (std::isinf(costs(x, y, 0)))
                    continue;
                ++inside;
                EXPECT_NEAR(costs(x, y, 0), left + top, 1e-3 * (1 + left + top)) << x << ", " << y;
            }
        EXPECT_GT(inside, 100);
    }
}

TEST(TileSearch, drawsAmongTheBestOnly) {
    Image costs({4, 1}, 1);
    for (int x = 0; x < 4; ++x)
        costs(x, 0, 0) = 10 + static_cast<float>(x);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        EXPECT_EQ(drawTile(costs, 0, Random(seed)).x, 0);
        EXPECT_LE(drawTile(costs, 0.15, Random(seed)).x, 1);
    }
    Image none({2, 2}, 1);
    for (const int at : {0, 1})
        none(at, 0, 0) = none(at, 1, 0) = HUGE_VALF;
    EXPECT_THROW(drawTile(none, 0, Random(1)), Error);
}

Synthesis run(const Image& exemplar, Request request, const Values& settings) {
    const Method& method = findMethod("regular-tile");
    request.exemplars = {{"tiles", std::make_shared<const Image>(exemplar)}};
    const Values all = method.resolved(settings, exemplar.size());
    method.check(request, all);
    Job<Synthesis> job({request.seed, 2, false},
                       [&](JobContext& context) { return method.run(request, all, context); });
    Outcome<Synthesis> outcome = job.take();
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    return std::get<Synthesis>(std::move(outcome));
}

Request sized(Size size, Wrap wrap = {}) {
    Request request;
    request.size = size;
    request.wrap = wrap;
    return request;
}

TEST(RegularTile, continuesAPeriodicExemplarForEver) {
    for (const Lattice& lattice :
         {Lattice{{16, 0}, {0, 12}}, Lattice{{20, 0}, {10, 9}}, Lattice{{14, 5}, {-3, 13}}}) {
        const Image exemplar = regularTexture({90, 84}, 3, lattice, {}, 5);
        const Synthesis result = run(exemplar, sized({150, 131}), {{"tolerance", 0.0}});
        const auto at = [&](int x, int y) { return result.image(x, y, 1); };
        for (int y = 0; y + 40 < 131; y += 3)
            for (int x = 20; x + 40 < 150; x += 3) {
                EXPECT_NEAR(at(x, y), at(x + int(lattice.v1.x), y + int(lattice.v1.y)), 1e-4);
                EXPECT_NEAR(at(x, y), at(x + int(lattice.v2.x), y + int(lattice.v2.y)), 1e-4);
            }
        EXPECT_EQ(result.mapKind, MapKind::Exact);
        EXPECT_TRUE(result.notes.empty());
    }
}

TEST(RegularTile, takesGivenVectorsAndTile) {
    const Image exemplar = blobs({64, 64}, 3);
    const Synthesis result = run(exemplar, sized({100, 90}),
                                 {{"lattice", "given"},
                                  {"v1-x", 20.0},
                                  {"v1-y", 3.0},
                                  {"v2-x", 0.0},
                                  {"v2-y", 17.0},
                                  {"tile", "given"},
                                  {"tile-x", 7.0},
                                  {"tile-y", 11.0}});
    EXPECT_EQ(result.map.at(1, 1), (Source{8, 12, 0}));
    EXPECT_EQ(result.map.at(21, 4), (Source{8, 12, 0}));
    EXPECT_EQ(result.map.at(21, 21), (Source{8, 12, 0}));
}

TEST(RegularTile, repeatsExactlyAtTheOutputsSizeWhenItWraps) {
    const Image exemplar = regularTexture({100, 96}, 3, {{18.4, 0}, {9.2, 14}}, {}, 5);
    const Size size{147, 113};
    const Synthesis once = run(exemplar, sized(size, {true, true}), {});
    ASSERT_EQ(once.image.size(), size);
    // Whole tiles: as many at the right border as the left one needs.
    double seam = 0, inside = 0;
    for (int y = 0; y < size.height; ++y) {
        seam += std::abs(double(once.image(0, y, 0)) - double(once.image(size.width - 1, y, 0)));
        for (int x = 1; x < size.width; ++x)
            inside +=
                std::abs(double(once.image(x, y, 0)) - double(once.image(x - 1, y, 0))) / (size.width - 1);
    }
    EXPECT_LT(seam, 2 * inside);
}

TEST(RegularTile, saysWhatItDidWithoutALattice) {
    const Synthesis result = run(blobs({64, 64}, 3), sized({90, 90}), {});
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_THAT(result.notes.front(), says("No lattice was found in tiles"));
}

TEST(RegularTile, refusesVectorsThatSpanNoTile) {
    const auto given = [](double v2x, double v2y) {
        return Values{{"lattice", "given"}, {"v1-x", 20.0}, {"v1-y", 10.0}, {"v2-x", v2x}, {"v2-y", v2y}};
    };
    EXPECT_THROW(run(blobs({64, 64}, 3), sized({90, 90}), given(40, 20)), UsageError);
    EXPECT_THROW(run(blobs({64, 64}, 3), sized({90, 90}), given(0, 0)), UsageError);
    EXPECT_THROW(run(blobs({64, 64}, 3), sized({90, 90}), given(0, 70)), UsageError);
}

} // namespace
} // namespace texloom::regular_tile

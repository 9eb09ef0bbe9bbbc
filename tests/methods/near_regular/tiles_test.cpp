#include "core/job/random.h"
#include "core/methods/method.h"
#include "tests/core/refusal.h"
#include "tests/support/lattices.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <optional>
#include <utility>

/// Whole tiles stitched along the lattice (Liu, Tsin & Lin, IJCV 62, 2005).
namespace texloom::test::near_regular_tests {
namespace {

Values byTiles(const Lattice& lattice, const Values& more = {}) {
    const Values values = {{"unit", std::string("tiles")}, {"lattice", std::string("given")},
                           {"v1-x", lattice.v1.x},         {"v1-y", lattice.v1.y},
                           {"v2-x", lattice.v2.x},         {"v2-y", lattice.v2.y}};
    return with(values, more);
}

Synthesis stitched(const Request& request, const Values& settings, int threads = 2) {
    return resultOf(findMethod("near-regular"), request, settings, {.threads = threads});
}

constexpr int kBrickWidth = 32, kBrickHeight = 16;

/// The brick of a running bond that a pixel lies in, or nothing in joints, 2 px wide.
std::optional<std::pair<int, int>> brickAt(int x, int y) {
    const int row = y / kBrickHeight, along = x + (row % 2) * kBrickWidth / 2;
    if (y % kBrickHeight < 2 || along % kBrickWidth < 2)
        return {};
    return std::pair(along / kBrickWidth, row);
}

/// Bricks in running bond, each of a tone of its own.
Image bricksOfManyTones(Size size) {
    const Random tones(11);
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto brick = brickAt(x, y);
            image(x, y, 0) =
                brick ? static_cast<float>(0.3 + 0.7 * tones.uniform(brick->first, brick->second)) : 0.0F;
        }
    return image;
}

} // namespace

TEST(WholeTiles, KeepBricksOfOneTone) {
    const Lattice lattice{{kBrickWidth, 0}, {kBrickWidth / 2, kBrickHeight}};
    const Size size{224, 192};
    for (const double right : {0.0, 9.0}) {
        const int shift = static_cast<int>(right);
        const Request request = requestOf(bricksOfManyTones({208, 176}), size);
        const Synthesis result = stitched(request, byTiles(lattice, {{"tolerance", 0}, {"origin-x", right}}));
        std::map<std::pair<int, int>, std::map<float, int>> tones;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (const auto brick = brickAt(x + shift, y))
                    ++tones[*brick][result.image(x, y, 0)];
        int torn = 0;
        for (const auto& [brick, counts] : tones)
            torn += counts.size() > 1 ? 1 : 0;
        EXPECT_LT(torn, 0.05 * static_cast<double>(tones.size())) << right;
        EXPECT_GT(tones.size(), 70U);
    }
}

TEST(WholeTiles, ContinueAPeriodicExemplarForEver) {
    for (const Lattice& lattice :
         {Lattice{{16, 0}, {0, 12}}, Lattice{{20, 0}, {10, 9}}, Lattice{{14, 5}, {-3, 13}}}) {
        const Request request = requestOf(regularTexture({90, 84}, 3, lattice, {}, 5), {150, 131});
        const Synthesis result = stitched(request, byTiles(lattice));
        EXPECT_EQ(result.mapKind, MapKind::Exact);
        EXPECT_TRUE(samePixels(result.map.apply(*request.exemplars.front().image), result.image));
        for (int y = 20; y + 20 < 131; ++y)
            for (int x = 20; x + 20 < 150; ++x) {
                ASSERT_NEAR(result.image(x, y, 1),
                            result.image(x + int(lattice.v1.x), y + int(lattice.v1.y), 1), 1e-4);
                ASSERT_NEAR(result.image(x, y, 1),
                            result.image(x + int(lattice.v2.x), y + int(lattice.v2.y), 1), 1e-4);
            }
    }
}

TEST(WholeTiles, LieOnTheLatticeUpToTheTolerance) {
    // The given vectors are a pixel off, for which tiles that may move make up.
    const Lattice lattice{{20.5, 1}, {-2, 17.25}};
    const Request request =
        requestOf(regularTexture({128, 110}, 3, {{19.5, 1}, {-2, 17.25}}, {.noise = 0.2}, 5), {170, 140});
    for (const int tolerance : {0, 2}) {
        const Synthesis result =
            stitched(request, byTiles(lattice, {{"tolerance", tolerance}, {"origin-x", 4.0}}));
        double most = 0;
        for (int y = 0; y < 140; ++y)
            for (int x = 0; x < 170; ++x) {
                const Source& from = result.map.at(x, y);
                ASSERT_TRUE(from.valid());
                const Vec2 away = Vec2{double(from.x), double(from.y)} - Vec2{x + 4.0, double(y)};
                const Vec2 off = away - lattice.nearest(away);
                most = std::max({most, std::abs(off.x), std::abs(off.y)});
            }
        EXPECT_LE(most, tolerance + 0.51);
        EXPECT_GT(most, tolerance - 0.5);
    }
}

TEST(WholeTiles, VaryWithTheSeedAndNotWithTheThreads) {
    const Lattice lattice{{18, 0}, {0, 16}};
    Request request = requestOf(regularTexture({128, 110}, 3, lattice, {.noise = 0.3}, 5), {120, 100});
    const Synthesis one = stitched(request, byTiles(lattice), 1);
    EXPECT_TRUE(samePixels(one.image, stitched(request, byTiles(lattice), 3).image));
    request.seed = 4;
    EXPECT_FALSE(samePixels(one.image, stitched(request, byTiles(lattice)).image));
    // Neighbouring tiles come from different places: the exemplar is not copied whole.
    int jumps = 0;
    for (int y = 0; y < 100; ++y)
        for (int x = 1; x < 120; ++x)
            jumps += one.map.at(x, y).x != one.map.at(x - 1, y).x + 1 ? 1 : 0;
    EXPECT_GT(jumps, 100 * 3);
}

TEST(WholeTiles, CloseOverTheBordersAndGiveParts) {
    const Lattice lattice{{20, 0}, {10, 15}};
    for (const Wrap wrap : {Wrap{}, Wrap{true, false}, Wrap{true, true}}) {
        Request request =
            requestOf(regularTexture({100, 96}, 3, lattice, {.noise = 0.1}, 5), {120, 90}, wrap);
        const Synthesis whole = stitched(request, byTiles(lattice));
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x)
                ASSERT_TRUE(whole.map.at(x, y).valid());
        double seam = 0, inside = 0;
        for (int y = 0; y < 90; ++y) {
            seam += std::abs(double(whole.image(0, y, 0)) - double(whole.image(119, y, 0)));
            for (int x = 1; x < 120; ++x)
                inside += std::abs(double(whole.image(x, y, 0)) - double(whole.image(x - 1, y, 0))) / 119;
        }
        if (wrap.x) {
            EXPECT_LT(seam, 1.6 * inside);
        }
        request.region = Region{31, 20, {50, 40}};
        const Synthesis part = stitched(request, byTiles(lattice));
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 50; ++x)
                ASSERT_EQ(part.map.at(x, y), whole.map.at(31 + x, 20 + y));
    }
}

TEST(WholeTiles, HoldWithRowsAloneAndWithoutALattice) {
    for (const char* lattice : {"automatic", "none"}) {
        const Request request = requestOf(blobs({80, 70}, 3), {110, 90});
        const Synthesis result = stitched(request, {{"unit", std::string("tiles")},
                                                    {"lattice", std::string(lattice)},
                                                    {"block", 20},
                                                    {"flatten", std::string("no")}});
        EXPECT_TRUE(samePixels(result.map.apply(*request.exemplars.front().image), result.image));
    }
    const Request request = requestOf(blobs({80, 70}, 3), {110, 90});
    const Synthesis rows =
        stitched(request, byTiles({{1, 0}, {0, 14}}, {{"block", 24}, {"flatten", std::string("no")}}));
    EXPECT_TRUE(samePixels(rows.map.apply(*request.exemplars.front().image), rows.image));
}

TEST(WholeTiles, NothingComesFromUnderTheMask) {
    const Lattice lattice{{18, 0}, {0, 16}};
    Request request = requestOf(regularTexture({128, 110}, 3, lattice, {.noise = 0.1}, 5), {120, 100});
    Image mask({128, 110}, 1);
    for (int y = 0; y < 110; ++y)
        for (int x = 0; x < 128; ++x)
            mask(x, y, 0) = x > 60 && y > 60 ? 0.0F : 1.0F;
    request.exemplars.front().inputs.set(kMaskPort, std::make_shared<const Image>(mask));
    const Synthesis result = stitched(request, byTiles(lattice));
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 120; ++x)
            ASSERT_NE(mask(result.map.at(x, y).x, result.map.at(x, y).y, 0), 0);
    for (int y = 0; y < 110; ++y)
        for (int x = 0; x < 128; ++x)
            mask(x, y, 0) = (x + y) % 12 == 0 ? 0.0F : 1.0F;
    request.exemplars.front().inputs.set(kMaskPort, std::make_shared<const Image>(mask));
    EXPECT_THAT([&] { stitched(request, byTiles(lattice)); }, refusal("no whole tile"));
}

} // namespace texloom::test::near_regular_tests

#include "core/base/error.h"
#include "core/methods/method.h"
#include "core/methods/regular_tile/tile_family.h"
#include "core/methods/regular_tile/tile_search.h"
#include "tests/support/lattices.h"
#include "tests/support/method_run.h"
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
    request.exemplars = {{"tiles", std::make_shared<const Image>(exemplar)}};
    return test::resultOf(findMethod("regular-tile"), request, settings);
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

/// A family of the tiles of an exemplar, with a tile's corner at (5, 4).
TileFamily familyOf(const Image& exemplar, const Lattice& lattice, int margin, int bases,
                    const Image* mask = nullptr) {
    JobMonitor monitor;
    JobContext context(
        {0, 2, false}, [] { return false; }, monitor);
    return {exemplar, mask ? mask->view().plane(0) : PlaneView{}, lattice, lattice, {5, 4, 0}, margin, bases,
            context};
}

std::vector<float> pixelOf(const TileFamily& family, const std::vector<float>& coefficients, int dx, int dy) {
    std::vector<float> pixel(3, 0.0F);
    family.add(coefficients, dx, dy, 1, pixel.data());
    return pixel;
}

TEST(TileFamily, withAllComponentsAndATilesCoefficientsItIsThatTile) {
    const Image exemplar = blobs({70, 60}, 3);
    const TileFamily family = familyOf(exemplar, {{16, 0}, {0, 14}}, 0, 64);
    // Whole tiles begin at 5, 21, 37 and 53, and at 4, 18, 32 and 46.
    ASSERT_EQ(family.tiles(), 16);
    ASSERT_EQ(family.bases(), family.tiles() - 1);
    EXPECT_NEAR(family.share(), 1, 1e-6);
    int found = 0;
    for (int tile = 0; tile < family.tiles(); ++tile) {
        const std::vector<float> coefficients = family.coefficients(tile);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                double most = 0;
                for (int dy = 0; dy < 14; ++dy)
                    for (int dx = 0; dx < 16; ++dx)
                        for (int c = 0; c < 3; ++c)
                            most = std::max(
                                most, std::abs(double(pixelOf(family, coefficients, dx,
                                                              dy)[static_cast<std::size_t>(c)]) -
                                               double(exemplar(5 + 16 * column + dx, 4 + 14 * row + dy, c))));
                found += most < 1e-4 ? 1 : 0;
            }
    }
    EXPECT_EQ(found, family.tiles());
}

TEST(TileFamily, componentsAreOrthonormalAndTakeTheirVarianceInOrder) {
    const TileFamily family = familyOf(blobs({90, 80}, 3), {{16, 3}, {-2, 14}}, 4, 6);
    ASSERT_EQ(family.bases(), 6);
    std::vector<std::vector<double>> axes(6);
    for (int dy = -20; dy < 40; ++dy)
        for (int dx = -20; dx < 40; ++dx) {
            if (!family.has(dx, dy))
                continue;
            const std::vector<float> mean = pixelOf(family, std::vector<float>(6, 0.0F), dx, dy);
            for (std::size_t i = 0; i < 6; ++i) {
                std::vector<float> one(6, 0.0F);
                one[i] = 1;
                const std::vector<float> pixel = pixelOf(family, one, dx, dy);
                for (std::size_t c = 0; c < 3; ++c)
                    axes[i].push_back(double(pixel[c]) - double(mean[c]));
            }
        }
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double product = 0;
            for (std::size_t v = 0; v < axes[i].size(); ++v)
                product += axes[i][v] * axes[j][v];
            EXPECT_NEAR(product, i == j ? 1 : 0, 1e-3);
        }
        double squares = 0;
        for (int tile = 0; tile < family.tiles(); ++tile)
            squares += std::pow(double(family.coefficients(tile)[i]), 2);
        EXPECT_NEAR(squares / family.tiles(), family.variances()[i], 1e-4 * family.variances()[0]);
        if (i > 0) {
            EXPECT_LE(family.variances()[i], family.variances()[i - 1]);
        }
    }
}

TEST(TileFamily, tilesThatAMaskTouchesDoNotCount) {
    const Image exemplar = blobs({70, 60}, 3);
    Image mask({70, 60}, 1);
    for (int y = 0; y < 60; ++y)
        std::fill_n(mask.plane(0).row(y), 70, y == 40 ? 0.0F : 1.0F);
    EXPECT_EQ(familyOf(exemplar, {{16, 0}, {0, 14}}, 0, 4, &mask).tiles(), 12);
}

TEST(RegularTile, variedTilesFollowTheExemplarsMeanAndVariance) {
    const Lattice lattice{{16, 0}, {0, 12}};
    const Image exemplar = regularTexture({192, 180}, 3, lattice, {.noise = 0.1}, 5);
    const Values settings = {{"lattice", "given"}, {"v1-x", 16.0},    {"v1-y", 0.0},   {"v2-x", 0.0},
                             {"v2-y", 12.0},       {"tile", "given"}, {"tile-x", 0.0}, {"tile-y", 0.0},
                             {"colour", "varied"}, {"feather", 0}};
    Values mean = settings, resample = settings;
    mean["bases"] = 0;
    resample["draw"] = std::string("resample");
    const Synthesis plain = run(exemplar, sized({160, 120}), mean);
    EXPECT_EQ(plain.mapKind, MapKind::Estimated);
    EXPECT_EQ(plain.image(3, 5, 1), plain.image(3 + 16 * 4, 5 + 12 * 3, 1)) << "the mean tile repeats";
    for (const Values& values : {settings, resample}) {
        const Synthesis varied = run(exemplar, sized({160, 120}), values);
        EXPECT_NE(varied.image(3, 5, 1), varied.image(3 + 16 * 4, 5 + 12 * 3, 1));
        // Over many tiles their mean is that of the exemplar's, and they vary as much as its components do.
        double off = 0, square = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x) {
                const double difference = double(varied.image(x, y, 1)) - double(plain.image(x, y, 1));
                off += difference / (160 * 120);
                square += difference * difference / (160 * 120);
            }
        EXPECT_NEAR(off, 0, 0.02);
        EXPECT_GT(square, 0.02 * 0.1 * 0.1);
        EXPECT_LT(square, 2 * 0.1 * 0.1);
    }
}

TEST(RegularTile, variedTilesCloseAndAPartIsThatOfTheWhole) {
    const Image exemplar = regularTexture({100, 96}, 3, {{18.4, 0}, {9.2, 14}}, {.noise = 0.1}, 5);
    Request request = sized({147, 113}, {true, true});
    const Values settings = {{"colour", "varied"}};
    const Synthesis whole = run(exemplar, request, settings);
    double seam = 0, inside = 0;
    for (int y = 0; y < 113; ++y) {
        seam += std::abs(double(whole.image(0, y, 0)) - double(whole.image(146, y, 0)));
        for (int x = 1; x < 147; ++x)
            inside += std::abs(double(whole.image(x, y, 0)) - double(whole.image(x - 1, y, 0))) / 146;
    }
    EXPECT_LT(seam, 1.5 * inside);
    request.region = Region{31, 40, {60, 50}};
    const Synthesis part = run(exemplar, request, settings);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 60; ++x)
            ASSERT_EQ(part.image(x, y, 2), whole.image(31 + x, 40 + y, 2));
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

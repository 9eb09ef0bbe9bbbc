#include "core/analysis/layout_quality.h"
#include "core/analysis/map_usage.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

/// A map that copies squares of `side` px from the places that `from(column, row)` gives.
template <class From> PositionMap squares(Size size, Size exemplar, int side, const From& from) {
    PositionMap map(size, {exemplar});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Source corner = from(x / side, y / side);
            map.at(x, y) = {static_cast<std::uint16_t>(corner.x + x % side),
                            static_cast<std::uint16_t>(corner.y + y % side), 0};
        }
    return map;
}

/// Tiles of one noise, each with a little of its own.
Image tiles(Size size, int side, float own) {
    const Image tile = noise({side, side}, 1, 5), more = noise(size, 1, 6);
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(x, y, 0) = tile(x % side, y % side, 0) + own * more(x, y, 0);
    return image;
}

TEST(LayoutQuality, contrastIsTheShareOfTheDeviation) {
    const Image exemplar = blobs({50, 40}, 3);
    Image faded(exemplar);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 50; ++x)
                faded(x, y, c) = 0.2F + 0.25F * exemplar(x, y, c);
    const ImageView one = exemplar;
    EXPECT_NEAR(contrastKept(exemplar, {&one, 1}), 1, 1e-6);
    EXPECT_NEAR(contrastKept(faded, {&one, 1}), 0.25, 1e-5);
    const Image flat = constant({9, 9}, 3, 0.5F);
    const ImageView flatOne = flat;
    EXPECT_EQ(contrastKept(exemplar, {&flatOne, 1}), 1);
}

TEST(LayoutQuality, jumpsAreNothingWithinACopyAndAsLargeAsPiecesDiffer) {
    const Image exemplar = blobs({60, 60}, 2);
    const ImageView one = exemplar;
    const PositionMap copy = squares({30, 30}, {60, 60}, 30, [](int, int) { return Source{12, 9, 0}; });
    EXPECT_EQ(seamJump(copy.apply(one), {&one, 1}, copy), 0);

    // Two halves of white noise: what lies across the border is as far from what should as any two pixels.
    const Image white = noise({60, 60}, 1);
    const ImageView whiteOne = white;
    const PositionMap halves = squares({40, 20}, {60, 60}, 20, [](int column, int) {
        return column == 0 ? Source{3, 3, 0} : Source{31, 35, 0};
    });
    // 2 × 20 of the 2 (39 × 20 + 40 × 19) ordered pairs of neighbours cross the border: √(40/3080 × 2).
    EXPECT_NEAR(seamJump(halves.apply(whiteOne), {&whiteOne, 1}, halves), std::sqrt(40.0 / 3080 * 2), 0.04);
}

TEST(LayoutQuality, oneRepeatedPieceIsTheMostUsed) {
    const PositionMap even = squares({80, 80}, {80, 80}, 80, [](int, int) { return Source{0, 0, 0}; });
    EXPECT_NEAR(mostUsedShare(occurrencesOf(even)), 1.0 / 64, 1e-6);
    const PositionMap garbage = squares({80, 80}, {80, 80}, 10, [](int, int) { return Source{40, 20, 0}; });
    EXPECT_NEAR(mostUsedShare(occurrencesOf(garbage)), 1, 1e-6);
}

TEST(LayoutQuality, brokenTilesHaveAnotherAutocorrelationAndNoLattice) {
    const Image exemplar = tiles({96, 96}, 12, 0.3F);
    const ImageView one = exemplar;
    const Lattice lattice{{12, 0}, {0, 12}};
    const Image whole(exemplar.view().crop(24, 12, {72, 72}));
    // The same pixels in pieces that meet anywhere.
    const PositionMap pieces = squares({72, 72}, {96, 96}, 9, [](int column, int row) {
        return Source{static_cast<std::uint16_t>((column * 37 + row * 11) % 87),
                      static_cast<std::uint16_t>((column * 23 + row * 53) % 87), 0};
    });
    const Image broken = pieces.apply(one);
    EXPECT_LT(correlationApart(whole, {&one, 1}), 0.05);
    EXPECT_GT(correlationApart(broken, {&one, 1}), 2 * correlationApart(whole, {&one, 1}));
    EXPECT_NEAR(latticeKept(whole, exemplar, lattice), 1, 0.05);
    EXPECT_LT(latticeKept(broken, exemplar, lattice), 0.3);
}

} // namespace
} // namespace texloom::test

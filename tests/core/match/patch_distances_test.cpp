#include "core/match/patch_distances.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace texloom::test {

namespace {

struct Case {
    Size exemplar;
    int channels;
    int patch;
    Footprint shape;
    float scale = 1; ///< of the values: 1, or 255 as the sources have them

    friend void PrintTo(const Case& c, std::ostream* out) {
        *out << c.exemplar.width << 'x' << c.exemplar.height << 'x' << c.channels << " patch " << c.patch;
    }
};

Image scaled(Image image, float factor) {
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                image(x, y, c) *= factor;
    return image;
}

double slowDistance(const Image& exemplar, const Image& known, const Footprint& shape, int patch, int m,
                    int n) {
    double sum = 0;
    for (int c = 0; c < exemplar.channels(); ++c)
        for (int y = 0; y < patch; ++y)
            for (int x = 0; x < patch; ++x)
                if (shape.contains(x, y, patch)) {
                    const double difference =
                        static_cast<double>(exemplar(m + x, n + y, c)) - static_cast<double>(known(x, y, c));
                    sum += difference * difference;
                }
    return sum;
}

/// Computes all distances and hands each position to `look` with the fast and the slow one.
template <class Look> void compare(const Case& c, const Image& mask, float smallest, const Look& look) {
    const Image exemplar = scaled(noise(c.exemplar, c.channels, 3), c.scale);
    const Image known = scaled(noise({c.patch, c.patch}, c.channels, 4), c.scale);
    const PlaneView maskPlane = mask.empty() ? PlaneView{} : mask.plane(0);
    PatchDistances distances(exemplar, maskPlane, channelMeans(exemplar), c.patch);
    distances.prepare(c.shape);
    PatchDistances::Scratch scratch = distances.scratch();
    distances.compute(known, c.shape, smallest, scratch, [] {});
    for (int n = 0; n < distances.positions().height; ++n)
        for (int m = 0; m < distances.positions().width; ++m)
            look(m, n, static_cast<double>(distances.distanceRow(scratch, n)[m]),
                 slowDistance(exemplar, known, c.shape, c.patch, m, n), scratch);
}

} // namespace

class PatchDistanceCases : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(PatchDistances, PatchDistanceCases,
                         ::testing::Values(Case{{40, 32}, 1, 8, Overlap{3, 0, 0, 0}},
                                           Case{{41, 33}, 3, 9, Overlap{0, 4, 0, 0}},
                                           Case{{37, 53}, 3, 10, Overlap{3, 4, 0, 0}},
                                           Case{{29, 31}, 4, 11, Overlap{2, 3, 4, 5}},
                                           Case{{64, 17}, 2, 12, Overlap{0, 0, 6, 6}},
                                           Case{{23, 47}, 3, 13, Footprint::filled({13, 13})},
                                           Case{{23, 47}, 3, 13, Footprint::filled({5, 9})},
                                           Case{{16, 16}, 3, 16, Overlap{4, 4, 0, 0}},
                                           Case{{100, 75}, 3, 24, Overlap{6, 6, 6, 0}, 255},
                                           Case{{61, 97}, 1, 20, Overlap{10, 0, 10, 0}, 255}));

TEST_P(PatchDistanceCases, AreThoseOfBruteForce) {
    double largest = 0;
    compare(GetParam(), {}, 0,
            [&](int, int, double, double slow, const auto&) { largest = std::max(largest, slow); });
    compare(GetParam(), {}, 0, [&](int m, int n, double fast, double slow, const auto&) {
        ASSERT_NEAR(fast, slow, 1e-5 * largest) << m << ' ' << n;
    });
}

TEST_P(PatchDistanceCases, RowMinimaAreTheSmallestOfEachRow) {
    std::vector<double> minima(static_cast<std::size_t>(GetParam().exemplar.height), HUGE_VAL);
    compare(GetParam(), {}, 0, [&](int, int n, double fast, double, const auto&) {
        double& minimum = minima[static_cast<std::size_t>(n)];
        minimum = std::min(minimum, fast);
    });
    compare(GetParam(), {}, 0, [&](int, int n, double, double, const PatchDistances::Scratch& scratch) {
        ASSERT_EQ(static_cast<double>(scratch.rowMinima[static_cast<std::size_t>(n)]),
                  minima[static_cast<std::size_t>(n)]);
    });
}

TEST(PatchDistances, MaskedPatchesAreInfinitelyFar) {
    const Case c{{30, 26}, 3, 7, Overlap{2, 2, 0, 0}};
    Image mask = constant(c.exemplar, 1, 1);
    mask(12, 9, 0) = 0;
    mask(29, 25, 0) = 0;
    compare(c, mask, 0, [&](int m, int n, double fast, double slow, const auto&) {
        bool masked = false;
        for (int y = 0; y < c.patch; ++y)
            for (int x = 0; x < c.patch; ++x)
                masked = masked || mask(m + x, n + y, 0) == 0;
        if (masked)
            ASSERT_EQ(fast, HUGE_VAL);
        else
            ASSERT_NEAR(fast, slow, 1e-3);
    });
}

TEST(PatchDistances, CountsThePatchesThatTheMaskAllows) {
    const Size size{30, 26};
    const Image exemplar = noise(size, 1);
    Image mask = constant(size, 1, 1);
    for (int y = 0; y < 26; ++y)
        mask(10, y, 0) = 0;
    const PatchDistances distances(exemplar, mask.plane(0), channelMeans(exemplar), 7);
    // Left of the column 10 − 7 + 1 positions across, right of it 19 − 7 + 1; 20 positions down.
    EXPECT_EQ(distances.allowed(), (4 + 13) * 20);
    EXPECT_TRUE(distances.allows(3, 0));
    EXPECT_FALSE(distances.allows(4, 0));
    EXPECT_FALSE(distances.allows(10, 0));
    EXPECT_TRUE(distances.allows(11, 0));
}

TEST(PatchDistances, AreRaisedToTheSmallest) {
    const Image exemplar = noise({30, 30}, 3, 3);
    PatchDistances distances(exemplar, {}, channelMeans(exemplar), 8);
    const Footprint shape = Overlap{3, 3, 0, 0};
    distances.prepare(shape);
    PatchDistances::Scratch scratch = distances.scratch();
    distances.compute(exemplar.view().crop(5, 6, {8, 8}), shape, 0.01F, scratch, [] {});
    EXPECT_EQ(distances.distanceRow(scratch, 6)[5], 0.01F);
}

TEST(PatchDistances, DoNotDependOnTheMeans) {
    const Image exemplar = noise({40, 28}, 3, 3);
    const Image known = noise({9, 9}, 3, 4);
    const Footprint shape = Overlap{3, 0, 2, 0};
    PatchDistances plain(exemplar, {}, {0, 0, 0}, 9);
    PatchDistances centred(exemplar, {}, channelMeans(exemplar), 9);
    PatchDistances::Scratch a = plain.scratch(), b = centred.scratch();
    plain.prepare(shape);
    centred.prepare(shape);
    plain.compute(known, shape, 0, a, [] {});
    centred.compute(known, shape, 0, b, [] {});
    for (int n = 0; n < plain.positions().height; ++n)
        for (int m = 0; m < plain.positions().width; ++m)
            ASSERT_NEAR(plain.distanceRow(a, n)[m], centred.distanceRow(b, n)[m], 1e-3);
}

TEST(PatchDistances, BalancedOnesAreDividedByTheContrastOfThePatch) {
    const Image exemplar = noise({40, 28}, 3, 3), known = noise({9, 9}, 3, 4);
    const std::vector<double> means = channelMeans(exemplar);
    const Footprint shape = Overlap{3, 4, 0, 0};
    PatchDistances plain(exemplar, {}, means, 9);
    PatchDistances balanced(exemplar, {}, means, 9, {0.7, 0.2});
    PatchDistances::Scratch a = plain.scratch(), b = balanced.scratch();
    plain.prepare(shape);
    balanced.prepare(shape);
    plain.compute(known, shape, 0, a, [] {});
    balanced.compute(known, shape, 0, b, [] {});
    for (int n = 0; n < plain.positions().height; ++n) {
        float least = HUGE_VALF;
        for (int m = 0; m < plain.positions().width; ++m) {
            double contrast = 0, pixels = 0;
            for (int c = 0; c < 3; ++c) {
                double sum = 0, squares = 0;
                pixels = 0;
                for (int y = 0; y < 9; ++y)
                    for (int x = 0; x < 9; ++x)
                        if (shape.contains(x, y, 9)) {
                            const auto value = static_cast<double>(exemplar(m + x, n + y, c));
                            ++pixels;
                            sum += value;
                            squares += value * value;
                        }
                contrast += squares - sum * sum / pixels;
            }
            const double factor = std::pow(contrast / (0.2 * pixels) + 0.02, -0.35);
            const float found = balanced.distanceRow(b, n)[m];
            ASSERT_NEAR(found, factor * static_cast<double>(plain.distanceRow(a, n)[m]), 1e-4);
            least = std::min(least, found);
        }
        ASSERT_EQ(b.rowMinima[static_cast<std::size_t>(n)], least);
    }
}

TEST(PatchDistances, ComeOutTheSameFromAUsedScratch) {
    const Image exemplar = noise({40, 28}, 3, 3);
    const Image known = noise({9, 9}, 3, 4);
    const Footprint shape = Overlap{3, 0, 2, 0};
    PatchDistances distances(exemplar, {}, channelMeans(exemplar), 9);
    distances.prepare(shape);
    distances.prepare(Footprint::filled({9, 9}));
    PatchDistances::Scratch fresh = distances.scratch(), used = distances.scratch();
    distances.compute(noise({9, 9}, 3, 8), Footprint::filled({9, 9}), 0, used, [] {});
    distances.compute(known, shape, 0, used, [] {});
    distances.compute(known, shape, 0, fresh, [] {});
    for (int n = 0; n < distances.positions().height; ++n)
        for (int m = 0; m < distances.positions().width; ++m)
            ASSERT_EQ(distances.distanceRow(fresh, n)[m], distances.distanceRow(used, n)[m]);
}

TEST(PatchDistances, StopWhenToldTo) {
    const Image exemplar = noise({40, 28}, 3, 3);
    const Footprint shape = Footprint::filled({9, 9});
    PatchDistances distances(exemplar, {}, channelMeans(exemplar), 9);
    distances.prepare(shape);
    PatchDistances::Scratch scratch = distances.scratch();
    EXPECT_THROW(distances.compute(noise({9, 9}, 3), shape, 0, scratch, [] { throw 1; }), int);
}

TEST(Footprint, CountsThePixelsThatItContains) {
    const int patch = 9;
    EXPECT_EQ(Footprint(Overlap{}).pixels(patch), 0);
    EXPECT_EQ(Footprint(Overlap{3, 2, 0, 0}).pixels(patch), 81 - 6 * 7);
    EXPECT_EQ(Footprint(Overlap{3, 2, 1, 4}).pixels(patch), 81 - 5 * 3);
    EXPECT_EQ(Footprint::filled({9, 9}).pixels(patch), 81);
    EXPECT_EQ(Footprint::filled({4, 7}).pixels(patch), 28);
}

} // namespace texloom::test

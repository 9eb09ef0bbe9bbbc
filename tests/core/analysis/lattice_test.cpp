#include "core/analysis/lattice.h"
#include "core/analysis/lattice_detector.h"
#include "core/analysis/lattice_settings.h"
#include "core/job/job_context.h"
#include "core/job/random.h"
#include "tests/support/lattices.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace texloom::test {
namespace {

TEST(Lattice, holdsTheSharesOfTheSourcesTile) {
    const Lattice tile{{5, 3}, {-6, 4}};
    EXPECT_EQ(tile.area(), 38);
    EXPECT_DOUBLE_EQ(tileCoverage(tile, {3, 8}), 22.0 / 38);
    EXPECT_DOUBLE_EQ(tileCoverage(tile, {5, 7}), 35.0 / 38);
    EXPECT_EQ(tileCoverage(tile, {11, 7}), 1);
    EXPECT_EQ(tileCoverage(tile, {0, 7}), 0);
    EXPECT_EQ(tileCoverage({{4, 2}, {2, 1}}, {9, 9}), 0);
}

/// Eq. 3.29 pixel by pixel, in whole numbers: how many classes the rectangle's pixels fall into.
double coverageByWrapping(const Lattice& tile, Size rectangle) {
    const auto divided = [](long a, long b) { return a >= 0 ? a / b : -((-a + b - 1) / b); };
    const long x1 = std::lround(tile.v1.x), y1 = std::lround(tile.v1.y), x2 = std::lround(tile.v2.x),
               y2 = std::lround(tile.v2.y), area = x1 * y2 - y1 * x2, sign = area < 0 ? -1 : 1;
    std::set<std::pair<long, long>> wrapped;
    for (long y = 0; y < rectangle.height; ++y)
        for (long x = 0; x < rectangle.width; ++x) {
            const long a = divided(sign * (x * y2 - y * x2), sign * area);
            const long b = divided(sign * (x1 * y - y1 * x), sign * area);
            wrapped.emplace(x - a * x1 - b * x2, y - a * y1 - b * y2);
        }
    return double(wrapped.size()) / double(std::labs(area));
}

TEST(Lattice, coverageEqualsCountingWrappedPixels) {
    for (const Lattice& tile : {Lattice{{5, 3}, {-6, 4}}, Lattice{{7, 0}, {0, 4}}, Lattice{{8, 0}, {4, 5}},
                                Lattice{{3, -7}, {9, 2}}, Lattice{{1, 0}, {0, 12}}, Lattice{{6, 6}, {6, -6}}})
        for (int width = 1; width < 16; ++width)
            for (int height = 1; height < 16; ++height)
                EXPECT_DOUBLE_EQ(tileCoverage(tile, {width, height}),
                                 coverageByWrapping(tile, {width, height}))
                    << tile.v1.x << ", " << tile.v1.y << ": " << width << " × " << height;
}

TEST(Lattice, isReducedToItsShortestVectors) {
    const Lattice brick{{20, 0}, {10, 6}};
    for (const Lattice& same : {brick, Lattice{{10, 6}, {30, 6}}, Lattice{{-20, 0}, {70, -6}}}) {
        const Lattice reduced = same.reduced();
        EXPECT_NEAR(reduced.area(), 120, 1e-9);
        EXPECT_NEAR(reduced.v1.length(), std::hypot(10, 6), 1e-9);
        EXPECT_NEAR(reduced.v2.length(), std::hypot(10, 6), 1e-9);
        EXPECT_TRUE(reduced.like(brick, 1e-6));
    }
    EXPECT_FALSE((Lattice{{20, 0}, {0, 6}}.like(brick, 1)));
    EXPECT_FALSE((Lattice{{40, 0}, {10, 6}}.like(brick, 1)));
    EXPECT_TRUE(brick.includes({{40, 0}, {10, 6}}, 1e-6));
    EXPECT_EQ((Lattice{{0, 9}, {12, 0}}.reduced()), (Lattice{{12, 0}, {0, 9}}));
}

TEST(Lattice, tellsCoordinates) {
    const Lattice lattice{{5, 3}, {-6, 4}};
    const Vec2 c = lattice.coordinates(lattice.at(2.25, -7));
    EXPECT_NEAR(c.x, 2.25, 1e-12);
    EXPECT_NEAR(c.y, -7, 1e-12);
    EXPECT_NEAR((lattice.nearest({4, 3.5}) - lattice.v1).length(), 0, 1e-12);
}

/// What kind of case the search failed on, in the words of the source's fig. 5.1.
std::string failure(const LatticeCase& made, const LatticeAnalysis& found) {
    if (found.candidates.empty())
        return "nothing found";
    const double ratio = found.candidates.front().lattice.area() / made.lattice.area();
    if (!found.found())
        return "not trusted";
    return ratio > 1.4 ? "a larger tile" : ratio < 0.7 ? "a smaller tile" : "another lattice";
}

/// Cases 0 to `count`, and the share found within half a pixel. Fails are listed.
double shareFound(int count) {
    int right = 0;
    for (int i = 0; i < count; ++i) {
        const LatticeCase made = latticeCase(i);
        const LatticeAnalysis analysis = analyzeLattice(
            regularTexture(made.size, 3, made.lattice, made.regularity, static_cast<std::uint64_t>(i)));
        if (analysis.found() && analysis.candidates.front().lattice.like(made.lattice, 0.5)) {
            ++right;
            continue;
        }
        std::cout << "case " << i << ", " << made.kind << ", noise " << made.regularity.noise << ", change "
                  << made.regularity.colourChange << ", ramp " << made.regularity.ramp << ": "
                  << failure(made, analysis) << "\n";
    }
    return double(right) / count;
}

TEST(LatticeDetector, findsMadeUpLatticesWithinHalfAPixel) {
    EXPECT_GE(shareFound(40), 0.95);
}

/// A minute; run with --gtest_also_run_disabled_tests.
TEST(LatticeDetector, DISABLED_finds95OfAHundredInFiveHundred) {
    EXPECT_GE(shareFound(500), 0.95);
}

TEST(LatticeDetector, findsFractionsOfAPixel) {
    const Lattice truth{{23.37, 1.21}, {-0.64, 17.83}};
    const LatticeAnalysis analysis = analyzeLattice(regularTexture({256, 240}, 3, truth, {}, 3));
    ASSERT_TRUE(analysis.found());
    const Lattice found = analysis.candidates.front().lattice;
    EXPECT_NEAR((found.v1 - truth.v1).length(), 0, 0.06);
    EXPECT_NEAR((found.v2 - truth.v2).length(), 0, 0.06);
    EXPECT_GT(analysis.candidates.front().correlation, 0.7);
    EXPECT_LE(analysis.candidates.size(), 4U);
    for (std::size_t i = 2; i < analysis.candidates.size(); ++i)
        EXPECT_LE(analysis.candidates[i].goodness, analysis.candidates[i - 1].goodness);
}

TEST(LatticeDetector, fitsALatticeDrawnRoughlyAndKeepsItsVectors) {
    const Lattice truth{{33.3, 4.1}, {-6.2, 41.7}};
    const Image texture = regularTexture({300, 280}, 3, truth, {.noise = 0.2}, 5);
    const LatticeAnalysis analysis = analyzeLattice(texture);
    // Drawn two pixels off, and not the shortest pair.
    const Lattice drawn{{35.0, 3.0}, {28.5, 44.0}};
    const LatticeCandidate fitted = fittedLattice(analysis, drawn);
    EXPECT_LT((fitted.lattice.v1 - truth.v1).length(), 0.2);
    EXPECT_LT((fitted.lattice.v2 - (truth.v1 + truth.v2)).length(), 0.2);
    EXPECT_GT(fitted.goodness, 0.9 * analysis.candidates.front().goodness);
}

TEST(LatticeDetector, takesTheLargerTileWhereEveryOtherElementDiffers) {
    // Squares of 16 px, each second one darker: the tile is two of them (the source's fig. 5.1 c).
    Image board({160, 160}, 1);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x) {
            const bool joint = x % 16 < 2 || y % 16 < 2;
            board(x, y, 0) = joint ? 0.0F : (x / 16 + y / 16) % 2 == 0 ? 0.9F : 0.5F;
        }
    const LatticeAnalysis analysis = analyzeLattice(board);
    ASSERT_TRUE(analysis.found());
    EXPECT_TRUE(analysis.candidates.front().lattice.like({{16, 16}, {16, -16}}, 0.5));
}

TEST(LatticeDetector, prefersSmallerTilesAsMuchAsAlphaSays) {
    const auto best = [](double alpha) {
        return analyzeLattice(nearlyAlikeSquares(), [] {}, {.alpha = alpha}).candidates.front().lattice;
    };
    EXPECT_TRUE(best(1.12).like({{16, 16}, {16, -16}}, 0.5));
    EXPECT_TRUE(best(1.4).like({{16, 0}, {0, 16}}, 0.5));
}

TEST(LatticeDetector, countsTheMultiplesWhoseOverlapIsLargeEnough) {
    const Image texture = regularTexture({130, 120}, 1, {{33, 4}, {-6, 41}}, {}, 2);
    LatticeAnalysis analysis = analyzeLattice(texture);
    const auto multiples = [&](double significance) {
        analysis.criteria.significance = significance;
        return ratedLattice(analysis, {{33, 4}, {-6, 41}}).multiples;
    };
    EXPECT_GT(multiples(0.5), multiples(0.85));
    EXPECT_GT(multiples(0.85), multiples(1));
}

TEST(LatticeDetector, isFreeAlongALineWhereNothingChanges) {
    Image ribs = noise({200, 150}, 1);
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 200; ++x)
            ribs(x, y, 0) =
                static_cast<float>(std::sin(6.283185 * x / 12.5) + 0.5 * std::cos(12.56637 * x / 12.5)) +
                0.2F * ribs(x, y, 0);
    const LatticeAnalysis analysis = analyzeLattice(ribs);
    ASSERT_TRUE(analysis.found());
    EXPECT_TRUE(analysis.candidates.front().lattice.like({{12.5, 0}, {0, 1}}, 0.2));
}

/// The share of cases 0 to `count` whose courses are found, to half a pixel and a fraction of a degree, and
/// nothing else. Fails are listed.
double shareOfCoursesFound(int count) {
    int right = 0;
    for (int i = 0; i < count; ++i) {
        const CoursesCase made = coursesCase(i);
        const LatticeAnalysis analysis = analyzeLattice(coursesTexture(
            made.size, 3, made.along, made.distance, made.regularity, static_cast<std::uint64_t>(i)));
        const Lattice found = analysis.candidates.empty() ? Lattice{} : analysis.candidates.front().lattice;
        const Vec2 step = found.v1.length() < 1.5 ? found.v1 : found.v2;
        if (analysis.found() && std::abs(step.length() - 1) < 1e-6 &&
            std::abs(cross(step, made.along)) < 0.01 && std::abs(found.area() - made.distance) < 0.5) {
            ++right;
            continue;
        }
        std::cout << "case " << i << ", " << made.distance << " px, along " << made.along.x << ", "
                  << made.along.y << ", noise " << made.regularity.noise << ", change "
                  << made.regularity.colourChange << ", ramp " << made.regularity.ramp << ": (" << found.v1.x
                  << ", " << found.v1.y << ") and (" << found.v2.x << ", " << found.v2.y << "), confidence "
                  << analysis.confidence << "\n";
    }
    return double(right) / count;
}

TEST(LatticeDetector, findsCoursesOfStonesOfAnyLength) {
    EXPECT_GE(shareOfCoursesFound(40), 0.95);
}

/// Run with --gtest_also_run_disabled_tests.
TEST(LatticeDetector, DISABLED_finds95OfAHundredCourses) {
    EXPECT_GE(shareOfCoursesFound(200), 0.95);
}

TEST(LatticeDetector, findsTheDirectionOfRowsThatDoNotRepeat) {
    int right = 0, cases = 0;
    for (const double angle : {0.0, 1.5707963, 0.6, -0.2})
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
            const Vec2 along{std::cos(angle), std::sin(angle)};
            const Size size{220, 200};
            const LatticeAnalysis analysis = analyzeLattice(planksTexture(size, 3, along, 60, seed));
            const Lattice found =
                analysis.candidates.empty() ? Lattice{} : analysis.candidates.front().lattice;
            const Vec2 step = alongRows(found.v1) ? found.v1 : found.v2;
            ++cases;
            right +=
                analysis.found() && found.keepsOrder(size) && std::abs(cross(step, along)) < 0.01 ? 1 : 0;
        }
    EXPECT_GE(right, 19) << "of " << cases;
    // One and a half courses do not repeat either.
    const LatticeAnalysis tall = analyzeLattice(coursesTexture({128, 120}, 1, {1, 0}, 80, {}, 1));
    EXPECT_TRUE(!tall.found() || tall.candidates.front().lattice.keepsOrder({128, 120}));
}

TEST(Lattice, keepsTheOrderOfRowsThatTheExemplarShowsLessThanTwice) {
    const Size size{200, 100};
    EXPECT_TRUE((Lattice{{1, 0}, {0, 50}}.keepsOrder(size)));
    EXPECT_FALSE((Lattice{{1, 0}, {0, 35}}.keepsOrder(size)));
    EXPECT_TRUE((Lattice{{90, 0}, {0, 1}}.keepsOrder(size)));
    EXPECT_FALSE((Lattice{{70, 0}, {0, 1}}.keepsOrder(size)));
    EXPECT_FALSE((Lattice{{90, 0}, {0, 50}}.keepsOrder(size)));
    EXPECT_FALSE(Lattice{}.keepsOrder(size));
}

TEST(LatticeDetector, offersTheSmallestTileAndTheRowsAsRunnersUp) {
    // Two tiles of 24 × 20 px that differ a little: the pair is the better fit, one tile half as good.
    Image pairs = regularTexture({240, 220}, 1, {{24, 0}, {0, 20}}, {}, 3);
    for (int y = 0; y < pairs.height(); ++y)
        for (int x = 0; x < pairs.width(); ++x)
            pairs(x, y, 0) += x / 24 % 2 == 0 ? 0.2F : 0.0F;
    const LatticeAnalysis analysis = analyzeLattice(pairs);
    ASSERT_TRUE(analysis.found());
    EXPECT_TRUE(analysis.candidates.front().lattice.like({{48, 0}, {0, 20}}, 0.5));
    EXPECT_TRUE(std::any_of(analysis.candidates.begin(), analysis.candidates.end(),
                            [](const LatticeCandidate& candidate) {
                                return candidate.lattice.like({{24, 0}, {0, 20}}, 0.5);
                            }));
}

TEST(LatticeDetector, fitsRowsDrawnRoughly) {
    const Image courses = coursesTexture({240, 200}, 1, {1, 0}, 31.4, {}, 2);
    const LatticeAnalysis analysis = analyzeLattice(courses);
    const LatticeCandidate drawn = fittedLattice(analysis, {{1, 0}, {0, 30}});
    EXPECT_NEAR(drawn.lattice.v2.y, 31.4, 0.2);
    EXPECT_EQ(drawn.lattice.v1, (Vec2{1, 0}));
}

TEST(LatticeDetector, doesNotTrustALatticeWhereThereIsNone) {
    EXPECT_FALSE(analyzeLattice(noise({128, 128}, 3)).found());
    EXPECT_FALSE(analyzeLattice(constant({64, 64}, 3, 0.5F)).found());
    EXPECT_FALSE(analyzeLattice(noise({5, 90}, 1)).found());
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U})
        EXPECT_FALSE(analyzeLattice(blobs({128, 128}, 3, seed)).found()) << seed;
    const Lattice large{{150, 4}, {3, 160}};
    EXPECT_FALSE(analyzeLattice(regularTexture({200, 210}, 3, large, {}, 1)).found());
}

TEST(LatticeSettings, anExemplarIsLookedAtOnce) {
    const auto bricks =
        std::make_shared<const Image>(regularTexture({120, 110}, 1, {{20, 0}, {10, 12}}, {}, 3));
    int looks = 0;
    std::vector<Message> notes;
    const auto lattice = [&](const std::shared_ptr<const Image>& exemplar) {
        return latticeFor({}, "bricks", exemplar, notes, [&looks] { ++looks; });
    };
    const Lattice first = lattice(bricks);
    EXPECT_FALSE(first.free());
    EXPECT_GT(looks, 0);
    looks = 0;
    EXPECT_EQ(lattice(bricks), first);
    EXPECT_EQ(looks, 0);
    const auto grain = std::make_shared<const Image>(noise({64, 64}, 1));
    EXPECT_TRUE(lattice(grain).free());
    EXPECT_TRUE(lattice(grain).free());
    EXPECT_EQ(notes.size(), 2U);
    EXPECT_EQ(notes.front(), notes.back());
    const auto squares = std::make_shared<const Image>(nearlyAlikeSquares());
    const auto found = [&](double alpha) {
        LatticeSettings settings;
        settings.alpha = alpha;
        return latticeFor(settings, "squares", squares, notes, [] {}).area();
    };
    EXPECT_NEAR(found(1.12), 512, 10);
    EXPECT_NEAR(found(1.4), 256, 10) << "other criteria, another search";
    // The place of an image that is gone says nothing of the next one there.
    EXPECT_FALSE(lattice(std::make_shared<const Image>(*bricks)).free());
    EXPECT_TRUE(lattice(std::make_shared<const Image>(noise({120, 110}, 1))).free());
}

TEST(LatticeDetector, canBeStopped) {
    int asked = 0;
    const auto check = [&asked] {
        if (++asked == 20)
            throw Cancelled{};
    };
    EXPECT_THROW(analyzeLattice(blobs({200, 200}, 3), check), Cancelled);
}

/// Bricks in running bond, each of a tone of its own, grainy, with every joint off its place by up to `loose`
/// pixels.
Image looseBricks(Size size, int width, int height, double loose, std::uint64_t seed) {
    const Random random(seed);
    const auto offset = [&](int a, int b, std::uint32_t of) {
        return loose * (2 * random.uniform(a, b, of) - 1);
    };
    const Image grain = noise(size, 1, seed);
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            int row = y / height;
            while (y < row * height + offset(0, row, 0))
                --row;
            while (y >= (row + 1) * height + offset(0, row + 1, 0))
                ++row;
            const double along = x + 0.5 * width * (row & 1);
            int brick = static_cast<int>(along / width);
            while (along < brick * width + offset(brick, row, 1))
                --brick;
            while (along >= (brick + 1) * width + offset(brick + 1, row, 1))
                ++brick;
            const double joint = std::min({y - (row * height + offset(0, row, 0)),
                                           along - (brick * width + offset(brick, row, 1)),
                                           (brick + 1) * width + offset(brick + 1, row, 1) - along});
            const double tone = joint < 2 ? 0.3 : 0.25 + 0.5 * random.uniform(brick, row, 2);
            image(x, y, 0) = static_cast<float>(tone + 0.2 * static_cast<double>(grain(x, y, 0)));
        }
    return image;
}

TEST(LatticeDetector, seesJointsBetweenBricksOfAnyTone) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const LatticeAnalysis analysis = analyzeLattice(looseBricks({240, 220}, 40, 20, 1.5, seed));
        ASSERT_TRUE(analysis.found()) << seed << ": " << analysis.confidence;
        EXPECT_TRUE(analysis.foundInEdges());
        EXPECT_EQ(analysis.edges.size(), analysis.correlation.size());
        EXPECT_TRUE(analysis.candidates.front().lattice.like({{40, 0}, {20, 20}}, 1.5))
            << analysis.candidates.front().lattice.v1.x << ", " << analysis.candidates.front().lattice.v1.y;
        EXPECT_LE(analysis.candidates.size(), 4U);
    }
}

} // namespace
} // namespace texloom::test

#include "core/analysis/correlation.h"
#include "core/base/error.h"
#include "core/methods/method.h"
#include "core/methods/near_regular/border_match.h"
#include "core/methods/near_regular/layout.h"
#include "core/methods/near_regular/preparation.h"
#include "core/methods/near_regular/sampler.h"
#include "tests/support/lattices.h"
#include "tests/support/method_run.h"
#include "tests/support/says.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace texloom::near_regular {
namespace {

using test::blobs;
using test::coursesTexture;
using test::noise;
using test::planksTexture;
using test::refusalOf;
using test::regularTexture;
using test::requestOf;
using test::resultOf;
using test::says;

TEST(Layout, dividesAWrappingAxisIntoAnEvenNumberOfBlocks) {
    for (const int length : {16, 64, 151, 1000})
        for (const int block : {4, 7, 40}) {
            const Axis axis(length, block, true);
            EXPECT_EQ(axis.count() % 2, 0);
            EXPECT_EQ(axis.start(axis.count()) - axis.start(0), length);
            for (int i = -3; i < axis.count() + 3; ++i) {
                EXPECT_LE(axis.length(i), block);
                EXPECT_EQ(axis.start(i + axis.count()), axis.start(i) + length);
                EXPECT_EQ(axis.at(axis.start(i)), i);
                EXPECT_EQ(axis.at(axis.start(i + 1) - 1), i);
            }
        }
}

TEST(Layout, givesWedgesOfGapsToTheNearestNeighbour) {
    const Layout layout({100, 100}, {}, 10, 4);
    EXPECT_EQ(layout.sampledAt(25, 25), (Cell{2, 2}));
    EXPECT_EQ(layout.sampledAt(11, 5), (Cell{0, 0}));
    EXPECT_EQ(layout.sampledAt(18, 5), (Cell{2, 0}));
    EXPECT_EQ(layout.sampledAt(15, 1), (Cell{1, -1}));
    EXPECT_EQ(layout.sampledAt(15, 8), (Cell{1, 1}));
}

TEST(Layout, namesEveryGapThatAPartTouches) {
    const Layout layout({100, 100}, {true, true}, 10, 4);
    const std::vector<Cell> all = layout.gapsOf({0, 0, {100, 100}});
    EXPECT_EQ(all.size(), 50U);
    EXPECT_EQ(std::set<Cell>(all.begin(), all.end()).size(), 50U);
    for (std::size_t i = 1; i < all.size(); ++i)
        EXPECT_LE(all[i - 1].row & 1, all[i].row & 1);
    EXPECT_LT(layout.gapsOf({30, 30, {5, 5}}).size(), 20U);
}

TEST(Sampler, findsThePatchesAtTheLatticesMultiples) {
    const Layout layout({500, 500}, {}, 20, 6);
    const Lattice lattice{{13.4, 2.2}, {-3.1, 17.7}};
    const Random random(3);
    const Image exemplar = blobs({128, 110}, 1);
    const BorderMatch match(exemplar, {}, layout.patch(), Match::Difference);
    const Sampler sampler({128, 110}, lattice, lattice, {0, 0}, layout, random, match);
    for (const Cell cell : {Cell{0, 0}, Cell{7, 3}, Cell{-2, 20}}) {
        const std::vector<Point> points = sampler.alike(cell);
        std::set<std::pair<int, int>> found;
        for (const Point& p : points)
            found.emplace(p.x, p.y);
        // Every position of the exemplar is one or not, by its distance to the lattice.
        const Vec2 corner{cell.column * 20.0 - 3, cell.row * 20.0 - 3};
        for (int y = 1; y < 110 - 26; ++y)
            for (int x = 1; x < 128 - 26; ++x) {
                const Vec2 away = Vec2{double(x), double(y)} - corner;
                const Vec2 off = away - lattice.nearest(away);
                if (std::max(std::abs(off.x), std::abs(off.y)) < 0.499) {
                    EXPECT_TRUE(found.contains({x, y})) << x << ", " << y;
                } else if (std::max(std::abs(off.x), std::abs(off.y)) > 0.501) {
                    EXPECT_FALSE(found.contains({x, y})) << x << ", " << y;
                }
            }
        const Point drawn = sampler.drawn(cell);
        EXPECT_TRUE(found.contains({drawn.x, drawn.y}));
    }
}

/// Sum of squared differences, or 1 − γ, over a border, by its definition.
double misfit(const ImageView& exemplar, const ImageView& known, const Overlap& border, Point at,
              Match match) {
    const int patch = known.width;
    double differences = 0, above = 0, below = 0;
    for (int c = 0; c < known.channels; ++c) {
        double n = 0, f = 0, g = 0, ff = 0, gg = 0, fg = 0;
        for (int y = 0; y < patch; ++y)
            for (int x = 0; x < patch; ++x)
                if (border.contains(x, y, patch)) {
                    const double a = double(exemplar(at.x + x, at.y + y, c)), b = double(known(x, y, c));
                    differences += (a - b) * (a - b);
                    n += 1;
                    f += a;
                    g += b;
                    ff += a * a;
                    gg += b * b;
                    fg += a * b;
                }
        above += n * fg - f * g;
        below += std::sqrt(n * ff - f * f) * std::sqrt(n * gg - g * g);
    }
    return match == Match::Difference ? differences : 1 - above / below;
}

TEST(BorderMatch, choosesWhatBruteForceFinds) {
    const Image exemplar = blobs({40, 37}, 3);
    const Overlap border{4, 4, 5, 4};
    for (const Match match : {Match::Difference, Match::Correlation}) {
        BorderMatch search(exemplar, {}, 14, match);
        search.prepare(border);
        BorderMatch::Scratch scratch = search.scratch();
        for (std::uint64_t seed = 1; seed < 6; ++seed) {
            const Image known = blobs({14, 14}, 3, seed + 20);
            double least = HUGE_VAL, leastNear = HUGE_VAL;
            for (int y = 0; y <= 37 - 14; ++y)
                for (int x = 0; x <= 40 - 14; ++x) {
                    const double value = misfit(exemplar, known, border, {x, y}, match);
                    least = std::min(least, value);
                    if (std::abs(x - 20) <= 2 && std::abs(y - 22) <= 2)
                        leastNear = std::min(leastNear, value);
                }
            const auto found = [&](const std::vector<Point>& points) {
                return misfit(exemplar, known, border,
                              search.choose(known, border, points, 2, scratch, [] {}), match);
            };
            EXPECT_NEAR(found({}), least, 1e-3 * (1 + least));
            EXPECT_NEAR(found({{20, 22}}), leastNear, 1e-3 * (1 + leastNear));
        }
    }
}

double meanOf(const ImageView& image) {
    return channelMeans(image).front();
}

TEST(Preparation, flatteningTakesTheLightAndLeavesTheTexture) {
    const Lattice lattice{{16, 0}, {0, 12}};
    const Image even = regularTexture({192, 180}, 1, lattice, {}, 5);
    const Image lit = regularTexture({192, 180}, 1, lattice, {0, 0, 3}, 5);
    const Image flat = flattened(lit, 16, [] {});
    const auto slope = [](const Image& image) {
        return meanOf(image.view().crop(128, 120, {48, 48})) - meanOf(image.view().crop(16, 12, {48, 48}));
    };
    EXPECT_GT(slope(lit), 0.3);
    EXPECT_LT(std::abs(slope(flat)), 0.02);
    for (int y = 40; y < 140; y += 7)
        for (int x = 40; x < 150; x += 7)
            EXPECT_NEAR(flat(x, y, 0) - meanOf(flat), even(x, y, 0) - meanOf(even), 0.05);
}

TEST(Preparation, straightensCoursesToWholePixels) {
    const double turn = 0.12;
    const Vec2 along{20.3 * std::cos(turn), 20.3 * std::sin(turn)}, across{-along.y, along.x};
    for (const Lattice& lattice :
         {Lattice{along, 0.7 * across}, Lattice{along, 0.5 * along + 0.6 * across}}) {
        const Image image = regularTexture({200, 190}, 1, lattice, {}, 5);
        const Rectification change = rectification(lattice.reduced(), image.size());
        ASSERT_GT(change.size.shorterSide(), 100);
        for (const double x : {0.0, change.size.width - 1.0})
            for (const double y : {0.0, change.size.height - 1.0}) {
                const Vec2 at = change.from(x, y);
                EXPECT_TRUE(at.x > -1e-6 && at.y > -1e-6 && at.x < 199 + 1e-6 && at.y < 189 + 1e-6);
            }
        EXPECT_TRUE(change.lattice.includes({{20, 0}, {0, 28}}, 0.01) ||
                    change.lattice.includes({{20, 0}, {0, 24}}, 0.01));
        const Image straight = rectified(image, change, [] {});
        // The joints' hard edges lose a little to interpolation.
        EXPECT_GT(autocorrelation(straight).at(20, 0), 0.85);
        EXPECT_LT(autocorrelation(image).at(20, 0), 0.75);
    }
}

Synthesis run(const Image& exemplar, Size size, const Values& settings, Wrap wrap = {}) {
    return resultOf(findMethod("near-regular"), requestOf(exemplar, size, wrap, 1), settings);
}

TEST(NearRegular, continuesAPeriodicExemplarExactly) {
    const Lattice lattice{{16, 2}, {-5, 13}};
    const Image exemplar = regularTexture({128, 120}, 3, lattice, {}, 5),
                whole = regularTexture({260, 230}, 3, lattice, {}, 5);
    for (const char* join : {"cut", "blend"})
        for (const char* match : {"difference", "correlation"}) {
            const Synthesis result =
                run(exemplar, {260, 230}, {{"join", std::string(join)}, {"match", std::string(match)}});
            for (int y = 0; y < 230; y += 3)
                for (int x = 0; x < 260; x += 3)
                    ASSERT_NEAR(result.image(x, y, 2), whole(x, y, 2), 1e-4) << join << " " << x << ", " << y;
        }
}

TEST(NearRegular, keepsTheCoursesFarAwayWithVectorsBetweenPixels) {
    const Lattice lattice{{17.37, 0}, {0, 14.61}};
    const Image exemplar = regularTexture({160, 150}, 1, lattice, {0.05, 0.4, 0}, 5);
    const Synthesis result = run(exemplar, {700, 90}, {});
    // The light of the columns at the right end against that of the ideal texture.
    double best = -1;
    int at = 99;
    const Image ideal = regularTexture({706, 90}, 1, lattice, {}, 5);
    for (int shift = -6; shift <= 6; ++shift) {
        double sum = 0;
        for (int y = 0; y < 90; ++y)
            for (int x = 500; x < 694; ++x)
                sum += (double(result.image(x, y, 0)) - 0.5) * (double(ideal(x + shift, y, 0)) - 0.5);
        if (sum > best) {
            best = sum;
            at = shift;
        }
    }
    EXPECT_LE(std::abs(at), 1);
}

TEST(NearRegular, keepsRowsWhereOnlyRowsRepeat) {
    constexpr int kDistance = 24;
    const Image exemplar = coursesTexture({168, 168}, 1, {1, 0}, kDistance, {.colourChange = 0.5}, 4);
    const Synthesis result = run(exemplar, {220, 600}, {});
    EXPECT_TRUE(result.notes.empty());
    const auto brightness = [](const Image& image, int y) {
        double sum = 0;
        for (int x = 0; x < image.width(); ++x)
            sum += static_cast<double>(image(x, y, 0));
        return sum / image.width();
    };
    const auto found = std::find_if(result.figures.begin(), result.figures.end(), [](const Figure& figure) {
        return figure.name == "Lattice, second vector down";
    });
    ASSERT_NE(found, result.figures.end());
    EXPECT_NEAR(found->value, kDistance, 0.2);
    std::set<double> different;
    for (int course = 0; course < 24; ++course) {
        const auto at = [&](double part) { return static_cast<int>((course + part) * found->value); };
        const double stones = brightness(result.image, at(0.5));
        EXPECT_GT(stones - brightness(result.image, at(0)), 0.1) << course;
        different.insert(stones);
    }
    EXPECT_GT(different.size(), 20U);
}

TEST(NearRegular, keepsTheOrderOfRowsThatDoNotRepeat) {
    const Image exemplar = planksTexture({180, 170}, 1, {0, 1}, 50, 4);
    const Synthesis result = run(exemplar, {500, 260}, {});
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_THAT(result.notes.front(), says("they keep the order"));
    const auto found = std::find_if(result.figures.begin(), result.figures.end(), [](const Figure& figure) {
        return figure.name == "Lattice, first vector right";
    });
    ASSERT_NE(found, result.figures.end());
    const double period = found->value;
    EXPECT_GT(period, 0.4 * exemplar.width());
    constexpr double kTolerance = 4; // of the gaps, and rounding
    for (int x = 0; x < 500; ++x)
        for (int y = 0; y < 260; ++y) {
            const double off = std::remainder(result.map.at(x, y).x - x, period);
            ASSERT_LE(std::abs(off), kTolerance) << x << ", " << y;
        }
}

TEST(NearRegular, blendsAsTheSourceSays) {
    const Image exemplar = noise({64, 64}, 1);
    constexpr int kBlock = 16, kBand = 4;
    const Synthesis result = run(
        exemplar, {80, 80}, {{"lattice", "none"}, {"block", kBlock}, {"join", "blend"}, {"blend", kBand}});
    EXPECT_EQ(result.mapKind, MapKind::Dominant);
    // In its middle a block is a copy, which tells where its patch lies.
    const auto source = [&](int column, int row, int x, int y) {
        const Source& middle = result.map.at(column * kBlock + 8, row * kBlock + 8);
        return double(exemplar(middle.x + x - column * kBlock - 8, middle.y + y - row * kBlock - 8, 0));
    };
    for (int y = 24; y < 56; ++y)
        for (int x = 24; x < 56; ++x) {
            const int column = (x + 2) / kBlock, row = (y + 2) / kBlock; // the later block of a band
            const int inX = x + 2 - column * kBlock, inY = y + 2 - row * kBlock;
            const double ax = inX < kBand ? 1 - (inX + 1) / (kBand + 1.0) : 0,
                         ay = inY < kBand ? 1 - (inY + 1) / (kBand + 1.0) : 0;
            double expected = (1 - ax) * (1 - ay) * source(column, row, x, y);
            if (ax > 0)
                expected += ax * (1 - ay) * source(column - 1, row, x, y);
            if (ay > 0)
                expected += (1 - ax) * ay * source(column, row - 1, x, y);
            if (ax > 0 && ay > 0)
                expected += ax * ay * source(column - 1, row - 1, x, y);
            EXPECT_NEAR(result.image(x, y, 0), expected, 1e-5) << x << ", " << y;
        }
}

TEST(NearRegular, blendsNoWiderThanSmallBlocksBordersAre) {
    // A wider band once took what lies beyond the patches, and at the exemplar's edges beyond its memory.
    Image exemplar = noise({36, 34}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 34; ++y)
            for (int x = 0; x < 36; ++x)
                exemplar(x, y, c) = 2 + exemplar(x, y, c); // as nothing else in memory is
    for (const int band : {3, 9, 64, 256})
        for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
            const Values settings = {
                {"lattice", std::string("none")}, {"join", std::string("blend")}, {"blend", band}};
            const Image image = run(exemplar, {61, 90}, settings, wrap).image;
            for (int c = 0; c < 3; ++c)
                for (int y = 0; y < image.height(); ++y)
                    for (int x = 0; x < image.width(); ++x)
                        ASSERT_NEAR(image(x, y, c), 2.5, 0.5 + 1e-5) << band << " at " << x << ", " << y;
        }
}

TEST(NearRegular, closesOnItselfWithWholePeriods) {
    const Lattice lattice{{16, 0}, {8, 13}};
    const Image exemplar = regularTexture({128, 120}, 1, lattice, {}, 5);
    const Size size{160, 26 * 6};
    const Synthesis result = run(exemplar, size, {}, {true, true});
    EXPECT_TRUE(result.notes.empty());
    const Image whole = regularTexture(size, 1, lattice, {}, 5);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            ASSERT_NEAR(result.image(x, y, 0), whole(x, y, 0), 1e-4);
    EXPECT_THAT(run(exemplar, {168, 150}, {}, {true, true}).notes, testing::Contains(says("16 × 26 px")));
}

TEST(NearRegular, saysWhatItDoesWithoutALattice) {
    EXPECT_THAT(run(blobs({64, 64}, 3), {90, 90}, {}).notes, testing::Contains(says("No lattice")));
    EXPECT_TRUE(run(blobs({64, 64}, 3), {90, 90}, {{"lattice", "none"}}).notes.empty());
}

TEST(NearRegular, evensOutTheLightWherePatchesWouldShow) {
    const Lattice lattice{{16, 0}, {0, 12}};
    const Image lit = regularTexture({192, 180}, 1, lattice, {0, 0, 6}, 5);
    const Image even = regularTexture({192, 180}, 1, lattice, {}, 5);
    EXPECT_GT(unevenness(lit, 16, [] {}), 0.5);
    EXPECT_LT(unevenness(even, 16, [] {}), 0.2);
    EXPECT_EQ(unevenness(texloom::test::constant({64, 64}, 2, 0.3F), 16, [] {}), 0);
    const Synthesis evened = run(lit, {100, 90}, {});
    EXPECT_THAT(evened.notes, testing::Contains(says("evened out")));
    EXPECT_EQ(evened.mapKind, MapKind::Dominant);
    EXPECT_TRUE(samePixels(evened.image, run(lit, {100, 90}, {{"flatten", "yes"}}).image));
    const Synthesis kept = run(lit, {100, 90}, {{"flatten", "no"}});
    EXPECT_TRUE(kept.notes.empty());
    EXPECT_EQ(kept.mapKind, MapKind::Exact);
    EXPECT_TRUE(run(lit, {100, 90}, {{"flatten", "yes"}}).notes.empty());
    EXPECT_TRUE(run(even, {100, 90}, {}).notes.empty());
}

TEST(NearRegular, saysWhereTheTileIsLargerThanTheBlock) {
    const Image exemplar = regularTexture({128, 128}, 1, {{40, 0}, {0, 36}}, {}, 5);
    EXPECT_THAT(
        run(exemplar, {200, 200}, {{"block", 20}}).notes,
        testing::Contains(testing::AllOf(says("blocks of 20 px"), says("Blocks of 40 px hold whole ones"))));
    EXPECT_THAT(run(exemplar, {200, 200}, {{"lattice", "given"}, {"v1-x", 110.0}, {"v2-y", 108.0}}).notes,
                testing::Contains(says("“Regular tile” repeats whole ones")));
}

TEST(NearRegular, movesThePatternByTheOrigin) {
    const Lattice lattice{{16, 0}, {0, 13}};
    const Image exemplar = regularTexture({128, 120}, 1, lattice, {}, 5),
                whole = regularTexture({128, 120}, 1, lattice, {}, 5);
    const Synthesis result = run(exemplar, {100, 100}, {{"origin-x", 5.0}, {"origin-y", 3.0}});
    for (int y = 0; y < 100; y += 7)
        for (int x = 0; x < 100; x += 7)
            EXPECT_NEAR(result.image(x, y, 0), whole(x + 5, y + 3, 0), 1e-4);
}

TEST(NearRegular, saysWhatItsMapIsWorthWhereTheExemplarWasChanged) {
    const Image exemplar = regularTexture({128, 120}, 1, {{16.2, 1.3}, {-1.1, 13}}, {}, 5);
    const Synthesis flat = run(exemplar, {150, 140}, {{"flatten", "yes"}});
    EXPECT_EQ(flat.mapKind, MapKind::Dominant);
    const Synthesis straight = run(exemplar, {150, 140}, {{"rectify", true}});
    EXPECT_EQ(straight.mapKind, MapKind::Estimated);
    // A straightened lattice repeats itself in whole pixels, right along the axes.
    double off = 0;
    for (int y = 0; y < 140; ++y)
        for (int x = 0; x + 16 < 150; ++x)
            off += std::abs(double(straight.image(x, y, 0)) - double(straight.image(x + 16, y, 0)));
    EXPECT_LT(off / (140 * 134), 0.05);
    const Image again = straight.map.apply(exemplar);
    double far = 0;
    for (int y = 0; y < 140; ++y)
        for (int x = 0; x < 150; ++x)
            far += std::abs(double(straight.image(x, y, 0)) - double(again(x, y, 0)));
    EXPECT_LT(far / (140 * 150), 0.05);
}

TEST(NearRegular, refusesBlocksThatDoNotFit) {
    EXPECT_THAT(
        refusalOf(findMethod("near-regular"), requestOf(blobs({64, 64}, 3), {90, 90}), {{"block", 60}}),
        testing::AllOf(testing::HasSubstr("60 px"), testing::HasSubstr("at most")));
    EXPECT_THROW(run(blobs({64, 64}, 3), {90, 10}, {}, {false, true}), UsageError);
}

} // namespace
} // namespace texloom::near_regular

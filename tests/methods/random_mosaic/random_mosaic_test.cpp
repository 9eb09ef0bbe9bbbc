#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/methods/random_mosaic/canvas.h"
#include "core/methods/random_mosaic/layout.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace texloom::test::random_mosaic_tests {
namespace {

using random_mosaic::Canvas;
using random_mosaic::Layout;
using random_mosaic::Pieces;
using random_mosaic::Settings;
using random_mosaic::Tile;
using testing::HasSubstr;

Synthesis made(const Request& request, const Values& settings) {
    return resultOf(findMethod("random-mosaic"), request, settings);
}

Values with(const char* pieces, const char* stitch, int size) {
    return {{"pieces", std::string(pieces)}, {"stitch", std::string(stitch)}, {"size", size}};
}

TEST(RandomMosaic, shufflesPixelsWithoutLosingOne) {
    for (const Size size : {Size{64, 48}, Size{61, 47}})
        for (const char* pieces : {"columns", "rows", "both"})
            for (const bool turn : {false, true}) {
                const Image exemplar = noise(size, 1);
                Values settings = with(pieces, "none", 12);
                settings["turn"] = turn;
                const Synthesis result = made(requestOf(exemplar, size), settings);
                std::vector<int> uses(static_cast<std::size_t>(size.area()), 0);
                for (int y = 0; y < size.height; ++y)
                    for (int x = 0; x < size.width; ++x) {
                        const Source& source = result.map.at(x, y);
                        ++uses[static_cast<std::size_t>(source.y * size.width + source.x)];
                    }
                for (const int use : uses)
                    ASSERT_EQ(use, 1) << pieces << ' ' << size.width;
                EXPECT_TRUE(samePixels(result.map.apply(exemplar), result.image));
                EXPECT_FALSE(samePixels(exemplar, result.image));
            }
}

TEST(RandomMosaic, usesOfPiecesDifferByOneAtMost) {
    Request request = requestOf(blobs({60, 50}, 1), {200, 170});
    request.exemplars.push_back({"another", std::make_shared<const Image>(blobs({44, 70}, 1, 2))});
    Settings settings;
    settings.size = 10;
    for (const Pieces pieces : {Pieces::Columns, Pieces::Rows, Pieces::Both}) {
        settings.pieces = pieces;
        const Layout layout(request, settings, 0, Random(5));
        std::map<std::tuple<int, int, int>, int> uses;
        for (int row = 0; row < layout.rows().count(); ++row)
            for (int column = 0; column < layout.columns().count(); ++column) {
                const Tile& tile = layout.tile(column, row);
                ++uses[{tile.exemplar, tile.x, tile.y}];
            }
        int least = 1 << 30, most = 0;
        for (const auto& [piece, count] : uses) {
            least = std::min(least, count);
            most = std::max(most, count);
        }
        if (static_cast<int>(uses.size()) < layout.pieces())
            least = 0;
        EXPECT_LE(most - least, 1);
    }
}

TEST(RandomMosaic, neighboursInTheExemplarAreParted) {
    const Request request = requestOf(noise({128, 128}, 1), {128, 128});
    Settings settings;
    settings.size = 8;
    int together = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Layout layout(request, settings, 0, Random(seed));
        for (int row = 0; row < 16; ++row)
            for (int column = 1; column < 16; ++column)
                together += layout.tile(column, row).y == layout.tile(column - 1, row).y &&
                            layout.tile(column, row).x == layout.tile(column - 1, row).x + 8;
    }
    EXPECT_LE(together, 1); // by chance there would be about nine
}

TEST(RandomMosaic, piecesInTheirPlacesNeedNoLevelling) {
    const Image exemplar = blobs({70, 53}, 2);
    const Request request = requestOf(exemplar, {70, 53});
    Settings settings;
    settings.size = 9;
    const Layout layout = Layout::identity(request, settings);
    for (const double reach : {0.0, 9.0}) {
        Job<Image> job({0, 2, false}, [&](JobContext& context) {
            Canvas canvas({70, 53}, request, true);
            for (int row = 0; row < layout.rows().count(); ++row)
                for (int column = 0; column < layout.columns().count(); ++column)
                    for (int y = 0; y < layout.rows().length(row); ++y)
                        for (int x = 0; x < layout.columns().length(column); ++x) {
                            const Source source = layout.source(column, row, x, y);
                            const int u = layout.columns().start(column) + x;
                            const int v = layout.rows().start(row) + y;
                            canvas.map.at(u, v) = source;
                            for (int c = 0; c < 2; ++c)
                                canvas.image(u, v, c) = exemplar(source.x, source.y, c);
                        }
            levelJoints(canvas, request, reach, 1, context);
            return std::move(canvas.image);
        });
        const Image image = std::get<Image>(job.take());
        for (int c = 0; c < 2; ++c)
            for (int y = 0; y < 53; ++y)
                for (int x = 0; x < 70; ++x)
                    ASSERT_NEAR(image(x, y, c), exemplar(x, y, c), 1e-4);
    }
}

/// What pixel b, beside a in the direction (dx, dy) on a torus, should lie above a: the mean of both pieces'
/// own next differences where the exemplar has them.
double wantedStep(const Image& exemplar, const PositionMap& map, int ax, int ay, int dx, int dy) {
    const Source &a = map.at(ax, ay), &b = map.at((ax + dx) % map.width(), (ay + dy) % map.height());
    double sum = 0;
    int count = 0;
    if (a.x + dx < exemplar.width() && a.y + dy < exemplar.height()) {
        sum += static_cast<double>(exemplar(a.x + dx, a.y + dy, 0) - exemplar(a.x, a.y, 0));
        ++count;
    }
    if (b.x - dx >= 0 && b.y - dy >= 0) {
        sum += static_cast<double>(exemplar(b.x, b.y, 0) - exemplar(b.x - dx, b.y - dy, 0));
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

TEST(RandomMosaic, levellingSolvesItsEquationAndKeepsTheMean) {
    const Image exemplar = blobs({96, 80}, 1);
    const Request request = requestOf(exemplar, {96, 80});
    const Synthesis raw = made(request, with("both", "none", 16));
    for (const double reach : {0.0, 1.0, 3.0}) {
        Values settings = with("both", "poisson", 16);
        settings["reach"] = reach;
        const Synthesis level = made(request, settings);
        EXPECT_EQ(raw.map, level.map);
        EXPECT_NEAR(channelMeans(level.image).front(), channelMeans(exemplar).front(), 1e-5);
        const double lift = channelMeans(level.image).front() - channelMeans(raw.image).front();
        const double screen = reach > 0 ? 1 / (16 * 16 * reach * reach) : 0;
        // f = what was added; of each step, what f lacks.
        const auto f = [&](int x, int y) {
            return static_cast<double>(level.image(x, y, 0) - raw.image(x, y, 0)) - lift;
        };
        const auto lacks = [&](int x, int y, int dx, int dy) {
            if (x < 0 || y < 0 || x + dx >= 96 || y + dy >= 80)
                return 0.0;
            const double step = static_cast<double>(raw.image(x + dx, y + dy, 0) - raw.image(x, y, 0));
            return f(x + dx, y + dy) - f(x, y) - (wantedStep(exemplar, raw.map, x, y, dx, dy) - step);
        };
        for (int y = 0; y < 80; ++y)
            for (int x = 0; x < 96; ++x)
                ASSERT_NEAR(lacks(x, y, 1, 0) - lacks(x - 1, y, 1, 0) + lacks(x, y, 0, 1) -
                                lacks(x, y - 1, 0, 1) - screen * f(x, y),
                            0, 1e-5)
                    << reach << " at " << x << ", " << y;
    }
}

TEST(RandomMosaic, whatWrapsIsLevelledOnATorus) {
    // Each step, over the border too, has its wanted height plus what the solution lacks, whose divergence is
    // nil.
    const Image exemplar = blobs({96, 80}, 1);
    const Request request = requestOf(exemplar, {96, 80}, {true, true});
    const Synthesis raw = made(request, with("both", "none", 16));
    Values settings = with("both", "poisson", 16);
    settings["reach"] = 0.0;
    const Synthesis level = made(request, settings);
    EXPECT_EQ(raw.map, level.map);
    const auto lacks = [&](int x, int y, int dx, int dy) {
        return static_cast<double>(level.image((x + dx) % 96, (y + dy) % 80, 0) - level.image(x, y, 0)) -
               wantedStep(exemplar, raw.map, x, y, dx, dy);
    };
    double border = 0;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 96; ++x) {
            const double divergence = lacks(x, y, 1, 0) - lacks((x + 95) % 96, y, 1, 0) + lacks(x, y, 0, 1) -
                                      lacks(x, (y + 79) % 80, 0, 1);
            ASSERT_NEAR(divergence, 0, 1e-5) << x << ", " << y;
            border = std::max(border, x == 95 ? std::abs(lacks(x, y, 1, 0)) : 0);
        }
    EXPECT_GT(border, 1e-4); // what levels joints goes on over the border
}

/// Mean squared step across joints: left to right, where the exemplar does not go on.
double squaredJump(const Synthesis& result) {
    double sum = 0, count = 0;
    for (int c = 0; c < result.image.channels(); ++c)
        for (int y = 0; y < result.image.height(); ++y)
            for (int x = 0; x + 1 < result.image.width(); ++x)
                if (const Source& a = result.map.at(x, y), &b = result.map.at(x + 1, y);
                    a.x + 1 != b.x || a.y != b.y) {
                    const double jump =
                        static_cast<double>(result.image(x + 1, y, c) - result.image(x, y, c));
                    sum += jump * jump;
                    ++count;
                }
    return sum / count;
}

TEST(RandomMosaic, levellingHidesJoints) {
    const Request request = requestOf(blobs({96, 80}, 1), {96, 80});
    EXPECT_LT(squaredJump(made(request, with("both", "poisson", 16))),
              0.1 * squaredJump(made(request, with("both", "none", 16))));
}

TEST(RandomMosaic, levelsDoNotDriftFromPieceToPiece) {
    // Every slice rises by half of the range; levelled without limit, sixty of them would climb on and on.
    Image exemplar({64, 32}, 1);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            exemplar(x, y, 0) = 0.5F * static_cast<float>(x % 16) / 16 + (x / 16 % 2 == 0 ? 0.5F : 0);
    const Request request = requestOf(exemplar, {960, 32});
    Values settings = with("columns", "poisson", 16);
    const ValueRange held = valueRange(made(request, settings).image);
    EXPECT_LT(held.largest - held.smallest, 2.0F);
    settings["reach"] = 0.0;
    const ValueRange free = valueRange(made(request, settings).image);
    EXPECT_GT(free.largest - free.smallest, 5.0F);
}

TEST(RandomMosaic, cutsOfAPeriodicExemplarLeaveNoTrace) {
    const Image exemplar = periodic({64, 64}, {8, 8}, 1);
    for (const char* stitch : {"cut", "feather"})
        for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
            const Image image = made(requestOf(exemplar, {128, 64}, wrap), with("both", stitch, 16)).image;
            // Pieces at the exemplar's border go on mirrored, where cuts need not find a match: most must.
            int alike = 0;
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 128; ++x)
                    alike += std::abs(image(x, y, 0) - image((x + 8) % 128, y, 0)) < 1e-6F ? 1 : 0;
            EXPECT_GT(alike, 128 * 64 * (stitch == std::string("cut") ? 9 : 6) / 10) << stitch;
        }
}

TEST(RandomMosaic, cutsMakeJointsLessVisible) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Request request = requestOf(blobs({96, 96}, 3), {96, 96}, {}, seed);
        EXPECT_LT(squaredJump(made(request, with("both", "cut", 16))),
                  0.75 * squaredJump(made(request, with("both", "none", 16))));
    }
}

TEST(RandomMosaic, chaosCoversTheOutputWithBlocks) {
    for (const char* stitch : {"none", "cut", "feather", "poisson"}) {
        const Image exemplar = blobs({64, 64}, 3);
        const Synthesis result =
            made(requestOf(exemplar, {150, 130}, {true, false}), with("chaos", stitch, 16));
        if (result.mapKind == MapKind::Exact) {
            EXPECT_TRUE(samePixels(result.map.apply(exemplar), result.image));
        }
        // Nine copies of the exemplar lie below, and in each of their cells eight blocks on it.
        std::set<std::pair<int, int>> ways;
        for (int y = 0; y < 130; ++y)
            for (int x = 0; x < 150; ++x)
                ways.insert({result.map.at(x, y).x - x, result.map.at(x, y).y - y});
        EXPECT_GT(ways.size(), 40U) << stitch;
        EXPECT_EQ(result.figures.front().value, 9 + 9 * 8);
    }
}

TEST(RandomMosaic, onePieceIsTheExemplarAndSaysSo) {
    const Image exemplar = blobs({20, 20}, 1);
    const Synthesis result = made(requestOf(exemplar, {20, 20}), with("both", "poisson", 16));
    EXPECT_TRUE(samePixels(result.image, exemplar));
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_THAT(result.notes.front().text(), HasSubstr("10 px"));
}

TEST(RandomMosaic, piecesLargerThanTheExemplarAreRefused) {
    EXPECT_THAT(refusalOf(findMethod("random-mosaic"), requestOf(blobs({40, 30}, 1), {40, 30}),
                          with("both", "none", 31)),
                testing::AllOf(HasSubstr("31 px"), HasSubstr("at most 30 px")));
    EXPECT_NO_THROW(made(requestOf(blobs({40, 30}, 1), {40, 30}), with("columns", "none", 31)));
}

} // namespace
} // namespace texloom::test::random_mosaic_tests

#include "core/base/error.h"
#include "core/io/model_file.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/methods/wang_tiles/tiling.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <tuple>

namespace texloom::test {
namespace {

using testing::HasSubstr;
using wang_tiles::Edges;
using wang_tiles::edgesOf;
using wang_tiles::Settings;
using wang_tiles::sheetPlace;
using wang_tiles::TileSet;
using wang_tiles::Tiling;

Synthesis made(const Request& request, const Values& settings = {}) {
    return resultOf(findMethod("wang-tiles"), request, settings);
}

/// A set of tiles with samples at made-up places.
TileSet setOf(const Request& request, const Settings& settings, Size size) {
    TileSet::Samples samples;
    for (int colour = 0; colour < settings.colours; ++colour) {
        samples.across.push_back({0, 3 + 7 * colour, 11 - 2 * colour});
        samples.upright.push_back({0, 20 - 5 * colour, 4 + 3 * colour});
    }
    Job<std::shared_ptr<const TileSet>> job({0, 2, false}, [&](JobContext& context) {
        return std::make_shared<const TileSet>(request, settings, samples, size, edgesOf(settings), context);
    });
    return *std::get<std::shared_ptr<const TileSet>>(job.take());
}

TEST(WangTiles, edgesOfOneColourAreTheSameBits) {
    const Request request = requestOf(noise({64, 64}, 1), {64, 64});
    Settings settings;
    settings.tile = 20;
    settings.colours = 3;
    for (const Size size : {Size{20, 20}, Size{20, 16}, Size{13, 20}, Size{3, 4}}) {
        const TileSet tiles = setOf(request, settings, size);
        for (const Edges& a : edgesOf(settings))
            for (const Edges& b : edgesOf(settings)) {
                const int right = size.width - 1, bottom = size.height - 1;
                // The upper corners are of the sample above, the lower ones of those beside.
                for (int x = 0; x < size.width; ++x) {
                    if (a.north == b.north) {
                        ASSERT_EQ(tiles.source(a, x, 0), tiles.source(b, x, 0));
                    }
                    if (a.south == b.south && x > 0 && x < right) {
                        ASSERT_EQ(tiles.source(a, x, bottom), tiles.source(b, x, bottom));
                    }
                    // What meets at an edge lies side by side in the exemplar.
                    if (a.south == b.north && x > 0 && x < right) {
                        ASSERT_EQ(tiles.source(a, x, bottom).x, tiles.source(b, x, 0).x);
                        ASSERT_EQ(tiles.source(a, x, bottom).y + 1, tiles.source(b, x, 0).y);
                    }
                }
                for (int y = 1; y < size.height; ++y) {
                    if (a.west == b.west) {
                        ASSERT_EQ(tiles.source(a, 0, y), tiles.source(b, 0, y));
                    }
                    if (a.east == b.east) {
                        ASSERT_EQ(tiles.source(a, right, y), tiles.source(b, right, y));
                    }
                    if (a.east == b.west) {
                        ASSERT_EQ(tiles.source(a, right, y).x + 1, tiles.source(b, 0, y).x);
                        ASSERT_EQ(tiles.source(a, right, y).y, tiles.source(b, 0, y).y);
                    }
                }
            }
    }
}

TEST(WangTiles, samplesAreTakenFromWithinTheirSquares) {
    Settings settings;
    settings.tile = 21;
    for (const double overlap : {0.02, 0.25, 0.5}) {
        settings.overlap = overlap;
        const int side = wang_tiles::sampleSide(settings);
        const Request request = requestOf(noise({side, side}, 1), {64, 64});
        TileSet::Samples samples{{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
        for (const Size size : {Size{21, 21}, Size{21, 15}, Size{9, 21}}) {
            Job<int> job({0, 1, false}, [&](JobContext& context) {
                const TileSet tiles(request, settings, samples, size, edgesOf(settings), context);
                int outside = 0;
                for (const Edges& edges : edgesOf(settings))
                    for (int y = 0; y < size.height; ++y)
                        for (int x = 0; x < size.width; ++x)
                            outside +=
                                tiles.source(edges, x, y).x >= side || tiles.source(edges, x, y).y >= side;
                return outside;
            });
            EXPECT_EQ(std::get<int>(job.take()), 0) << overlap;
        }
    }
}

TEST(WangTiles, sheetIsATourOfAllColours) {
    for (int k = 2; k <= 4; ++k) {
        std::vector<std::pair<int, int>> row(static_cast<std::size_t>(k * k), {-1, -1});
        for (int a = 0; a < k; ++a)
            for (int b = 0; b < k; ++b)
                row[static_cast<std::size_t>(sheetPlace(a, b))] = {a, b};
        for (std::size_t i = 0; i < row.size(); ++i) {
            EXPECT_GE(row[i].first, 0);
            EXPECT_EQ(row[i].second, row[(i + 1) % row.size()].first);
        }
    }
}

TEST(WangTiles, compactSetsHaveTwoTilesForEachPair) {
    Settings settings;
    settings.set = wang_tiles::Set::Compact;
    for (int k = 2; k <= 4; ++k) {
        settings.colours = k;
        const std::vector<Edges> edges = edgesOf(settings);
        EXPECT_EQ(static_cast<int>(edges.size()), 2 * k * k);
        std::set<std::tuple<int, int, int, int>> all;
        std::multiset<std::pair<int, int>> pairs;
        for (const Edges& tile : edges) {
            all.insert({tile.north, tile.east, tile.south, tile.west});
            pairs.insert({tile.north, tile.west});
        }
        EXPECT_EQ(all.size(), edges.size());
        for (int north = 0; north < k; ++north)
            for (int west = 0; west < k; ++west)
                EXPECT_EQ(pairs.count({north, west}), 2U);
    }
}

TEST(WangTiles, neighboursMatchInEveryTiling) {
    for (const bool compact : {false, true})
        for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
            if (compact && wrap.x)
                continue;
            Settings settings;
            settings.tile = 16;
            settings.colours = 3;
            settings.set = compact ? wang_tiles::Set::Compact : wang_tiles::Set::Full;
            const Request request = requestOf(noise({64, 64}, 1), {151, 133}, wrap);
            const Tiling tiling(request, settings, Random(5));
            const std::vector<Edges> known = edgesOf(settings);
            const int columns = (151 + 15) / 16, rows = (133 + 15) / 16;
            std::set<std::tuple<int, int, int, int>> used;
            for (int row = 0; row < rows; ++row)
                for (int column = 0; column < columns; ++column) {
                    const Edges one = tiling.edges(column, row);
                    EXPECT_NE(std::find(known.begin(), known.end(), one), known.end());
                    used.insert({one.north, one.east, one.south, one.west});
                    if (column + 1 < columns || wrap.x) {
                        EXPECT_EQ(one.east, tiling.edges((column + 1) % columns, row).west);
                    }
                    if (row + 1 < rows || wrap.y) {
                        EXPECT_EQ(one.south, tiling.edges(column, (row + 1) % rows).north);
                    }
                }
            EXPECT_GT(used.size(), compact ? 12U : 40U);
        }
}

TEST(WangTiles, cellsThatWrapFillTheOutput) {
    for (const int length : {1, 5, 64, 151, 200}) {
        const std::vector<int> all = Tiling::lengths(length, 32, true);
        int sum = 0;
        for (const int one : all) {
            EXPECT_LE(one, 32);
            sum += one;
        }
        EXPECT_EQ(sum, length);
        EXPECT_LE(all.front() - all.back(), 1);
    }
}

TEST(WangTiles, smallerThresholdsSearchLongerAndJoinBetter) {
    const Request request = requestOf(blobs({96, 96}, 3), {100, 100});
    const auto figure = [](const Synthesis& result, std::size_t i) { return result.figures[i].value; };
    const Synthesis quick = made(request, {{"threshold", 2.0}, {"tile", 32}});
    const Synthesis long_ = made(request, {{"threshold", 0.0}, {"tile", 32}, {"tries", 12}});
    EXPECT_EQ(figure(quick, 1), 1);
    EXPECT_EQ(figure(long_, 1), 12);
    EXPECT_LE(figure(long_, 2), figure(quick, 2));
    EXPECT_EQ(long_.notes.size(), 1U);
}

TEST(WangTiles, pictureOfTheSetHoldsAllTiles) {
    const Synthesis full = made(requestOf(blobs({96, 96}, 3), {64, 64}), {{"tile", 20}, {"colours", 3}});
    EXPECT_EQ(full.outputs.image("tile-sheet")->size(), (Size{180, 180}));
    const Synthesis compact = made(requestOf(blobs({96, 96}, 3), {64, 64}),
                                   {{"tile", 20}, {"colours", 3}, {"set", std::string("compact")}});
    EXPECT_EQ(compact.outputs.image("tile-sheet")->size(), (Size{120, 60}));
}

TEST(WangTiles, theSetIsGivenAsSheetTilesMapAndTable) {
    for (const char* set : {"full", "compact"}) {
        const Request request = requestOf(blobs({96, 96}, 3), {64, 64});
        const Synthesis result = made(request, {{"tile", 20}, {"colours", 3}, {"set", std::string(set)}});
        const Image& sheet = *result.outputs.image("tile-sheet");
        const auto map = result.outputs.first<PositionMap>("tile-sheet-map");
        EXPECT_TRUE(samePixels(map->apply(*request.exemplars.front().image), sheet));
        const auto table = result.outputs.first<Model>("tile-table");
        const std::vector<Asset>& tiles = result.outputs.at("tile");
        const auto count = static_cast<std::int64_t>(tiles.size());
        ASSERT_EQ(count, std::string(set) == "full" ? 81 : 18);
        const auto& edges = table->values<std::int64_t>("edges", {count, 4});
        const auto& places = table->values<std::int64_t>("places", {count, 2});
        const auto& numbers = table->values<std::int64_t>("numbers", {3, 3, 3, 3});
        const auto tile = [&](std::int64_t i) -> const Image& {
            return *std::get<std::shared_ptr<const Image>>(tiles[static_cast<std::size_t>(i)]);
        };
        const auto edge = [&](std::int64_t i, int side) {
            return edges[static_cast<std::size_t>(4 * i + side)];
        };
        EXPECT_EQ(std::count(numbers.begin(), numbers.end(), -1), 81 - count);
        for (std::int64_t i = 0; i < count; ++i) {
            EXPECT_EQ(numbers[static_cast<std::size_t>(((edge(i, 0) * 3 + edge(i, 1)) * 3 + edge(i, 2)) * 3 +
                                                       edge(i, 3))],
                      i);
            const auto x = static_cast<int>(places[static_cast<std::size_t>(2 * i)]);
            const auto y = static_cast<int>(places[static_cast<std::size_t>(2 * i + 1)]);
            EXPECT_TRUE(samePixels(tile(i), Image(sheet.view().crop(x, y, {20, 20}))));
            // What lies at an edge of one colour is the same in every tile: equal colours are equal bits.
            for (std::int64_t k = 0; k < i; ++k) {
                if (edge(i, 0) == edge(k, 0)) {
                    EXPECT_EQ(tile(i)(10, 0, 1), tile(k)(10, 0, 1));
                }
                if (edge(i, 3) == edge(k, 3)) {
                    EXPECT_EQ(tile(i)(0, 10, 2), tile(k)(0, 10, 2));
                }
            }
        }
    }
}

TEST(WangTiles, tilesThatAreTooLargeAreRefused) {
    EXPECT_THAT(refusalOf(findMethod("wang-tiles"), requestOf(blobs({40, 40}, 1), {40, 40}), {{"tile", 36}}),
                testing::AllOf(HasSubstr("36 px"), HasSubstr("40 × 40 px")));
    EXPECT_THROW(made(requestOf(blobs({64, 64}, 1), {64, 64}, {true, false}),
                      {{"set", std::string("compact")}, {"tile", 20}}),
                 UsageError);
}

} // namespace
} // namespace texloom::test

#include "core/base/error.h"
#include "core/io/model_file.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/methods/wang_tiles/edge_tiles.h"
#include "core/methods/wang_tiles/interiors.h"
#include "core/methods/wang_tiles/tiling.h"
#include "tests/support/method_run.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace texloom::test::wang_tiles_tests {
namespace {

using testing::HasSubstr;
using wang_tiles::Colours;
using wang_tiles::coloursOf;
using wang_tiles::CornerTiles;
using wang_tiles::EdgeTiles;
using wang_tiles::Interiors;
using wang_tiles::Match;
using wang_tiles::Samples;
using wang_tiles::Settings;
using wang_tiles::sheetPlace;
using wang_tiles::TileSet;
using wang_tiles::Tiling;

Synthesis made(const Request& request, const Values& settings = {}) {
    return resultOf(findMethod("wang-tiles"), request, settings);
}

/// Samples at made-up places.
Samples madeUp(const Settings& settings) {
    Samples samples;
    for (int i = 0; i < wang_tiles::sampleCount(settings); ++i)
        samples.push_back({0, 3 + 5 * i, i % 2 == 0 ? 11 - 2 * i : 4 + 3 * i});
    return samples;
}

/// A set of tiles with such samples; of corners, with fresh texture inside.
TileSet setOf(const Request& request, const Settings& settings, Size size) {
    Job<std::shared_ptr<const TileSet>> job({0, 2, false}, [&](JobContext& context) {
        const std::vector<Colours> tiles = coloursOf(settings);
        if (settings.match == Match::Corners) {
            Interiors interiors(request, settings, context);
            const Size whole{settings.tile, settings.tile};
            interiors.find({request, settings, madeUp(settings), whole, context}, tiles);
            return std::make_shared<const TileSet>(
                interiors.cover({request, settings, madeUp(settings), size, context}, tiles));
        }
        const EdgeTiles cuts(request, settings, madeUp(settings), size, tiles, context);
        TileSet set(settings.colours, size);
        for (const Colours& tile : tiles) {
            std::vector<Source> sources;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    sources.push_back(cuts.source(tile, x, y));
            set.add(tile, std::move(sources));
        }
        return std::make_shared<const TileSet>(std::move(set));
    });
    return *std::get<std::shared_ptr<const TileSet>>(job.take());
}

bool adjoin(const Source& a, const Source& b, int dx, int dy) {
    return a.exemplar == b.exemplar && a.x + dx == b.x && a.y + dy == b.y;
}

TEST(WangTiles, cornersThatMatchMakeEdgesOfTheSameBits) {
    const Request request = requestOf(noise({64, 64}, 1), {64, 64});
    Settings settings;
    settings.tile = 20;
    settings.colours = 3;
    for (const Size size : {Size{20, 20}, Size{20, 16}, Size{13, 20}, Size{3, 4}, Size{2, 5}}) {
        const TileSet tiles = setOf(request, settings, size);
        const int right = size.width - 1, bottom = size.height - 1;
        for (const Colours& a : coloursOf(settings))
            for (const Colours& b : coloursOf(settings)) {
                // Colours are those of corners: upper left, upper right, lower right, lower left.
                for (int x = 0; x < size.width; ++x) {
                    if (a.north == b.north && a.east == b.east) {
                        ASSERT_EQ(tiles.source(a, x, 0), tiles.source(b, x, 0));
                    }
                    if (a.west == b.west && a.south == b.south) {
                        ASSERT_EQ(tiles.source(a, x, bottom), tiles.source(b, x, bottom));
                    }
                    // What meets at an edge lies side by side in the exemplar, but where the edge's cut
                    // crosses.
                    if (a.west == b.north && a.south == b.east &&
                        4 * std::abs(2 * x - right) > size.width + 4) {
                        ASSERT_TRUE(adjoin(tiles.source(a, x, bottom), tiles.source(b, x, 0), 0, 1));
                    }
                }
                for (int y = 0; y < size.height; ++y) {
                    if (a.north == b.north && a.west == b.west) {
                        ASSERT_EQ(tiles.source(a, 0, y), tiles.source(b, 0, y));
                    }
                    if (a.east == b.east && a.south == b.south) {
                        ASSERT_EQ(tiles.source(a, right, y), tiles.source(b, right, y));
                    }
                    if (a.east == b.north && a.south == b.west &&
                        4 * std::abs(2 * y - bottom) > size.height + 4) {
                        ASSERT_TRUE(adjoin(tiles.source(a, right, y), tiles.source(b, 0, y), 1, 0));
                    }
                }
            }
    }
}

TEST(WangTiles, insideOfEveryTileIsAPatchOfItsOwn) {
    const Request request = requestOf(noise({90, 90}, 1), {64, 64});
    Settings settings;
    settings.tile = 24;
    const int begin = wang_tiles::depthOf(settings), end = 24 - begin;
    const TileSet tiles = setOf(request, settings, {24, 24});
    std::set<std::pair<int, int>> places;
    for (const Colours& tile : coloursOf(settings)) {
        const Source first = tiles.source(tile, begin, begin);
        for (int y = begin; y < end; ++y)
            for (int x = begin; x < end; ++x)
                ASSERT_TRUE(adjoin(first, tiles.source(tile, x, y), x - begin, y - begin));
        places.insert({first.x, first.y});
    }
    EXPECT_EQ(places.size(), 16U);
    for (const auto& one : places)
        for (const auto& two : places)
            if (one != two) {
                EXPECT_GT(std::max(std::abs(one.first - two.first), std::abs(one.second - two.second)), 3);
            }
}

TEST(WangTiles, edgesOfOneColourAreTheSameBits) {
    const Request request = requestOf(noise({64, 64}, 1), {64, 64});
    Settings settings;
    settings.match = Match::Edges;
    settings.tile = 20;
    settings.colours = 3;
    for (const Size size : {Size{20, 20}, Size{20, 16}, Size{13, 20}, Size{3, 4}}) {
        const TileSet tiles = setOf(request, settings, size);
        for (const Colours& a : coloursOf(settings))
            for (const Colours& b : coloursOf(settings)) {
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
        const Samples samples(4, {0, 0, 0});
        for (const Size size : {Size{21, 21}, Size{21, 15}, Size{9, 21}}) {
            Job<int> job({0, 1, false}, [&](JobContext& context) {
                const EdgeTiles edges(request, settings, samples, size, coloursOf(settings), context);
                const CornerTiles corners(request, settings, samples, size, context);
                int outside = 0;
                for (const Colours& tile : coloursOf(settings))
                    for (int y = 0; y < size.height; ++y)
                        for (int x = 0; x < size.width; ++x)
                            for (const Source& source :
                                 {edges.source(tile, x, y), corners.source(tile, x, y)})
                                outside += source.x >= side || source.y >= side;
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

TEST(WangTiles, tilesOfAFullSetMatchOnTheSheet) {
    for (const Match match : {Match::Corners, Match::Edges})
        for (int k = 2; k <= 4; ++k) {
            Settings settings;
            settings.match = match;
            settings.colours = k;
            const std::vector<Colours> all = coloursOf(settings);
            const int side = wang_tiles::tilesInRow(settings);
            ASSERT_EQ(all.size(), static_cast<std::size_t>(side * side));
            std::set<std::tuple<int, int, int, int>> different;
            for (int row = 0; row < side; ++row)
                for (int column = 0; column < side; ++column) {
                    const auto tile = [&](int x, int y) {
                        return all[static_cast<std::size_t>(y % side * side + x % side)];
                    };
                    const Colours one = tile(column, row), below = tile(column, row + 1),
                                  beside = tile(column + 1, row);
                    different.insert({one.north, one.east, one.south, one.west});
                    if (match == Match::Edges) {
                        EXPECT_EQ(one.east, beside.west);
                        EXPECT_EQ(one.south, below.north);
                        continue;
                    }
                    EXPECT_EQ(one.west, below.north);
                    EXPECT_EQ(one.south, below.east);
                    if (column + 1 < side) {
                        EXPECT_EQ(one.east, beside.north);
                        EXPECT_EQ(one.south, beside.west);
                    }
                }
            EXPECT_EQ(different.size(), all.size());
        }
}

TEST(WangTiles, compactSetsHaveTwoTilesForWhateverIsAboveAndToTheLeft) {
    for (const Match match : {Match::Corners, Match::Edges})
        for (int k = 2; k <= 4; ++k) {
            Settings settings;
            settings.match = match;
            settings.set = wang_tiles::Set::Compact;
            settings.colours = k;
            const bool corners = match == Match::Corners;
            const std::vector<Colours> tiles = coloursOf(settings);
            EXPECT_EQ(static_cast<int>(tiles.size()), 2 * k * k * (corners ? k : 1));
            std::set<std::tuple<int, int, int, int>> all;
            std::map<std::tuple<int, int, int>, int> begun;
            for (const Colours& tile : tiles) {
                all.insert({tile.north, tile.east, tile.south, tile.west});
                ++begun[{tile.north, corners ? tile.east : 0, tile.west}];
            }
            EXPECT_EQ(all.size(), tiles.size());
            EXPECT_EQ(begun.size(), tiles.size() / 2);
            for (const auto& [three, count] : begun)
                EXPECT_EQ(count, 2);
        }
}

/// Whether a tile matches the one to the right of it, or, if it lies `below`, that one.
bool matches(Match match, const Colours& one, const Colours& other, bool below) {
    if (match == Match::Edges)
        return below ? one.south == other.north : one.east == other.west;
    return below ? one.west == other.north && one.south == other.east
                 : one.east == other.north && one.south == other.west;
}

TEST(WangTiles, neighboursMatchInEveryTiling) {
    for (const Match match : {Match::Corners, Match::Edges})
        for (const bool compact : {false, true})
            for (const Wrap wrap : {Wrap{}, Wrap{true, true}}) {
                if (compact && wrap.x)
                    continue;
                Settings settings;
                settings.match = match;
                settings.tile = 16;
                settings.colours = 3;
                settings.set = compact ? wang_tiles::Set::Compact : wang_tiles::Set::Full;
                const Request request = requestOf(noise({64, 64}, 1), {151, 133}, wrap);
                const Tiling tiling(request, settings, Random(5));
                const std::vector<Colours> known = coloursOf(settings);
                const int columns = (151 + 15) / 16, rows = (133 + 15) / 16;
                std::set<std::tuple<int, int, int, int>> used;
                for (int row = 0; row < rows; ++row)
                    for (int column = 0; column < columns; ++column) {
                        const Colours one = tiling.colours(column, row);
                        EXPECT_NE(std::find(known.begin(), known.end(), one), known.end());
                        used.insert({one.north, one.east, one.south, one.west});
                        if (column + 1 < columns || wrap.x) {
                            EXPECT_TRUE(
                                matches(match, one, tiling.colours((column + 1) % columns, row), false));
                        }
                        if (row + 1 < rows || wrap.y) {
                            EXPECT_TRUE(matches(match, one, tiling.colours(column, (row + 1) % rows), true));
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
    const std::string match = "edges";
    const Synthesis quick = made(request, {{"match", match}, {"threshold", 2.0}, {"tile", 32}});
    const Synthesis long_ =
        made(request, {{"match", match}, {"threshold", 0.0}, {"tile", 32}, {"tries", 12}});
    EXPECT_EQ(figure(quick, 1), 1);
    EXPECT_EQ(figure(long_, 1), 12);
    EXPECT_LE(figure(long_, 2), figure(quick, 2));
    EXPECT_EQ(long_.notes.size(), 1U);
}

/// The marks are no farther from the mean than the noise, so that places with them are as lively as others.
TEST(WangTiles, cornersAreTakenFromPlacesWithoutMarks) {
    Image exemplar = noise({160, 160}, 1);
    const std::vector<std::pair<int, int>> marks = {{40, 50},  {110, 30}, {75, 120}, {140, 130},
                                                    {20, 100}, {70, 70},  {120, 85}, {45, 145}};
    const auto marked = [&](int x, int y) {
        return std::any_of(marks.begin(), marks.end(), [&](const std::pair<int, int>& mark) {
            return std::hypot(mark.first - x, mark.second - y) < 5;
        });
    };
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x)
            exemplar(x, y, 0) = marked(x, y) ? 0.7F : 0.3F + 0.4F * exemplar(x, y, 0);
    constexpr int kTile = 24;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Request request = requestOf(exemplar, {6 * kTile, 6 * kTile});
        request.seed = seed;
        const Synthesis result = made(request, {{"tile", kTile}, {"threshold", 2.0}});
        for (int y = 0; y < 6 * kTile; ++y)
            for (int x = 0; x < 6 * kTile; ++x)
                if (const Source& source = result.map.at(x, y); x % kTile == 0 || y % kTile == 0) {
                    ASSERT_FALSE(marked(source.x, source.y)) << seed << ": " << x << ", " << y;
                }
    }
}

TEST(WangTiles, pictureOfTheSetHoldsAllTiles) {
    const Synthesis full = made(requestOf(blobs({96, 96}, 3), {64, 64}), {{"tile", 20}, {"colours", 3}});
    EXPECT_EQ(full.outputs.image("tile-sheet")->size(), (Size{180, 180}));
    const Synthesis compact = made(requestOf(blobs({96, 96}, 3), {64, 64}),
                                   {{"tile", 20}, {"colours", 3}, {"set", std::string("compact")}});
    EXPECT_EQ(compact.outputs.image("tile-sheet")->size(), (Size{120, 180}));
    const Synthesis edges = made(
        requestOf(blobs({96, 96}, 3), {64, 64}),
        {{"tile", 20}, {"colours", 3}, {"match", std::string("edges")}, {"set", std::string("compact")}});
    EXPECT_EQ(edges.outputs.image("tile-sheet")->size(), (Size{120, 60}));
}

TEST(WangTiles, theSetIsGivenAsSheetTilesMapAndTable) {
    for (const char* match : {"corners", "edges"})
        for (const char* set : {"full", "compact"}) {
            const bool corners = match == std::string("corners");
            const Request request = requestOf(blobs({96, 96}, 3), {64, 64});
            const Synthesis result = made(
                request,
                {{"tile", 20}, {"colours", 3}, {"match", std::string(match)}, {"set", std::string(set)}});
            const Image& sheet = *result.outputs.image("tile-sheet");
            const auto map = result.outputs.first<PositionMap>("tile-sheet-map");
            EXPECT_TRUE(samePixels(map->apply(*request.exemplars.front().image), sheet));
            const auto table = result.outputs.first<Model>("tile-table");
            const std::vector<Asset>& tiles = result.outputs.at("tile");
            const auto count = static_cast<std::int64_t>(tiles.size());
            ASSERT_EQ(count, std::string(set) == "full" ? 81 : corners ? 54 : 18);
            const auto& edges = table->values<std::int64_t>("edges", {count, 4});
            const auto& own = table->values<std::int64_t>(corners ? "corners" : "edges", {count, 4});
            const auto& places = table->values<std::int64_t>("places", {count, 2});
            const auto& numbers = table->values<std::int64_t>("numbers", {3, 3, 3, 3});
            const auto tile = [&](std::int64_t i) -> const Image& {
                return *std::get<std::shared_ptr<const Image>>(tiles[static_cast<std::size_t>(i)]);
            };
            const auto colour = [](const std::vector<std::int64_t>& of, std::int64_t i, int side) {
                return of[static_cast<std::size_t>(4 * i + side)];
            };
            EXPECT_EQ(std::count(numbers.begin(), numbers.end(), -1), 81 - count);
            for (std::int64_t i = 0; i < count; ++i) {
                EXPECT_EQ(numbers[static_cast<std::size_t>(
                              ((colour(own, i, 0) * 3 + colour(own, i, 1)) * 3 + colour(own, i, 2)) * 3 +
                              colour(own, i, 3))],
                          i);
                const auto x = static_cast<int>(places[static_cast<std::size_t>(2 * i)]);
                const auto y = static_cast<int>(places[static_cast<std::size_t>(2 * i + 1)]);
                EXPECT_TRUE(samePixels(tile(i), Image(sheet.view().crop(x, y, {20, 20}))));
                // What lies at an edge of one colour is the same in every tile: equal colours are equal bits.
                for (std::int64_t k = 0; k < i; ++k)
                    for (int at = 1; at < 19; ++at) {
                        if (colour(edges, i, 0) == colour(edges, k, 0)) {
                            ASSERT_EQ(tile(i)(at, 0, 1), tile(k)(at, 0, 1));
                        }
                        if (colour(edges, i, 1) == colour(edges, k, 1)) {
                            ASSERT_EQ(tile(i)(19, at, 0), tile(k)(19, at, 0));
                        }
                        if (colour(edges, i, 2) == colour(edges, k, 2)) {
                            ASSERT_EQ(tile(i)(at, 19, 1), tile(k)(at, 19, 1));
                        }
                        if (colour(edges, i, 3) == colour(edges, k, 3)) {
                            ASSERT_EQ(tile(i)(0, at, 2), tile(k)(0, at, 2));
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
} // namespace texloom::test::wang_tiles_tests

#include "core/methods/wang_tiles/set_outputs.h"

#include "core/base/text.h"
#include "core/io/model_file.h"

#include <algorithm>
#include <memory>
#include <string>

namespace texloom::wang_tiles {

namespace {

constexpr const char *kSheetPort = "tile-sheet", *kSheetMapPort = "tile-sheet-map", *kTilePort = "tile",
                     *kTablePort = "tile-table";

/// The colours of a tile's edges: those of tiles with coloured corners have one colour for each pair of
/// corners, from left to right or from top to bottom.
Colours edgeColours(const Settings& settings, const Colours& tile) {
    if (settings.match == Match::Edges)
        return tile;
    const int k = settings.colours;
    return {tile.north * k + tile.east, tile.east * k + tile.south, tile.west * k + tile.south,
            tile.north * k + tile.west};
}

/// What another program needs to lay the tiles: the colours of each one's edges and, where they have any, of
/// its corners, its place on the sheet in pixels, and for every combination of colours the number of its
/// tile, −1 where the set has none.
std::shared_ptr<const Model> tableOf(const Settings& settings, const std::vector<Colours>& tiles) {
    const std::int64_t k = settings.colours, count = static_cast<std::int64_t>(tiles.size());
    const bool corners = settings.match == Match::Corners;
    std::vector<std::int64_t> edges, own, places, numbers(static_cast<std::size_t>(k * k * k * k), -1);
    for (std::int64_t i = 0; i < count; ++i) {
        const Colours& tile = tiles[static_cast<std::size_t>(i)];
        const Colours sides = edgeColours(settings, tile);
        edges.insert(edges.end(), {sides.north, sides.east, sides.south, sides.west});
        own.insert(own.end(), {tile.north, tile.east, tile.south, tile.west});
        const int inRow = tilesInRow(settings);
        places.insert(places.end(), {i % inRow * settings.tile, i / inRow * settings.tile});
        numbers[static_cast<std::size_t>(((tile.north * k + tile.east) * k + tile.south) * k + tile.west)] =
            i;
    }
    auto model = std::make_shared<Model>();
    model->kind = kTablePort;
    model->notes = {{"match", corners ? "corners" : "edges"},
                    {"colours", std::to_string(settings.colours)},
                    {"tile", std::to_string(settings.tile)},
                    {"tiles-in-row", std::to_string(tilesInRow(settings))},
                    {"set", settings.set == Set::Full ? "full" : "compact"},
                    {"edges", "north, east, south, west of each tile"},
                    {"places", "left and top of each tile on the sheet, in pixels"},
                    {"numbers", corners ? "tile by corners, in the order of corners; -1: none"
                                        : "tile by north, east, south, west; -1: none"}};
    model->arrays["edges"] = {{count, 4}, std::move(edges)};
    if (corners) {
        model->notes["corners"] = "upper left, upper right, lower right, lower left of each tile";
        model->arrays["corners"] = {{count, 4}, std::move(own)};
    }
    model->arrays["places"] = {{count, 2}, std::move(places)};
    model->arrays["numbers"] = {{k, k, k, k}, std::move(numbers)};
    return model;
}

} // namespace

std::vector<Port> setPorts() {
    return {
        {.id = kSheetPort,
         .title = TR("Tile sheet"),
         .help = TR("All tiles side by side; those of a full set match there."),
         .kind = AssetKind::Image},
        {.id = kSheetMapPort,
         .title = TR("Map of the sheet"),
         .help = TR("Where each pixel of the sheet comes from: `apply` makes the same sheet of companion "
                    "maps with it."),
         .kind = AssetKind::Map},
        {.id = kTilePort,
         .title = TR("Single tiles"),
         .help = TR("Every tile by itself, in the order of the table."),
         .kind = AssetKind::Image,
         .most = kAnyNumber},
        {.id = kTablePort,
         .title = TR("Table of tiles"),
         .help = TR("The colours of every tile's edges and corners, its place on the sheet, and the tile for "
                    "each combination of colours; as .json for other programs."),
         .kind = AssetKind::Model}};
}

void addSet(const Request& request, const Settings& settings, const TileSet& tiles,
            const std::vector<Colours>& colours, JobContext& context, Synthesis& result) {
    const int side = settings.tile, inRow = tilesInRow(settings), count = static_cast<int>(colours.size());
    const Size size{inRow * side, count / inRow * side};
    auto sheet = std::make_shared<Image>(size, request.resultChannels());
    auto map = std::make_shared<PositionMap>(size, request.exemplarSizes());
    context.parallel(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const auto cell = static_cast<std::size_t>(y / side) * static_cast<std::size_t>(inRow) +
                              static_cast<std::size_t>(x / side);
            const Source source = tiles.source(colours[cell], x % side, y % side);
            map->at(x, y) = source;
            for (int c = 0; c < sheet->channels(); ++c)
                (*sheet)(x, y, c) = (*request.exemplars[source.exemplar].image)(source.x, source.y, c);
        }
    });
    for (int i = 0; i < count; ++i) {
        context.check();
        result.outputs.add(kTilePort, std::make_shared<const Image>(sheet->view().crop(
                                          i % inRow * side, i / inRow * side, {side, side})));
    }
    result.outputs.add(kSheetPort, std::shared_ptr<const Image>(std::move(sheet)));
    result.outputs.add(kSheetMapPort, std::shared_ptr<const PositionMap>(std::move(map)));
    result.outputs.add(kTablePort, tableOf(settings, colours));
}

std::uint64_t setBytesFor(const Settings& settings, int channels) {
    const auto count = static_cast<std::int64_t>(coloursOf(settings).size());
    const int inRow = tilesInRow(settings);
    const Size size{inRow * settings.tile, static_cast<int>(count) / inRow * settings.tile};
    return 2 * Image::bytesFor(size, channels) +
           static_cast<std::uint64_t>(count) *
               (Image::bytesFor({settings.tile, settings.tile}, channels) + 256) +
           PositionMap::bytesFor(size) + (1U << 16);
}

} // namespace texloom::wang_tiles

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/wang_tiles/corner_tiles.h"
#include "core/methods/wang_tiles/edge_tiles.h"
#include "core/methods/wang_tiles/interiors.h"
#include "core/methods/wang_tiles/sampler.h"
#include "core/methods/wang_tiles/set_outputs.h"
#include "core/methods/wang_tiles/tiling.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace texloom::wang_tiles {

namespace {

/// Rows that are laid between two moments for progress and previews.
constexpr int kRowsAtOnce = 128;
/// From this error of the worst cut on seams show.
constexpr double kPoor = 0.5;

/// Makes the sets of tiles of every size that a tiling has.
class Maker {
public:
    Maker(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context), m_colours(coloursOf(settings)),
          m_sampler(request, settings, context) {
        const Size size{settings.tile, settings.tile};
        if (settings.match == Match::Edges) {
            m_samples = m_sampler.draw(0.4, [&](const Samples& samples) {
                return EdgeTiles(request, settings, samples, size, m_colours, context).worstError();
            });
        } else {
            m_samples = m_sampler.draw(0.1, [&](const Samples& samples) {
                return CornerTiles(request, settings, samples, size, context).worstError();
            });
            context.stage(0.3, TR("Filling tiles"));
            m_interiors.emplace(request, settings, context);
            m_interiors->find({request, settings, m_samples, size, context}, m_colours);
        }
        m_tiles.emplace(ofSize(size));
    }

    const Sampler& sampler() const { return m_sampler; }
    const TileSet& tiles() const { return *m_tiles; }
    const std::vector<Colours>& colours() const { return m_colours; }
    TileSet ofSize(Size size) const {
        if (m_interiors)
            return m_interiors->cover({m_request, m_settings, m_samples, size, m_context}, m_colours);
        const EdgeTiles cuts(m_request, m_settings, m_samples, size, m_colours, m_context);
        TileSet tiles(m_settings.colours, size);
        for (const Colours& colours : m_colours) {
            m_context.check();
            std::vector<Source> sources;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    sources.push_back(cuts.source(colours, x, y));
            tiles.add(colours, std::move(sources));
        }
        return tiles;
    }

private:
    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    std::vector<Colours> m_colours;
    Sampler m_sampler;
    Samples m_samples;
    std::optional<Interiors> m_interiors;
    std::optional<TileSet> m_tiles;
};

/// Cell and place in it for every pixel along an axis.
struct Along {
    std::vector<int> cell, at;
    Along(const std::vector<int>& lengths, int first, int count) {
        int start = 0;
        for (int i = 0; start < first + count; ++i) {
            const int length = lengths[static_cast<std::size_t>(i)];
            for (int k = std::max(0, first - start); k < length && start + k < first + count; ++k) {
                cell.push_back(i);
                at.push_back(k);
            }
            start += length;
        }
    }
};

/// Lays tiles in the part of the output that is wanted.
class Layer {
public:
    Layer(const Request& request, const Settings& settings, const Maker& maker, JobContext& context)
        : m_request(request), m_context(context), m_part(request.part()),
          m_tiling(request, settings, context.random()), m_x(m_tiling.widths(), m_part.x, m_part.size.width),
          m_y(m_tiling.heights(), m_part.y, m_part.size.height) {
        // Cells that differ in size come one after the other: the first and the last have all sizes.
        for (const int row : {m_y.cell.front(), m_y.cell.back()})
            for (const int column : {m_x.cell.front(), m_x.cell.back()})
                if (const Size size = sizeOf(column, row);
                    m_sets.find({size.width, size.height}) == m_sets.end())
                    m_sets.emplace(std::pair(size.width, size.height),
                                   size == maker.tiles().size() ? maker.tiles() : maker.ofSize(size));
    }

    /// @param result has image and map of the part's size.
    void run(Synthesis& result) {
        for (int top = 0; top < m_part.size.height; top += kRowsAtOnce) {
            const int bottom = std::min(m_part.size.height, top + kRowsAtOnce);
            m_context.parallel(top, bottom, [&](int y) { layRow(y, result); });
            m_context.progress(static_cast<double>(bottom) / m_part.size.height);
            m_context.preview(result.image, &result.map);
        }
    }

private:
    Size sizeOf(int column, int row) const {
        return {m_tiling.widths()[static_cast<std::size_t>(column)],
                m_tiling.heights()[static_cast<std::size_t>(row)]};
    }

    void layRow(int y, Synthesis& result) const {
        const int row = m_y.cell[static_cast<std::size_t>(y)], inRow = m_y.at[static_cast<std::size_t>(y)];
        for (int x = 0; x < m_part.size.width;) {
            const int column = m_x.cell[static_cast<std::size_t>(x)];
            const Size size = sizeOf(column, row);
            const TileSet& tiles = m_sets.at({size.width, size.height});
            const Source* const sources = tiles.tile(m_tiling.colours(column, row)).data() +
                                          static_cast<std::ptrdiff_t>(inRow) * size.width;
            for (; x < m_part.size.width && m_x.cell[static_cast<std::size_t>(x)] == column; ++x) {
                const Source source = sources[m_x.at[static_cast<std::size_t>(x)]];
                result.map.at(x, y) = source;
                for (int c = 0; c < m_request.channels(); ++c)
                    result.image(x, y, c) =
                        (*m_request.exemplars[source.exemplar].image)(source.x, source.y, c);
            }
        }
    }

    const Request& m_request;
    JobContext& m_context;
    Region m_part;
    Tiling m_tiling;
    Along m_x, m_y;
    std::map<std::pair<int, int>, TileSet> m_sets; ///< by the size of their tiles
};

void check(const Request& request, const Settings& settings) {
    const int side = sampleSide(settings);
    for (const Exemplar& exemplar : request.exemplars) {
        const Size size = exemplar.image->size();
        if (size.shorterSide() < side)
            failUsage(
                "Tiles of {} px take samples of {} × {} px, but {} is {} × {} px; choose smaller tiles or "
                "less overlap.",
                settings.tile, side, side, exemplar.name, size.width, size.height);
    }
    if (!leavesWholePatch(request, side))
        failUsage("The mask leaves no whole sample of {} px for tiles of {} px; choose smaller tiles or mask "
                  "less.",
                  side, settings.tile);
    if (settings.set == Set::Compact && (request.wrap.x || request.wrap.y))
        failUsage(
            "A compact set of {} tiles need not close over a border; choose a full set for outputs that "
            "wrap.",
            coloursOf(settings).size());
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size part = request.part().size;
    const auto tiles = static_cast<double>(coloursOf(settings).size());
    const auto side = static_cast<double>(settings.tile);
    const bool corners = settings.match == Match::Corners;
    Estimate need;
    need.bytes = Image::bytesFor(part, request.channels()) + PositionMap::bytesFor(part) +
                 setBytesFor(settings, request.resultChannels()) + 5 * TileSet::bytesFor(settings) +
                 2 * EdgeTiles::bytesFor(settings) +
                 (corners ? Interiors::bytesFor(request, settings, threads) : 0) +
                 static_cast<std::uint64_t>(threads * side * side * 8) + (4U << 20) +
                 static_cast<std::uint64_t>(part.width + part.height) * 16;
    for (const Exemplar& exemplar : request.exemplars) {
        if (corners) // blurred, with what that takes meanwhile
            need.bytes += 2 * Image::bytesFor(exemplar.image->size(), request.channels());
        if (exemplar.mask())
            need.bytes +=
                static_cast<std::uint64_t>(exemplar.image->size().area()) * 2 * sizeof(PatchPosition);
    }
    if (settings.set == Set::Compact)
        need.bytes += static_cast<std::uint64_t>(2 * sizeof(Colours) * (request.size.width / side + 2) *
                                                 (request.size.height / side + 2));
    need.seconds = static_cast<double>(part.area()) * (2e-8 + 3e-9 * request.channels());
    const double compared = side * side * settings.overlap * (1e-8 + 2e-9 * request.channels());
    if (corners) {
        double pixels = 0;
        for (const Size& size : request.exemplarSizes())
            pixels = std::max(pixels, static_cast<double>(size.area()));
        need.seconds += settings.tries * settings.colours * settings.colours * settings.overlap * compared +
                        tiles * (pixels * 6e-8 * request.channels() + side * side * settings.overlap * 4e-6);
    } else
        need.seconds += settings.tries * tiles * 2 * compared;
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    // Memory comes first: no one waits for a large output's to be cleared once the work has begun.
    Synthesis result;
    result.image = Image(request.part().size, request.channels());
    result.map = PositionMap(request.part().size, request.exemplarSizes());
    result.mapKind = MapKind::Exact;
    const Maker maker(request, settings, context);
    const double error = maker.sampler().error();
    context.stage(0.5, TR("Laying tiles"));
    Layer(request, settings, maker, context).run(result);
    context.stage(0.1, TR("Drawing the tile set"));
    addSet(request, settings, maker.tiles(), maker.colours(), context, result);
    result.figures = {{TR("Tiles"), static_cast<double>(maker.colours().size())},
                      {TR("Draws of samples"), static_cast<double>(maker.sampler().tries())},
                      {TR("Error of the worst cut"), error}};
    if (const double poor = std::max(kPoor, settings.threshold); error > poor)
        result.notes.push_back(
            message("The worst cut's error is {:.2f} of that of unlike pixels, more than the {} wished for; "
                    "more tries, larger tiles or fewer colours may help.",
                    error, numberText(poor)));
    context.progress(1);
    return result;
}

std::vector<Port> given() {
    std::vector<Port> all = {ports::inParts(ports::wrappingImage()), ports::map()};
    for (Port& port : setPorts())
        all.push_back(std::move(port));
    return all;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Wang tiles"),
     .summary =
         TR("Makes a small set of tiles that match by colours, and lays them without a period. "
            "Outputs of any size come in an instant, and any part of them alone; the set can be used by "
            "itself. Suits what has no large objects."),
     .citation =
         "Cohen, Shade, Hiller & Deussen, SIGGRAPH 2003; Ng, Wen, Tan, Zhang & Kim, CGI 2005; Lagae & "
         "Dutré, ACM TOG 2006; Wei, Graphics Hardware 2004",
     .category = Category::Patches,
     .suits = {.regular = 1, .grain = 3, .objects = 3, .large = 2},
     .takes = {ports::weighedExemplars(), ports::mask()},
     .gives = given()},
    {field(&Settings::tile, "tile", TR("Tile size"))
         .range(4, 1024)
         .unit("px")
         .scaled(0.5)
         .help(
             TR("Side of a tile: larger repeats less and keeps larger structures, smaller has more edges.")),
     field(&Settings::match, "match", TR("Match"))
         .choices({{"corners", TR("Corners")}, {"edges", TR("Edges")}})
         .help(TR("What has colours: corners, with fresh texture inside each tile, repeat less; edges are as "
                  "published first, each tile four samples in diamonds.")),
     field(&Settings::colours, "colours", TR("Colours"))
         .range(2, 4)
         .help(
             TR("Kinds of corners, or of edges on each axis: more make more tiles, which repeat less and are "
                "harder to cut well.")),
     field(&Settings::set, "set", TR("Set"))
         .choices({{"full", TR("Full")}, {"compact", TR("Compact")}})
         .help(
             TR("A full set has a tile for every combination of colours and can wrap; a compact one has two "
                "for whatever is above and to the left.")),
     field(&Settings::overlap, "overlap", TR("Overlap"))
         .range(0.02, 0.5)
         .group(TR("Advanced"))
         .help(
             TR("Width of the zone in which the cuts may run, as a share of the tile: wider joins better.")),
     field(&Settings::tries, "tries", TR("Tries"))
         .range(1, 1000)
         .group(TR("Advanced"))
         .help(TR(
             "How often the samples are drawn again, at most, until the worst cut is good enough; the best "
             "are kept.")),
     field(&Settings::threshold, "threshold", TR("Good enough"))
         .range(0, 2)
         .group(TR("Advanced"))
         .help(
             TR("Error of the worst cut at which no more samples are drawn, over the error of unlike pixels: "
                "smaller searches longer."))},
    run, check, estimate);

} // namespace texloom::wang_tiles

#include "core/base/at.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/whole_patches.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/wang_tiles/set_outputs.h"
#include "core/methods/wang_tiles/tiling.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace texloom::wang_tiles {

namespace {

/// Rows that are laid between two moments for progress and previews.
constexpr int kRowsAtOnce = 128;
/// From this error of the worst cut on seams show.
constexpr double kPoor = 0.5;
/// One of so many draws is of all samples.
constexpr int kWhole = 4;

/// The places that samples may be taken from.
class SamplePlaces {
public:
    SamplePlaces(const Request& request, int side, JobContext& context) {
        for (const Exemplar& exemplar : request.exemplars) {
            Own own{{exemplar.image->width() - side + 1, exemplar.image->height() - side + 1}, {}, 0};
            if (exemplar.mask())
                anyWholePatch(
                    exemplar.mask()->view().plane(0), side,
                    [&](int x, int y) {
                        own.allowed.push_back({0, x, y});
                        return false;
                    },
                    [&] { context.check(); });
            const auto count = exemplar.mask() ? static_cast<double>(own.allowed.size())
                                               : static_cast<double>(own.positions.area());
            m_whole += count * exemplar.weight;
            own.until = m_whole;
            m_exemplars.push_back(std::move(own));
        }
    }

    PatchPosition drawn(const Random& random, int x, int y, std::uint32_t n) const {
        const double wanted = random.uniform(x, y, n) * m_whole;
        std::size_t e = 0;
        while (e + 1 < m_exemplars.size() && wanted >= m_exemplars[e].until)
            ++e;
        const Own& own = m_exemplars[e];
        PatchPosition position;
        if (!own.allowed.empty())
            position = own.allowed[random.below(static_cast<std::uint32_t>(own.allowed.size()), x, y, n + 1)];
        else {
            position.x =
                static_cast<int>(random.below(static_cast<std::uint32_t>(own.positions.width), x, y, n + 1));
            position.y =
                static_cast<int>(random.below(static_cast<std::uint32_t>(own.positions.height), x, y, n + 2));
        }
        position.exemplar = static_cast<int>(e);
        return position;
    }

private:
    struct Own {
        Size positions;
        std::vector<PatchPosition> allowed; ///< where there is a mask
        double until;                       ///< sum of weights up to this exemplar
    };
    std::vector<Own> m_exemplars;
    double m_whole = 0;
};

/// The error of two unlike pixels: twice the variance over all channels and exemplars.
double unlikeError(const Request& request, JobContext& context) {
    const auto check = [&] { context.check(); };
    return 2 *
           pixelVariance(patchSources(request), channelMeans(*request.exemplars.front().image, check), check);
}

/// Makes the sets of tiles of every size that a tiling has, from the samples that join best.
class Maker {
public:
    Maker(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context), m_edges(edgesOf(settings)),
          m_places(request, sampleSide(settings), context), m_unlike(unlikeError(request, context)) {}

    /// Draws samples until the worst cut is good enough: all of them a few times, then one after the other of
    /// the best so far. @return that error, over that of unlike pixels.
    double draw(double weight) {
        m_context.stage(weight, TR("Cutting tiles"));
        double best = 0;
        for (int n = 0; n < m_settings.tries; ++n) {
            TileSet::Samples samples = n * kWhole < m_settings.tries ? drawn(n) : withAnother(n);
            TileSet tiles(m_request, m_settings, samples, {m_settings.tile, m_settings.tile}, m_edges,
                          m_context);
            ++m_tries;
            const double error = m_unlike > 0 ? tiles.worstError() / m_unlike : 0;
            if (!m_tiles || error < best) {
                best = error;
                m_samples = std::move(samples);
                m_tiles.emplace(std::move(tiles));
            }
            m_context.progress(static_cast<double>(n + 1) / m_settings.tries);
            if (best <= m_settings.threshold)
                break;
        }
        return best;
    }

    int tries() const { return m_tries; }
    const TileSet& tiles() const { return *m_tiles; }
    const std::vector<Edges>& edges() const { return m_edges; }
    TileSet ofSize(Size size) const { return {m_request, m_settings, m_samples, size, m_edges, m_context}; }

private:
    TileSet::Samples drawn(int n) const {
        TileSet::Samples samples;
        for (int colour = 0; colour < m_settings.colours; ++colour) {
            samples.across.push_back(sampleAcross(n, colour));
            samples.upright.push_back(sampleUpright(n, colour));
        }
        return samples;
    }
    /// The best samples so far but for one, each in its turn.
    TileSet::Samples withAnother(int n) const {
        TileSet::Samples samples = m_samples;
        const int turn = n % (2 * m_settings.colours), colour = turn / 2;
        if (turn % 2 == 0)
            samples.across[at(colour)] = sampleAcross(n, colour);
        else
            samples.upright[at(colour)] = sampleUpright(n, colour);
        return samples;
    }
    // The tiling's numbers are drawn at places that are not negative.
    PatchPosition sampleAcross(int n, int colour) const {
        return m_places.drawn(m_context.random(), -1 - n, colour, 0);
    }
    PatchPosition sampleUpright(int n, int colour) const {
        return m_places.drawn(m_context.random(), -1 - n, colour, 3);
    }

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    std::vector<Edges> m_edges;
    SamplePlaces m_places;
    double m_unlike;
    TileSet::Samples m_samples;
    std::optional<TileSet> m_tiles;
    int m_tries = 0;
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
            const Edges edges = m_tiling.edges(column, row);
            const Size size = sizeOf(column, row);
            const TileSet& tiles = m_sets.at({size.width, size.height});
            for (; x < m_part.size.width && m_x.cell[static_cast<std::size_t>(x)] == column; ++x) {
                const Source source = tiles.source(edges, m_x.at[static_cast<std::size_t>(x)], inRow);
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
            2 * settings.colours * settings.colours);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size part = request.part().size;
    const auto tiles = static_cast<double>(edgesOf(settings).size());
    const auto side = static_cast<double>(settings.tile);
    Estimate need;
    need.bytes = Image::bytesFor(part, request.channels()) + PositionMap::bytesFor(part) +
                 setBytesFor(settings, request.resultChannels()) + 6 * TileSet::bytesFor(settings) +
                 static_cast<std::uint64_t>(threads * side * side * 8) + (4U << 20) +
                 static_cast<std::uint64_t>(part.width + part.height) * 16;
    for (const Exemplar& exemplar : request.exemplars)
        if (exemplar.mask())
            need.bytes +=
                static_cast<std::uint64_t>(exemplar.image->size().area()) * 2 * sizeof(PatchPosition);
    if (settings.set == Set::Compact)
        need.bytes += static_cast<std::uint64_t>(2 * sizeof(Edges) * (request.size.width / side + 2) *
                                                 (request.size.height / side + 2));
    need.seconds =
        static_cast<double>(part.area()) * (2e-8 + 3e-9 * request.channels()) +
        settings.tries * tiles * side * side * settings.overlap * 2 * (1e-8 + 2e-9 * request.channels());
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    // Memory comes first: no one waits for a large output's to be cleared once the work has begun.
    Synthesis result;
    result.image = Image(request.part().size, request.channels());
    result.map = PositionMap(request.part().size, request.exemplarSizes());
    result.mapKind = MapKind::Exact;
    Maker maker(request, settings, context);
    const double error = maker.draw(0.4);
    context.stage(0.5, TR("Laying tiles"));
    Layer(request, settings, maker, context).run(result);
    context.stage(0.1, TR("Drawing the tile set"));
    addSet(request, settings, maker.tiles(), maker.edges(), context, result);
    result.figures = {{TR("Tiles"), static_cast<double>(maker.edges().size())},
                      {TR("Draws of samples"), static_cast<double>(maker.tries())},
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
         TR("Makes a small set of tiles whose edges match by colour, and lays them without a period. "
            "Outputs of any size come in an instant, and any part of them alone; the set can be used by "
            "itself. Suits what has no large objects."),
     .citation = "Cohen, Shade, Hiller & Deussen, SIGGRAPH 2003; Wei, Graphics Hardware 2004",
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
     field(&Settings::colours, "colours", TR("Edge colours"))
         .range(2, 4)
         .help(
             TR("Kinds of edges on each axis: more make more tiles, which repeat less and are harder to cut "
                "well.")),
     field(&Settings::set, "set", TR("Set"))
         .choices({{"full", TR("Full")}, {"compact", TR("Compact")}})
         .help(
             TR("A full set has a tile for every combination of colours and can wrap; a compact one has two "
                "for each pair above and to the left.")),
     field(&Settings::overlap, "overlap", TR("Overlap"))
         .range(0.02, 0.5)
         .group(TR("Advanced"))
         .help(TR("Width of the zone along the diagonals in which the cuts may run, as a share of the tile: "
                  "wider joins better.")),
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

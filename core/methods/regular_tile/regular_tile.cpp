#include "core/analysis/correlation.h"
#include "core/analysis/lattice_detector.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/regular_tile/settings.h"
#include "core/methods/regular_tile/tile_family.h"
#include "core/methods/regular_tile/tile_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace texloom::regular_tile {

namespace {

constexpr int kSmallest = 8; ///< shorter side of an exemplar in which a tile is searched
constexpr int kStrip = 32;   ///< rows of the output that one task makes

/// The tile of an exemplar without a lattice: the displacements, of half to three quarters of its sides, at
/// which it is most similar to itself.
Lattice likestRectangle(const ImageView& exemplar, const std::function<void()>& check) {
    const Correlation gamma = autocorrelation(exemplar, check);
    const auto best = [](int length, auto value) {
        int at = length / 2;
        for (int side = length / 2; side <= 3 * length / 4; ++side)
            if (value(side) > value(at))
                at = side;
        return at;
    };
    const int width = best(exemplar.width, [&](int side) { return gamma.at(side, 0); });
    const int height = best(exemplar.height, [&](int side) { return gamma.at(0, side); });
    return {{double(width), 0}, {0, double(height)}};
}

/// A lattice whose texture is free along a line repeats a stretch of it as long as the exemplar allows.
Lattice withLength(const Lattice& lattice, Size exemplar) {
    const auto stretched = [&](Vec2 step, Vec2 other) {
        const double room =
            std::min((exemplar.width - std::abs(other.x)) / std::max(1e-9, std::abs(step.x)),
                     (exemplar.height - std::abs(other.y)) / std::max(1e-9, std::abs(step.y)));
        return std::max(1.0, std::floor(0.75 * room)) * step;
    };
    Lattice longer = lattice;
    if (alongRows(lattice.v1))
        longer.v1 = stretched(lattice.v1, lattice.v2);
    if (alongRows(lattice.v2))
        longer.v2 = stretched(lattice.v2, longer.v1);
    return longer;
}

/// Of the zone in which tiles on either side of an edge fade into each other: the neighbour's step, 0 if the
/// place is outside, and its weight. @param at from 0 to 1 over the tile. @param half of the zone's width
struct Fade {
    int step = 0;
    double weight = 0;

    Fade(double at, double half) {
        if (at < half) {
            step = -1;
            weight = 0.5 * (half - at) / half;
        } else if (at > 1 - half) {
            step = 1;
            weight = 0.5 * (at - (1 - half)) / half;
        }
    }
};

/// Tiles of an output that vary: each is drawn by its place alone, which on an axis that wraps counts but
/// once.
class VariedTiles {
public:
    VariedTiles(const Request& request, const Settings& settings, const TileFamily& family,
                const Lattice& lattice, const Random& random)
        : m_size(request.size), m_wrap(request.wrap), m_draw(settings.draw), m_family(family),
          m_lattice(lattice), m_random(random),
          m_half1(std::min(0.5, settings.feather * lattice.v2.length() / lattice.area())),
          m_half2(std::min(0.5, settings.feather * lattice.v1.length() / lattice.area())),
          m_pixel(static_cast<std::size_t>(request.channels())) {}

    /// The channels of a pixel of the output.
    const std::vector<float>& at(int x, int y) {
        const Vec2 place = m_lattice.coordinates({x + 0.5, y + 0.5});
        const int a = static_cast<int>(std::floor(place.x)), b = static_cast<int>(std::floor(place.y));
        const Fade along1(place.x - a, m_half1), along2(place.y - b, m_half2);
        std::fill(m_pixel.begin(), m_pixel.end(), 0.0F);
        for (const auto& [da, wa] : {std::pair(0, 1 - along1.weight), {along1.step, along1.weight}})
            for (const auto& [db, wb] : {std::pair(0, 1 - along2.weight), {along2.step, along2.weight}})
                if (wa * wb > 0) {
                    const Copy& copy = copyAt(a + da, b + db);
                    m_family.add(copy.coefficients, x - copy.x, y - copy.y, static_cast<float>(wa * wb),
                                 m_pixel.data());
                }
        return m_pixel;
    }

private:
    struct Copy {
        int x = 0, y = 0; ///< the pixel of its corner
        std::vector<float> coefficients;
    };

    /// The multiples of `length` by which a coordinate on an axis that wraps is beyond the output.
    static double beyond(double at, int length, bool wraps) {
        constexpr double kRounding = 1e-6;
        return wraps ? length * std::floor(at / length + kRounding) : 0;
    }

    const Copy& copyAt(int a, int b) {
        const auto [known, added] = m_copies.try_emplace({a, b});
        if (!added)
            return known->second;
        const Vec2 corner = m_lattice.at(a, b);
        const Vec2 off{beyond(corner.x, m_size.width, m_wrap.x), beyond(corner.y, m_size.height, m_wrap.y)};
        const Vec2 own = m_lattice.coordinates(corner - off);
        const int ownA = static_cast<int>(std::lround(own.x)), ownB = static_cast<int>(std::lround(own.y));
        const Vec2 ownCorner = m_lattice.at(ownA, ownB);
        known->second = {static_cast<int>(std::lround(ownCorner.x) + std::lround(off.x)),
                         static_cast<int>(std::lround(ownCorner.y) + std::lround(off.y)),
                         m_family.drawn(m_draw, ownA, ownB, m_random)};
        return known->second;
    }

    Size m_size;
    Wrap m_wrap;
    Draw m_draw;
    const TileFamily& m_family;
    Lattice m_lattice;
    const Random& m_random;
    double m_half1, m_half2;
    std::vector<float> m_pixel;
    std::map<std::pair<int, int>, Copy> m_copies;
};

class Repeater {
public:
    Repeater(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context),
          m_exemplar(*request.exemplars.front().image), m_part(request.part()) {}

    Synthesis run() {
        m_context.stage(0.3, TR("Looking for the lattice"));
        findLattice();
        m_context.stage(0.3, TR("Looking for the tile"));
        findTile();
        if (m_settings.colour == Colour::Varied)
            findFamily();
        m_context.stage(0.4, TR("Repeating the tile"));
        repeat();
        m_result.mapKind = m_family ? MapKind::Estimated : MapKind::Exact;
        m_result.figures = {{TR("Tile, first vector right"), m_lattice.v1.x},
                            {TR("Tile, first vector down"), m_lattice.v1.y},
                            {TR("Tile, second vector right"), m_lattice.v2.x},
                            {TR("Tile, second vector down"), m_lattice.v2.y},
                            {TR("Mean squared difference where tiles join"), m_joint}};
        if (m_family)
            describeFamily();
        return std::move(m_result);
    }

private:
    void findLattice() {
        const auto check = [this] { m_context.check(); };
        m_lattice = latticeFor(m_settings, m_request.exemplars.front().name,
                               m_request.exemplars.front().image, m_result.notes, check);
        if (m_settings.lattice == LatticeSource::Given)
            m_lattice = m_settings.given(); // exactly the parallelogram requested
        if (m_lattice.free())
            m_lattice = likestRectangle(m_exemplar, check);
        m_lattice = withLength(m_lattice, m_exemplar.size());
        m_own = m_lattice;
        if (!m_request.wrap.x && !m_request.wrap.y)
            return;
        const WrappedLattice closing = wrapped(m_lattice, m_request.size, m_request.wrap);
        const Size size = m_request.size;
        constexpr double kTooMuch = 0.6, kWorthSaying = 0.02;
        if (closing.stretch > kTooMuch)
            failUsage("An output of {} × {} px cannot wrap with a tile of {:.0f} × {:.0f} px; make it at "
                      "least that large.",
                      size.width, size.height, m_lattice.extent().x, m_lattice.extent().y);
        if (closing.stretch > kWorthSaying) {
            const Size whole = wrappingRectangle(m_lattice, std::max(4096, size.longerSide()));
            m_result.notes.push_back(message("To wrap at {} × {} px the tile was changed by {:.1f} %; a "
                                             "multiple of {} × {} px needs no change.",
                                             size.width, size.height, 100 * closing.stretch, whole.width,
                                             whole.height));
        }
        m_lattice = closing.lattice;
    }

    void findTile() {
        if (m_settings.tile == Choice::Given) {
            m_tile = {static_cast<int>(std::lround(m_settings.tileX)),
                      static_cast<int>(std::lround(m_settings.tileY)), 0};
            Image cost(m_exemplar.size(), 1);
            forbid(cost);
            if (std::isinf(cost(m_tile.x, m_tile.y, 0)))
                failUsage("The tile at ({}, {}) holds pixels that the mask hides; choose another corner.",
                          m_tile.x, m_tile.y);
            return;
        }
        // A border that leaves no tile inside the exemplar is narrowed.
        for (int border = m_settings.border;; border /= 2) {
            Image costs =
                tileCosts(m_exemplar, m_lattice, std::max(1, border), [this] { m_context.check(); });
            forbid(costs);
            const ValueRange range = valueRange(costs);
            if (std::isinf(range.smallest) && border > 1)
                continue;
            if (std::isinf(range.smallest) && m_request.exemplars.front().mask())
                failUsage("The mask leaves no whole tile of {:.0f} × {:.0f} px to copy; mask less.",
                          m_lattice.extent().x, m_lattice.extent().y);
            m_tile = drawTile(costs, m_settings.tolerance, m_context.random());
            const double pixels = std::max(1, border) * (m_lattice.v1.length() + m_lattice.v2.length());
            m_joint = static_cast<double>(m_tile.cost) / pixels / m_exemplar.channels;
            return;
        }
    }

    void forbid(Image& costs) {
        if (const Image* const mask = m_request.exemplars.front().mask())
            forbidTiles(costs, mask->view().plane(0), m_lattice, [this] { m_context.check(); });
    }

    void findFamily() {
        const Image* const mask = m_request.exemplars.front().mask();
        m_family.emplace(m_exemplar, mask ? mask->view().plane(0) : PlaneView{}, m_own, m_lattice, m_tile,
                         m_settings.feather, m_settings.bases, m_context);
        if (m_family->tiles() == 1)
            m_result.notes.push_back(message("{} holds only one whole tile, so that nothing varies; a larger "
                                             "exemplar or a smaller tile shows how tiles differ.",
                                             m_request.exemplars.front().name));
    }

    void describeFamily() {
        m_result.figures.push_back({TR("Whole tiles"), static_cast<double>(m_family->tiles())});
        m_result.figures.push_back({TR("Principal components"), static_cast<double>(m_family->bases())});
        m_result.figures.push_back({TR("Share of the variance in them"), m_family->share()});
        m_result.pictures.push_back({TR("Mean tile and components"), m_family->picture()});
    }

    void repeat() {
        m_result.image = Image(m_part.size, m_exemplar.channels);
        m_result.map = PositionMap(m_part.size, m_request.exemplarSizes());
        const int strips = (m_part.size.height + kStrip - 1) / kStrip;
        m_context.parallelAfter(
            strips, [](int) { return std::vector<int>{}; },
            [this](int strip) {
                std::optional<VariedTiles> varied;
                if (m_family)
                    varied.emplace(m_request, m_settings, *m_family, m_lattice, m_context.random());
                for (int y = strip * kStrip; y < std::min((strip + 1) * kStrip, m_part.size.height); ++y) {
                    m_context.check();
                    repeatRow(y, varied ? &*varied : nullptr);
                }
            },
            [&](int done) {
                m_context.progress(double(done) / strips);
                m_context.preview(m_result.image, &m_result.map);
            });
    }

    void repeatRow(int row, VariedTiles* varied) {
        for (int x = 0; x < m_part.size.width; ++x) {
            const Source source = sourceOf(m_part.x + x, m_part.y + row);
            m_result.map.at(x, row) = source;
            const std::vector<float>* const pixel =
                varied ? &varied->at(m_part.x + x, m_part.y + row) : nullptr;
            for (int c = 0; c < m_exemplar.channels; ++c)
                m_result.image(x, row, c) =
                    pixel ? (*pixel)[static_cast<std::size_t>(c)] : m_exemplar(source.x, source.y, c);
        }
    }

    /// Each copy of the tile moves by a whole number of pixels, so that it stays a copy where the lattice's
    /// vectors are not integers.
    Source sourceOf(int x, int y) const {
        const Vec2 at = m_lattice.coordinates({x + 0.5, y + 0.5});
        const Vec2 corner = m_lattice.at(std::floor(at.x), std::floor(at.y));
        const int fromX = x - static_cast<int>(std::lround(corner.x)) + m_tile.x;
        const int fromY = y - static_cast<int>(std::lround(corner.y)) + m_tile.y;
        return {static_cast<std::uint16_t>(std::clamp(fromX, 0, m_exemplar.width - 1)),
                static_cast<std::uint16_t>(std::clamp(fromY, 0, m_exemplar.height - 1)), 0};
    }

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    ImageView m_exemplar;
    Region m_part;
    Lattice m_own, m_lattice; ///< of the exemplar, and of the output, which differs where that wraps
    Tile m_tile;
    std::optional<TileFamily> m_family;
    double m_joint = 0;
    Synthesis m_result;
};

void check(const Request& request, const Settings& settings) {
    const Exemplar& exemplar = request.exemplars.front();
    const Size size = exemplar.image->size();
    if (size.shorterSide() < kSmallest)
        failUsage("{} is {} × {} px; a tile is looked for in exemplars of at least {} × {} px.",
                  exemplar.name, size.width, size.height, kSmallest, kSmallest);
    checkLattice(settings, exemplar.name, size);
    if (exemplar.mask() && valueRange(*exemplar.mask()).largest == 0)
        failUsage("The mask hides all of {}; mask less.", exemplar.name);
    if (settings.tile == Choice::Given && (settings.tileX >= size.width || settings.tileY >= size.height))
        failUsage("The tile's corner ({}, {}) lies outside {} with {} × {} px.", numberText(settings.tileX),
                  numberText(settings.tileY), exemplar.name, size.width, size.height);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size exemplar = request.exemplars.front().image->size(), output = request.part().size;
    Estimate need;
    need.bytes = Image::bytesFor(output, request.channels()) + PositionMap::bytesFor(output) +
                 latticeBytesFor(exemplar, request.channels());
    if (settings.colour == Colour::Varied)
        need.bytes += TileFamily::bytesFor(exemplar, request.channels()) +
                      static_cast<std::uint64_t>(threads) * static_cast<std::uint64_t>(output.width) * 1024;
    need.seconds =
        latticeSecondsFor(exemplar) + 1e-8 * static_cast<double>(output.area()) * (1 + request.channels());
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Repeater(request, settings, context).run();
}

std::vector<Param> colourFields() {
    const auto varied = std::string("varied");
    return {
        field(&Settings::colour, "colour", TR("Colours"))
            .choices({{"one", TR("All tiles alike")}, {varied, TR("Varied")}})
            .help(TR("All tiles alike are copies of one; varied ones differ as the exemplar's tiles differ "
                     "from their mean, and are a little softer.")),
        field(&Settings::bases, "bases", TR("Components"))
            .range(0, 64)
            .when("colour", varied)
            .help(TR("In how many principal components tiles vary, at most: more show finer differences, 0 "
                     "repeats the mean tile.")),
        field(&Settings::draw, "draw", TR("Drawn"))
            .choices({{"normal", TR("Normally")}, {"resample", TR("From the exemplar’s tiles")}})
            .when("colour", varied)
            .help(TR("How much of each component a tile gets: normally distributed, which makes what the "
                     "exemplar does not show, or as much as some tile of the exemplar has.")),
        field(&Settings::feather, "feather", TR("Soft edge"))
            .range(0, 128)
            .unit("px")
            .when("colour", varied)
            .help(TR("How far into each other neighbouring tiles fade, up to half a tile: more hides their "
                     "edges, less is sharper."))};
}

std::vector<Param> params() {
    std::vector<Param> all = latticeFields<Settings>();
    all.push_back(
        field(&Settings::tile, "tile", TR("Tile"))
            .choices({{"best", TR("The one that joins itself best")}, {"given", TR("As given")}})
            .help(TR("The tile that is repeated: the one whose opposite sides are most alike, or the one at "
                     "a given place.")));
    all.push_back(field(&Settings::tileX, "tile-x", TR("Tile's corner, right"))
                      .role(lattice_role::kTileRight)
                      .range(0, 65535)
                      .unit("px")
                      .when("tile", std::string("given"))
                      .help(TR("Column of the exemplar at which the tile begins.")));
    all.push_back(field(&Settings::tileY, "tile-y", TR("Tile's corner, down"))
                      .role(lattice_role::kTileDown)
                      .range(0, 65535)
                      .unit("px")
                      .when("tile", std::string("given"))
                      .help(TR("Row of the exemplar at which the tile begins.")));
    all.push_back(
        field(&Settings::border, "border", TR("Compared border"))
            .range(2, 128)
            .unit("px")
            .when("tile", std::string("best"))
            .group(TR("Advanced"))
            .help(TR("Width of the borders in which opposite sides of a tile are compared: wider looks for "
                     "tiles that join in larger structures.")));
    all.push_back(field(&Settings::tolerance, "tolerance", TR("Tolerance"))
                      .range(0, 10)
                      .symbol("ε")
                      .when("tile", std::string("best"))
                      .group(TR("Advanced"))
                      .help(TR("How much worse than the best a tile may join itself and still be drawn: 0 "
                               "takes the best whatever the seed, larger lets seeds differ.")));
    for (Param& param : colourFields())
        all.push_back(std::move(param));
    for (Param& param : latticeSearchFields<Settings>())
        all.push_back(std::move(param));
    return all;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Regular tile"),
     .summary = TR(
         "Finds the lattice of a regular texture and repeats the one tile that joins itself best: strictly "
         "regular, without the variety of near-regular synthesis."),
     .citation = "López Recas, diploma thesis 2011, section 4.1; Liu, Lin & Hays, SIGGRAPH 2004",
     .category = Category::NearRegular,
     .suits = {.regular = 4},
     .takes = {ports::exemplar(), ports::mask()},
     .gives = {ports::inParts(ports::wrappingImage()), ports::map()}},
    params(), run, check, estimate);

} // namespace texloom::regular_tile

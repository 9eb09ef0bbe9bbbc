#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/patch_grid.h"
#include "core/methods/method.h"
#include "core/methods/random_mosaic/canvas.h"
#include "core/methods/random_mosaic/chaos.h"
#include "core/methods/random_mosaic/joints.h"
#include "core/methods/random_mosaic/layout.h"

#include <algorithm>
#include <array>

namespace texloom::random_mosaic {

namespace {

/// Rows that are laid between two moments for progress and previews.
constexpr int kRowsAtOnce = 128;

bool masked(const Request& request) {
    return std::any_of(request.exemplars.begin(), request.exemplars.end(),
                       [](const Exemplar& exemplar) { return exemplar.mask() != nullptr; });
}

/// Blocks move over whole exemplars side by side, or over pieces where masks leave no whole one.
Settings groundOf(const Request& request, const Settings& settings) {
    Settings ground = settings;
    if (settings.pieces == Pieces::Chaos && !masked(request))
        ground.size = kLargestSide;
    return ground;
}

/// Whether a part of the output takes the whole.
bool needsWhole(const Settings& settings) {
    return settings.stitch == Stitch::Poisson || settings.pieces == Pieces::Chaos;
}

bool overlaps(const Settings& settings) {
    return settings.stitch == Stitch::Cut || settings.stitch == Stitch::Feather;
}

/// Of the pieces that overlap: the shorter side counts, so that zones stay apart.
int overlapOf(const Request& request, const Settings& settings) {
    if (!overlaps(settings))
        return 0;
    const int side = std::min(settings.size, request.size.shorterSide());
    return overlapFor(std::max(2, side), settings.overlap);
}

/// Copies the pixels of a canvas along its cuts, or fades pieces into each other.
class Layer {
public:
    Layer(Canvas& canvas, const Request& request, const Region& part, bool fade)
        : m_canvas(canvas), m_request(request), m_part(part), m_fade(fade) {}

    void lay(const Layout& layout, const Joints& joints, JobContext& context) {
        for (int top = 0; top < m_part.size.height; top += kRowsAtOnce) {
            const int bottom = std::min(m_part.size.height, top + kRowsAtOnce);
            context.parallel(top, bottom, [&](int y) { layRow(layout, joints, y); });
            context.progress(static_cast<double>(bottom) / m_part.size.height);
            context.preview(m_canvas.image, &m_canvas.map);
        }
    }

private:
    void layRow(const Layout& layout, const Joints& joints, int y) {
        for (int x = 0; x < m_part.size.width; ++x) {
            Share share;
            if (m_fade)
                share = faded(joints, x, y);
            else {
                share = joints.owner(m_part.x + x, m_part.y + y);
                for (int c = 0; c < m_canvas.image.channels(); ++c)
                    m_canvas.image(x, y, c) = joints.pixel(share, c);
            }
            m_canvas.map.at(x, y) = joints.source(share);
            m_canvas.turn(x, y) = layout.tile(share.column, share.row).turn;
        }
    }

    Share faded(const Joints& joints, int x, int y) {
        std::array<Share, 4> shares;
        const int count = joints.shares(m_part.x + x, m_part.y + y, shares);
        for (int c = 0; c < m_canvas.image.channels(); ++c) {
            float sum = joints.pixel(shares[0], c);
            // Differences, so that equal pixels give just that.
            for (int i = 1; i < count; ++i) {
                const Share& share = shares[static_cast<std::size_t>(i)];
                sum += share.weight * (joints.pixel(share, c) - joints.pixel(shares[0], c));
            }
            m_canvas.image(x, y, c) = sum;
        }
        return *std::max_element(shares.begin(), shares.begin() + count,
                                 [](const Share& a, const Share& b) { return a.weight < b.weight; });
    }

    Canvas& m_canvas;
    const Request& m_request;
    Region m_part;
    bool m_fade;
};

Synthesis finished(Canvas& canvas, const Request& request, const Settings& settings, bool whole) {
    Synthesis result;
    const Region part = request.part();
    if (whole && request.region) {
        result.image = Image(canvas.image.view().crop(part.x, part.y, part.size));
        result.map = PositionMap(part.size, request.exemplarSizes());
        for (int y = 0; y < part.size.height; ++y)
            for (int x = 0; x < part.size.width; ++x)
                result.map.at(x, y) = canvas.map.at(part.x + x, part.y + y);
    } else {
        result.image = std::move(canvas.image);
        result.map = std::move(canvas.map);
    }
    result.mapKind = settings.stitch == Stitch::Cut || settings.stitch == Stitch::None ? MapKind::Exact
                                                                                       : MapKind::Dominant;
    return result;
}

void addNotes(const Request& request, const Settings& settings, const Layout& layout, Synthesis& result) {
    if (layout.pieces() > 1 || settings.pieces == Pieces::Chaos || request.exemplars.size() > 1)
        return;
    result.notes.push_back(
        message("{} is one piece of this size, so that the output only repeats it; choose pieces of at "
                "most {} px.",
                request.exemplars.front().name,
                std::max(8, request.exemplars.front().image->size().longerSide() / 2)));
}

void check(const Request& request, const Settings& settings) {
    for (const Exemplar& exemplar : request.exemplars) {
        const Size size = exemplar.image->size(), piece = pieceSize(size, settings);
        if (piece.width > size.width || piece.height > size.height)
            failUsage("{} is {} × {} px, smaller than a piece of {} px; choose pieces of at most {} px.",
                      exemplar.name, size.width, size.height, settings.size,
                      settings.pieces == Pieces::Columns ? size.width
                      : settings.pieces == Pieces::Rows  ? size.height
                                                         : size.shorterSide());
    }
    if (masked(request) &&
        std::none_of(request.exemplars.begin(), request.exemplars.end(), [](const Exemplar& exemplar) {
            if (!exemplar.mask())
                return true;
            return valueRange(*exemplar.mask()).largest > 0;
        }))
        failUsage("The mask hides all of the exemplar; leave some of it to lay, at least {} px.",
                  settings.size);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size made = needsWhole(settings) ? request.size : request.part().size;
    const Settings ground = groundOf(request, settings);
    const Size exemplar = request.exemplars.front().image->size(), piece = pieceSize(exemplar, ground);
    const auto cells = [](int output, int side, int size) {
        return static_cast<double>(output) * partsOf(side, size) / side + 2;
    };
    const double columns = cells(request.size.width, exemplar.width, piece.width);
    const double rows = cells(request.size.height, exemplar.height, piece.height);
    const double overlap = overlapOf(request, settings);
    Estimate need;
    need.bytes =
        Canvas::bytesFor(made, request.channels(), settings.stitch == Stitch::Poisson) +
        static_cast<std::uint64_t>(columns * rows * 96 + 32.0 * (request.size.width + request.size.height) +
                                   (overlap > 0 ? 4 * columns * (request.size.height + rows * overlap) +
                                                      8 * rows * request.size.width +
                                                      8.0 * threads * overlap * request.size.longerSide()
                                                : 0)) +
        (4U << 20);
    if (needsWhole(settings) && request.region)
        need.bytes += Canvas::bytesFor(request.part().size, request.channels(), false);
    if (settings.stitch == Stitch::Poisson)
        need.bytes += levellingBytes(made, threads);
    const auto pixels = static_cast<double>(made.area());
    need.seconds = pixels * (5e-8 + request.channels() * 5e-9);
    if (settings.stitch == Stitch::Poisson)
        need.seconds += pixels * request.channels() * 1.2e-7;
    if (settings.pieces == Pieces::Chaos)
        need.seconds += pixels * 8e-8;
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const bool whole = needsWhole(settings), level = settings.stitch == Stitch::Poisson;
    const bool chaos = settings.pieces == Pieces::Chaos;
    const Region part = whole ? Region{0, 0, request.size} : request.part();
    const Settings ground = groundOf(request, settings);
    const int overlap = overlapOf(request, settings);
    // Memory comes first: no one waits for a large output's to be cleared once the work has begun.
    Canvas canvas(part.size, request, level);
    context.stage(0.1, TR("Shuffling pieces"));
    const Layout layout(request, ground, overlap / 2 + 1, context.random());
    Joints joints(layout, request,
                  std::min({overlap, layout.columns().shortest(), layout.rows().shortest()}));
    if (settings.stitch == Stitch::Cut)
        joints.cut(part, context);
    context.stage(chaos || level ? 0.3 : 0.9, TR("Laying pieces"));
    Layer(canvas, request, part, settings.stitch == Stitch::Feather).lay(layout, joints, context);
    int pieces = layout.columns().count() * layout.rows().count();
    if (chaos) {
        const Size cell{layout.columns().longest(), layout.rows().longest()};
        pieces += moveBlocks(canvas, request, settings, cell, level ? 0.2 : 0.6, context);
    }
    if (level)
        levelJoints(canvas, request, settings.reach * settings.size, chaos ? 0.4 : 0.6, context);
    Synthesis result = finished(canvas, request, settings, whole);
    result.figures = {{TR("Pieces"), static_cast<double>(pieces)}};
    addNotes(request, settings, layout, result);
    return result;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Random mosaic"),
     .summary = TR("Cuts the exemplars into pieces, shuffles them so that each is used once, and levels the "
                   "joints. Keeps large natural textures such as stone and metal from repeating; long "
                   "structures across pieces are lost."),
     .citation = "Raad, thesis 2016, section 5.6; Pérez, Gangnet & Blake, SIGGRAPH 2003; Xu, Guo & Shum, "
                 "MSR-TR-2000-32",
     .category = Category::Patches,
     .suits = {.grain = 2, .objects = 2, .large = 4},
     .takes = {ports::exemplars(), ports::mask()},
     .gives = {ports::inParts(ports::wrappingImage()), ports::map()}},
    {field(&Settings::pieces, "pieces", TR("Pieces"))
         .choices({{"columns", TR("Columns")},
                   {"rows", TR("Rows")},
                   {"both", TR("Both ways")},
                   {"chaos", TR("Chaos")}})
         .help(TR(
             "Slices keep what runs along them, as the grain of wood; pieces cut both ways suit what looks "
             "alike in all directions; chaos throws blocks over copies of the exemplar.")),
     field(&Settings::size, "size", TR("Piece size"))
         .range(8, 1024)
         .unit("px")
         .scaled(0.125)
         .help(TR("Side of a piece, or width of a slice: larger keeps larger structures whole, smaller makes "
                  "outputs differ more.")),
     field(&Settings::stitch, "stitch", TR("Stitch"))
         .choices({{"poisson", TR("Poisson")},
                   {"cut", TR("Minimum-error cut")},
                   {"feather", TR("Feather")},
                   {"none", TR("None")}})
         .help(TR(
             "Poisson levels the joints and keeps the detail; a cut copies every pixel as it is; feathering "
             "blurs where pieces overlap; none shows the pieces.")),
     field(&Settings::reach, "reach", TR("Levelling reach"))
         .range(0, 16)
         .when("stitch", std::string("poisson"))
         .group(TR("Advanced"))
         .help(TR("How far from a joint levels are drawn together, in sides of a piece: larger hides joints "
                  "over more of a piece, and lets shades drift; 0 levels without limit.")),
     field(&Settings::overlap, "overlap", TR("Overlap"))
         .range(0.02, 0.5)
         .group(TR("Advanced"))
         .help(TR("Share of a piece over which neighbours overlap, for cuts and feathering: larger joins "
                  "better.")),
     field(&Settings::turn, "turn", TR("Turn pieces"))
         .when("pieces", std::string("both"))
         .group(TR("Advanced"))
         .help(TR("Flips pieces and turns them by 180° at random: varies more, but light then comes from "
                  "several sides, also in companion normal maps."))},
    run, check, estimate);

} // namespace texloom::random_mosaic

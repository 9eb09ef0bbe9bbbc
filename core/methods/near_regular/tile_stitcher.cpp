#include "core/methods/near_regular/tile_stitcher.h"

#include "core/base/error.h"
#include "core/image/mirror.h"

#include <algorithm>
#include <cmath>

namespace texloom::near_regular {

namespace {

/// More tiles than this are not compared for one place; so many are drawn.
constexpr int kMostCandidates = 96;
/// A tile up to this much worse than the best may be drawn.
constexpr double kTileTolerance = 0.1;
/// The overlap of tiles, over their shorter side.
constexpr double kOverlapShare = 0.25;
constexpr int kLeastOverlap = 4;
/// The middle of a tile, over its sides, that is always the new one's.
constexpr double kCore = 0.5;
/// What a cut costs where the exemplar's tiles differ by their standard deviation, over what one costs where
/// two pixels do.
constexpr double kAmid = 0.5;
/// The largest difference of two pixels as a capacity.
constexpr double kFinestCapacity = 4096;

/// A vector that only gives a direction, made as long as a tile is to be.
Vec2 stretched(Vec2 vector, int length) {
    return alongRows(vector) ? (length / vector.length()) * vector : vector;
}

} // namespace

TileStitcher::TileStitcher(const Request& request, const Settings& settings, const Plan& plan,
                           JobContext& context)
    : m_request(request), m_settings(settings), m_plan(plan), m_context(context),
      m_deviation(phaseDeviation(plan.exemplar, plan.from)), m_image(request.size, request.channels()),
      m_map(request.size, request.exemplarSizes()),
      m_known(static_cast<std::size_t>(request.size.area()), 0) {
    shapeTiles();
    anchorTiles();
    allowWhole();
    double range = 0;
    for (int c = 0; c < plan.exemplar.channels; ++c) {
        const ValueRange of = valueRange(Image(plan.exemplar.channelRange(c, 1)));
        range += std::pow(static_cast<double>(of.largest - of.smallest), 2);
    }
    m_scale = range > 0 ? kFinestCapacity / std::sqrt(range) : 1;
}

void TileStitcher::shapeTiles() {
    m_shape = {stretched(m_plan.to.v1, m_plan.block), stretched(m_plan.to.v2, m_plan.block)};
    if (m_request.wrap.x || m_request.wrap.y)
        m_shape = wrapped(m_shape, m_request.size, m_request.wrap).lattice;
    m_least = {std::min({0.0, m_shape.v1.x, m_shape.v2.x, m_shape.v1.x + m_shape.v2.x}),
               std::min({0.0, m_shape.v1.y, m_shape.v2.y, m_shape.v1.y + m_shape.v2.y})};
    const Vec2 extent = m_shape.extent();
    const Size bare{static_cast<int>(std::ceil(extent.x)) + 1, static_cast<int>(std::ceil(extent.y)) + 1};
    const Size exemplar = m_plan.exemplar.size();
    const int room = std::min(exemplar.width - bare.width, exemplar.height - bare.height);
    if (room < 0)
        failUsage("The lattice's tile of {} × {} px does not fit into {} of {} × {} px; choose unit=blocks.",
                  bare.width, bare.height, m_request.exemplars.front().name, exemplar.width, exemplar.height);
    const int wanted =
        m_settings.border > 0
            ? m_settings.border
            : std::max(kLeastOverlap, static_cast<int>(std::lround(kOverlapShare * bare.shorterSide())));
    m_overlap = std::min(wanted, room);
    m_tile = {bare.width + m_overlap, bare.height + m_overlap};
    m_positions = {exemplar.width - m_tile.width + 1, exemplar.height - m_tile.height + 1};
}

/// Moves the tiles so that the middle of each at a lattice point looks like the place of the exemplar's tiles
/// that is most amid an element.
void TileStitcher::anchorTiles() {
    const Vec2 origin = m_plan.from.coordinates({m_settings.originX, m_settings.originY});
    const auto within = [](double at) { return at - std::floor(at); };
    const auto along = [&](Vec2 vector, double at) { return alongRows(vector) ? 0 : within(at); };
    m_anchor = m_shape.at(along(m_plan.to.v1, m_deviation.middle.x - origin.x - 0.5),
                          along(m_plan.to.v2, m_deviation.middle.y - origin.y - 0.5));
}

void TileStitcher::allowWhole() {
    if (m_plan.mask.data == nullptr)
        return;
    const PlaneView& mask = m_plan.mask;
    const auto stride = static_cast<std::size_t>(mask.width) + 1;
    std::vector<int> hidden(stride * (static_cast<std::size_t>(mask.height) + 1), 0); // above and left
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0, row = 0; x < mask.width; ++x) {
            row += mask(x, y) == 0 ? 1 : 0;
            const std::size_t i = static_cast<std::size_t>(y + 1) * stride + static_cast<std::size_t>(x + 1);
            hidden[i] = hidden[i - stride] + row;
        }
    for (int y = 0; y < m_positions.height; ++y)
        for (int x = 0; x < m_positions.width; ++x) {
            const std::size_t top = static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x);
            const std::size_t bottom = top + static_cast<std::size_t>(m_tile.height) * stride;
            const auto width = static_cast<std::size_t>(m_tile.width);
            const int count = hidden[bottom + width] - hidden[bottom] - hidden[top + width] + hidden[top];
            m_hidden.push_back(count > 0 ? 1 : 0);
        }
    if (std::find(m_hidden.begin(), m_hidden.end(), 0) == m_hidden.end())
        failUsage("The mask leaves no whole tile of {} × {} px to copy; mask less, or choose unit=blocks.",
                  m_tile.width, m_tile.height);
}

bool TileStitcher::allows(int x, int y) const {
    return x >= 0 && y >= 0 && x < m_positions.width && y < m_positions.height &&
           (m_hidden.empty() ||
            m_hidden[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_positions.width) +
                     static_cast<std::size_t>(x)] == 0);
}

/// Adds the place with these coordinates, doubled, if its rectangle touches the output; on an axis that wraps
/// each place but once.
void TileStitcher::addPlace(std::vector<Place>& all, int column, int row) const {
    const Vec2 corner = m_shape.at(0.5 * column, 0.5 * row) + m_anchor;
    const Vec2 start = corner + m_least - Vec2{0.5 * m_overlap, 0.5 * m_overlap};
    const Place place{static_cast<int>(std::lround(start.x)), static_cast<int>(std::lround(start.y)), column,
                      row, corner};
    const auto touches = [](int at, double from, int tile, int length, bool wraps) {
        constexpr double kRounding = 1e-6;
        return wraps ? from >= -kRounding && from < length - kRounding : at < length && at + tile > 0;
    };
    if (touches(place.x, corner.x, m_tile.width, m_request.size.width, m_request.wrap.x) &&
        touches(place.y, corner.y, m_tile.height, m_request.size.height, m_request.wrap.y))
        all.push_back(place);
}

/// In the order of the lattice, by turns at its points and half a period off.
std::vector<TileStitcher::Place> TileStitcher::places() const {
    double a0 = 0, a1 = 0, b0 = 0, b1 = 0;
    const double left = -m_tile.width, top = -m_tile.height;
    const double right = m_request.size.width + m_tile.width, bottom = m_request.size.height + m_tile.height;
    for (const Vec2 at : {Vec2{left, top}, Vec2{right, top}, Vec2{left, bottom}, Vec2{right, bottom}}) {
        const Vec2 c = m_shape.coordinates(at - m_anchor);
        a0 = std::min(a0, std::floor(c.x));
        a1 = std::max(a1, std::ceil(c.x));
        b0 = std::min(b0, std::floor(c.y));
        b1 = std::max(b1, std::ceil(c.y));
    }
    std::vector<Place> all;
    for (int b = static_cast<int>(b0); b <= static_cast<int>(b1); ++b)
        for (int a = static_cast<int>(a0); a <= static_cast<int>(a1); ++a)
            for (const int half : {0, 1})
                addPlace(all, 2 * a + half, 2 * b + half);
    return all;
}

/// The exemplar's whole tiles at the multiples of its vectors from the place that looks like the target.
std::vector<Point> TileStitcher::onLattice(Vec2 target) const {
    const double right = m_positions.width - 1, bottom = m_positions.height - 1;
    double a0 = HUGE_VAL, a1 = -HUGE_VAL, b0 = HUGE_VAL, b1 = -HUGE_VAL;
    for (const Vec2 at : {Vec2{0, 0}, Vec2{right, 0}, Vec2{0, bottom}, Vec2{right, bottom}}) {
        const Vec2 c = m_plan.from.coordinates(at - target);
        a0 = std::min(a0, c.x);
        a1 = std::max(a1, c.x);
        b0 = std::min(b0, c.y);
        b1 = std::max(b1, c.y);
    }
    std::vector<Point> points;
    for (double b = std::ceil(b0 - 1); b <= b1 + 1; ++b)
        for (double a = std::ceil(a0 - 1); a <= a1 + 1; ++a) {
            const Vec2 at = target + m_plan.from.at(a, b);
            const Point point{static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))};
            if (allows(point.x, point.y))
                points.push_back(point);
        }
    return points;
}

/// Where no whole tile lies on the lattice, the one nearest to it.
Point TileStitcher::nearestAllowed(Vec2 target) const {
    Point best;
    double least = HUGE_VAL;
    for (int y = 0; y < m_positions.height; ++y)
        for (int x = 0; x < m_positions.width; ++x) {
            if (!allows(x, y))
                continue;
            const Vec2 from = Vec2{static_cast<double>(x), static_cast<double>(y)} - target;
            const double off = (from - m_plan.from.nearest(from)).length();
            if (off < least) {
                least = off;
                best = {x, y};
            }
        }
    return best;
}

std::vector<Point> TileStitcher::candidates(const Place& place) const {
    // The lattices may differ, so that the tile is right at its middle.
    const Vec2 half{0.5 * m_tile.width, 0.5 * m_tile.height};
    const Vec2 c =
        m_plan.to.coordinates(Vec2{static_cast<double>(place.x), static_cast<double>(place.y)} + half);
    const Vec2 target = Vec2{m_settings.originX, m_settings.originY} + m_plan.from.at(c.x, c.y) - half;
    std::vector<Point> all = onLattice(target);
    if (all.empty())
        return {nearestAllowed(target)};
    if (all.size() <= kMostCandidates)
        return all;
    std::vector<Point> some;
    for (std::uint32_t i = 0; i < kMostCandidates; ++i)
        some.push_back(all[m_context.random().below(static_cast<std::uint32_t>(all.size()), place.column,
                                                    place.row, 1 + i)]);
    return some;
}

bool TileStitcher::settle(int& x, int& y) const {
    if (m_request.wrap.x)
        x = repeated(x, m_request.size.width);
    if (m_request.wrap.y)
        y = repeated(y, m_request.size.height);
    return x >= 0 && y >= 0 && x < m_request.size.width && y < m_request.size.height;
}

void TileStitcher::collect(const Place& place) {
    m_pixels.assign(static_cast<std::size_t>(m_tile.area()), {});
    m_overlapped.clear();
    const Size whole = m_request.size;
    for (int v = 0; v < m_tile.height; ++v)
        for (int u = 0; u < m_tile.width; ++u) {
            Pixel& pixel = m_pixels[indexOf(u, v)];
            pixel.x = place.x + u;
            pixel.y = place.y + v;
            // A rectangle larger than an output that wraps would meet itself.
            const bool twice =
                (m_request.wrap.x && u >= whole.width) || (m_request.wrap.y && v >= whole.height);
            pixel.inside = settle(pixel.x, pixel.y) && !twice;
            pixel.known = pixel.inside &&
                          m_known[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(whole.width) +
                                  static_cast<std::size_t>(pixel.x)] != 0;
            if (pixel.known)
                m_overlapped.push_back({u, v});
        }
}

const TileStitcher::Pixel* TileStitcher::at(int u, int v) const {
    const bool in = u >= 0 && v >= 0 && u < m_tile.width && v < m_tile.height;
    return in ? &m_pixels[indexOf(u, v)] : nullptr;
}

/// How badly a tile fits what is known: the mean square of the differences, or 1 − γ.
double TileStitcher::error(Point patch) const {
    if (m_settings.match == Match::Correlation)
        return 1 - correlation(patch);
    double sum = 0;
    for (const Point& p : m_overlapped) {
        const Pixel& pixel = *at(p.x, p.y);
        for (int c = 0; c < m_image.channels(); ++c) {
            const double difference = static_cast<double>(m_image(pixel.x, pixel.y, c)) -
                                      static_cast<double>(m_plan.exemplar(patch.x + p.x, patch.y + p.y, c));
            sum += difference * difference;
        }
    }
    return sum;
}

/// γ of the overlap, with the means of its pixels.
double TileStitcher::correlation(Point patch) const {
    const auto count = static_cast<double>(m_overlapped.size());
    double products = 0, spreads = 0;
    for (int c = 0; c < m_image.channels(); ++c) {
        double f = 0, g = 0, ff = 0, gg = 0, fg = 0;
        for (const Point& p : m_overlapped) {
            const Pixel& pixel = *at(p.x, p.y);
            const auto one = static_cast<double>(m_image(pixel.x, pixel.y, c));
            const auto two = static_cast<double>(m_plan.exemplar(patch.x + p.x, patch.y + p.y, c));
            f += one;
            g += two;
            ff += one * one;
            gg += two * two;
            fg += one * two;
        }
        products += count * fg - f * g;
        spreads += std::sqrt(std::max(0.0, count * ff - f * f) * std::max(0.0, count * gg - g * g));
    }
    return spreads > 0 ? products / spreads : 0;
}

Point TileStitcher::chosen(const Place& place) {
    const std::vector<Point> all = candidates(place);
    std::vector<double> errors(all.size(), 0.0);
    if (!m_overlapped.empty())
        m_context.parallel(0, static_cast<int>(all.size()), [&](int i) {
            errors[static_cast<std::size_t>(i)] = error(all[static_cast<std::size_t>(i)]);
        });
    const double limit = (1 + kTileTolerance) * *std::min_element(errors.begin(), errors.end());
    std::vector<Point> good;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (errors[i] <= limit)
            good.push_back(all[i]);
    const Point drawn =
        good[m_context.random().below(static_cast<std::uint32_t>(good.size()), place.column, place.row, 0)];
    return m_overlapped.empty() ? drawn : registered(drawn);
}

/// The tile moved by up to the tolerance to where it correlates best; not at all if no place is better.
Point TileStitcher::registered(Point patch) const {
    Point best = patch;
    double most = correlation(patch);
    const int reach = m_settings.tolerance;
    for (int dy = -reach; dy <= reach; ++dy) {
        m_context.check();
        for (int dx = -reach; dx <= reach; ++dx) {
            const Point moved{patch.x + dx, patch.y + dy};
            if (!allows(moved.x, moved.y))
                continue;
            if (const double value = correlation(moved); value > most) {
                most = value;
                best = moved;
            }
        }
    }
    return best;
}

/// What a seam at a known pixel costs: its difference from the tile's, and more amid elements of the texture
/// than in their joints.
std::int32_t TileStitcher::cost(const Pixel& pixel, int u, int v, Point patch) const {
    double sum = 0;
    for (int c = 0; c < m_image.channels(); ++c) {
        const double difference = static_cast<double>(m_image(pixel.x, pixel.y, c)) -
                                  static_cast<double>(m_plan.exemplar(patch.x + u, patch.y + v, c));
        sum += difference * difference;
    }
    const auto amid = static_cast<double>(m_deviation.at(patch.x + u, patch.y + v, 0));
    return static_cast<std::int32_t>(std::lround(m_scale * (std::sqrt(sum) + kAmid * amid)));
}

/// Where the rectangle ends amid what is known, that stays; beside what only the tile covers, and in the
/// middle of tiles at lattice points, the tile is taken. Those half a period off lie across joints, where
/// only what is missing must come from them.
void TileStitcher::tie(const Place& place, int u, int v, GridFlow& flow) const {
    const Pixel& pixel = *at(u, v);
    bool old = false, fresh = false;
    for (const auto& [du, dv] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
        const Pixel* const next = at(u + du, v + dv);
        if (next && next->inside) {
            fresh = fresh || !next->known;
            continue;
        }
        int x = place.x + u + du, y = place.y + v + dv;
        old = old || (settle(x, y) &&
                      m_known[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_request.size.width) +
                              static_cast<std::size_t>(x)] != 0);
    }
    const Vec2 c = m_shape.coordinates(Vec2{place.x + u + 0.5, place.y + v + 0.5} - place.corner -
                                       0.5 * (m_shape.v1 + m_shape.v2));
    const bool onPoint = place.column % 2 == 0;
    fresh = fresh || (onPoint && std::abs(c.x) <= 0.5 * kCore && std::abs(c.y) <= 0.5 * kCore);
    if (old)
        flow.tieToFirst(pixel.node, GridFlow::kForbidden);
    if (fresh)
        flow.tieToSecond(pixel.node, GridFlow::kForbidden);
}

/// The first terminal stands for what is there, the second for the tile.
GridFlow TileStitcher::graph(const Place& place, Point patch) const {
    GridFlow flow(m_overlapped.size());
    for (std::size_t i = 0; i < m_overlapped.size(); ++i)
        flow.add();
    for (const Point& p : m_overlapped) {
        const Pixel& pixel = *at(p.x, p.y);
        const std::int32_t own = cost(pixel, p.x, p.y, patch);
        const Pixel* const right = at(p.x + 1, p.y);
        const Pixel* const down = at(p.x, p.y + 1);
        if (right && right->known) {
            const std::int32_t both = 1 + own + cost(*right, p.x + 1, p.y, patch);
            flow.link(pixel.node, GridFlow::Right, right->node, both, both);
        }
        if (down && down->known) {
            const std::int32_t both = 1 + own + cost(*down, p.x, p.y + 1, patch);
            flow.link(pixel.node, GridFlow::Down, down->node, both, both);
        }
        tie(place, p.x, p.y, flow);
    }
    return flow;
}

void TileStitcher::paste(const Place& place, Point patch) {
    int nodes = 0;
    for (const Point& p : m_overlapped)
        m_pixels[indexOf(p.x, p.y)].node = nodes++;
    GridFlow flow = graph(place, patch);
    flow.solve([&] { m_context.check(); });
    for (int v = 0; v < m_tile.height; ++v)
        for (int u = 0; u < m_tile.width; ++u) {
            const Pixel& pixel = *at(u, v);
            if (!pixel.inside || (pixel.known && flow.first(pixel.node)))
                continue;
            m_known[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(m_request.size.width) +
                    static_cast<std::size_t>(pixel.x)] = 1;
            m_map.at(pixel.x, pixel.y) = {static_cast<std::uint16_t>(patch.x + u),
                                          static_cast<std::uint16_t>(patch.y + v), 0};
            for (int c = 0; c < m_image.channels(); ++c)
                m_image(pixel.x, pixel.y, c) = m_plan.exemplar(patch.x + u, patch.y + v, c);
        }
}

void TileStitcher::fill(Synthesis& result, double weight) {
    m_context.stage(weight, TR("Stitching tiles"));
    const std::vector<Place> all = places();
    for (std::size_t i = 0; i < all.size(); ++i) {
        collect(all[i]);
        paste(all[i], chosen(all[i]));
        m_context.progress((static_cast<double>(i) + 1) / static_cast<double>(all.size()));
        m_context.preview(m_image, &m_map);
    }
    const Region part = m_request.part();
    result.image = Image(m_image.view().crop(part.x, part.y, part.size));
    result.map = PositionMap(part.size, m_request.exemplarSizes());
    for (int y = 0; y < part.size.height; ++y)
        for (int x = 0; x < part.size.width; ++x)
            result.map.at(x, y) = m_map.at(part.x + x, part.y + y);
    result.figures.push_back({TR("Tile with overlap, width"), static_cast<double>(m_tile.width)});
    result.figures.push_back({TR("Tile with overlap, height"), static_cast<double>(m_tile.height)});
    result.figures.push_back({TR("Tiles stitched"), static_cast<double>(all.size())});
}

std::uint64_t TileStitcher::bytesFor(Size output, Size exemplar, int channels) {
    const auto pixels = static_cast<std::uint64_t>(exemplar.area());
    return Image::bytesFor(output, channels) + PositionMap::bytesFor(output) +
           static_cast<std::uint64_t>(output.area()) +
           pixels * (sizeof(Pixel) + 4 * sizeof(Point) + 1 + sizeof(int)) + GridFlow::bytesFor(pixels) +
           2 * Image::bytesFor(exemplar, 1) + pixels * 10 * sizeof(double) +
           static_cast<std::uint64_t>(output.area()) / 16 * sizeof(Place);
}

} // namespace texloom::near_regular

#include "core/methods/wang_tiles/edge_tiles.h"

#include "core/base/at.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace texloom::wang_tiles {

namespace {

/// The parts of a tile, by the edge whose sample they show.
enum Part { North, East, South, West };

constexpr double kUnreachable = std::numeric_limits<double>::infinity();

/// Tiles that are too small for cuts show the sample above.
constexpr int kLeastSide = 3;

} // namespace

EdgeTiles::EdgeTiles(const Request& request, const Settings& settings, Samples samples, Size size,
                     const std::vector<Colours>& tiles, JobContext& context)
    : m_request(request), m_colours(settings.colours), m_reach(reachOf(settings)),
      m_zone(0.5 * zoneOf(settings) / settings.tile), m_samples(std::move(samples)), m_size(size) {
    m_cuts.resize(indexOf({m_colours - 1, m_colours - 1, m_colours - 1, m_colours - 1}) + 1);
    context.parallel(0, static_cast<int>(tiles.size()), [&](int i) {
        const Colours& one = tiles[static_cast<std::size_t>(i)];
        Cuts& cuts = m_cuts[indexOf(one)];
        if (m_size.shorterSide() < kLeastSide)
            return;
        Path falling = cut(one, false);
        context.check();
        Path rising = cut(one, true);
        cuts.error = (falling.cost + rising.cost) / (falling.length + rising.length);
        cuts.falling = std::move(falling.first);
        cuts.rising = std::move(rising.first);
    });
    for (const Cuts& cuts : m_cuts)
        m_worstError = std::max(m_worstError, cuts.error);
}

std::size_t EdgeTiles::indexOf(const Colours& colours) const {
    std::size_t index = 0;
    for (const int colour : {colours.north, colours.east, colours.south, colours.west})
        index = index * static_cast<std::size_t>(m_colours) + static_cast<std::size_t>(colour);
    return index;
}

/// The pixel of one of the four samples. Tiles much narrower than high, or the other way round, have cuts
/// that reach deeper than samples do: there a sample goes on as it ends.
Source EdgeTiles::sampled(const Colours& colours, int part, int x, int y) const {
    const auto from = [last = 2 * m_reach - 1](const PatchPosition& sample, int dx, int dy) {
        return Source{static_cast<std::uint16_t>(sample.x + std::clamp(dx, 0, last)),
                      static_cast<std::uint16_t>(sample.y + std::clamp(dy, 0, last)),
                      static_cast<std::uint16_t>(sample.exemplar)};
    };
    const auto across = [&](int colour) { return m_samples[at(2 * colour)]; };
    const auto upright = [&](int colour) { return m_samples[at(2 * colour + 1)]; };
    switch (part) {
    case North:
        return from(across(colours.north), x, m_reach + y);
    case South:
        return from(across(colours.south), x, m_reach + y - m_size.height);
    case West:
        return from(upright(colours.west), m_reach + x, y);
    default:
        return from(upright(colours.east), m_reach + x - m_size.width, y);
    }
}

/// The path of least error from one corner to the opposite, by steps aside and down, near the diagonal. It
/// keeps off the tile's left and lower border, so that these stay their samples'. The rising diagonal is the
/// falling one of the tile as seen in a mirror.
EdgeTiles::Path EdgeTiles::cut(const Colours& colours, bool rising) const {
    const int width = m_size.width, height = m_size.height, right = width - 1, bottom = height - 1;
    const double zone = std::max(m_zone, 1.5 / m_size.shorterSide());
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    std::vector<double> sums(static_cast<std::size_t>(m_size.area()), kUnreachable);
    const auto sum = [&](int x, int y) { return x < 0 || y < 0 ? kUnreachable : sums[index(x, y)]; };
    for (int y = 0; y < height; ++y) {
        const double alongY = static_cast<double>(y) / bottom;
        const int first = std::max(0, static_cast<int>(std::ceil((alongY - zone) * right)));
        const int last = std::min(right, static_cast<int>(std::floor((alongY + zone) * right)));
        for (int x = first; x <= last; ++x) {
            const bool corner = (x == 0 && y == 0) || (x == right && y == bottom);
            if (!corner && (x == 0 || y == bottom))
                continue;
            const double before = x + y == 0 ? 0 : std::min(sum(x - 1, y), sum(x, y - 1));
            if (before == kUnreachable)
                continue;
            const int at = rising ? right - x : x;
            const bool upper = static_cast<double>(x) / right + alongY < 1;
            const int one = upper ? North : rising ? West : East;
            const int two = upper ? (rising ? East : West) : South;
            sums[index(x, y)] = before + squaredDifference(m_request, sampled(colours, one, at, y),
                                                           sampled(colours, two, at, y));
        }
    }
    Path path{std::vector<int>(static_cast<std::size_t>(height), width), sums[index(right, bottom)], 0};
    for (int x = right, y = bottom;;) {
        path.first[static_cast<std::size_t>(y)] = std::min(path.first[static_cast<std::size_t>(y)], x);
        ++path.length;
        if (x + y == 0)
            return path;
        if (sum(x - 1, y) <= sum(x, y - 1))
            --x;
        else
            --y;
    }
}

Source EdgeTiles::source(const Colours& colours, int x, int y) const {
    const Cuts& cuts = m_cuts[indexOf(colours)];
    if (cuts.falling.empty())
        return sampled(colours, North, x, y);
    const bool aboveFalling = x >= cuts.falling[static_cast<std::size_t>(y)];
    const bool aboveRising = m_size.width - 1 - x >= cuts.rising[static_cast<std::size_t>(y)];
    if (aboveFalling)
        return sampled(colours, aboveRising ? North : East, x, y);
    return sampled(colours, aboveRising ? West : South, x, y);
}

std::uint64_t EdgeTiles::bytesFor(const Settings& settings) {
    const auto tiles = static_cast<std::uint64_t>(std::pow(settings.colours, 4));
    return tiles * (sizeof(Cuts) + 2 * static_cast<std::uint64_t>(settings.tile) * sizeof(int) + 64);
}

} // namespace texloom::wang_tiles

#include "core/methods/wang_tiles/interiors.h"

#include "core/base/at.h"
#include "core/methods/cut_canvas.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace texloom::wang_tiles {

namespace {

/// Places that are tried for a tile: those that fit best are cut out, and the cheapest seams are kept.
constexpr int kChoices = 4;
/// Tiles with a side of fewer pixels are border alone.
constexpr int kLeastInside = 3;
/// Stream of random numbers, at the places of samples, which the numbers of tilings are not drawn at.
constexpr std::uint32_t kInterior = 6;

/// How far patches keep from those of other tiles: so far that they take up a quarter of all places.
int distanceApart(Size positions, int tiles, int tile) {
    const double each = static_cast<double>(positions.area()) / (tiles + 4);
    return std::min(tile / 4, static_cast<int>(std::sqrt(each) / 4));
}

} // namespace

Interiors::Interiors(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context), m_cost(request, true) {
    for (const PatchSource& source : patchSources(request))
        m_distances.emplace_back(source, settings.tile, [&] { context.check(); });
}

/// The exemplar of a tile's inside: by weight, and by the places that it has.
std::size_t Interiors::drawnExemplar(int tile) const {
    std::vector<double> sums;
    double sum = 0;
    for (std::size_t e = 0; e < m_distances.size(); ++e) {
        sum += static_cast<double>(m_distances[e].allowed()) * m_request.exemplars[e].weight;
        sums.push_back(sum);
    }
    const double wanted = m_context.random().uniform(-1, tile, kInterior) * sum;
    const auto found = std::upper_bound(sums.begin(), sums.end(), wanted);
    return found == sums.end() ? sums.size() - 1 : static_cast<std::size_t>(found - sums.begin());
}

/// Where patches would begin that go on as one of the samples does: they would show it once more.
std::vector<PatchPosition> Interiors::continued(const CornerTiles& border, const Colours& colours) const {
    const int reach = reachOf(m_settings), side = m_settings.tile;
    const auto at = [&](int colour, int dx, int dy) {
        const PatchPosition& sample = border.samples()[static_cast<std::size_t>(colour)];
        return PatchPosition{sample.exemplar, sample.x + reach - dx, sample.y + reach - dy};
    };
    return {at(colours.north, 0, 0), at(colours.east, side, 0), at(colours.south, side, side),
            at(colours.west, 0, side)};
}

std::vector<PatchPosition> Interiors::bestPlaces(const CornerTiles& border, const Colours& colours,
                                                 std::size_t exemplar,
                                                 const std::vector<PatchPosition>& avoided) const {
    const int side = m_settings.tile, depth = border.depth();
    Image known({side, side}, m_request.channels()), counts({side, side}, 1);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (std::min({x, y, side - 1 - x, side - 1 - y}) >= depth)
                continue;
            const Source source = border.source(colours, x, y);
            counts(x, y, 0) = 1;
            for (int c = 0; c < known.channels(); ++c)
                known(x, y, c) = (*m_request.exemplars[source.exemplar].image)(source.x, source.y, c);
        }
    const MaskedDistances& distances = m_distances[exemplar];
    const Size positions = distances.positions();
    std::vector<float> all;
    distances.compute(known.view(), counts.view().plane(0), all, [this] { m_context.check(); });
    constexpr float kNever = std::numeric_limits<float>::infinity();
    const auto shun = [&](std::vector<float>& from, const PatchPosition& place, int reach) {
        for (int y = std::max(0, place.y - reach); y <= std::min(positions.height - 1, place.y + reach); ++y)
            for (int x = std::max(0, place.x - reach); x <= std::min(positions.width - 1, place.x + reach);
                 ++x)
                from[at(y * positions.width + x)] = kNever;
    };
    std::vector<float> free = all;
    const int apart = distanceApart(positions, static_cast<int>(coloursOf(m_settings).size()), side);
    for (const PatchPosition& place : avoided)
        if (place.exemplar == static_cast<int>(exemplar))
            shun(free, place, apart);
    std::vector<PatchPosition> best;
    for (int n = 0; n < kChoices; ++n) {
        const std::vector<float>& from =
            n == 0 && *std::min_element(free.begin(), free.end()) == kNever ? all : free;
        const auto least = std::min_element(from.begin(), from.end());
        if (*least == kNever)
            break;
        const int index = static_cast<int>(least - from.begin());
        best.push_back({static_cast<int>(exemplar), index % positions.width, index / positions.width});
        shun(free, best.back(), depth);
    }
    return best;
}

Interiors::Covered Interiors::covered(const CornerTiles& border, const Colours& colours,
                                      const PatchPosition& patch) const {
    const Size size = border.size();
    Request tile;
    tile.exemplars = m_request.exemplars;
    tile.size = size;
    graph_cut::Canvas canvas(tile, m_cost);
    const bool whole = size.shorterSide() >= kLeastInside;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (!whole || std::min({x, y, size.width - 1 - x, size.height - 1 - y}) < border.depth())
                canvas.map().at(x, y) = border.source(colours, x, y);
    Covered result;
    if (whole) {
        const int left = patch.x + (m_settings.tile - size.width) / 2;
        const int top = patch.y + (m_settings.tile - size.height) / 2;
        canvas.paste({patch.exemplar, -left, -top, {1, 1, {size.width - 2, size.height - 2}}}, nullptr,
                     m_context);
        result.cost = std::llround(1000 * canvas.totalCost(m_context));
    }
    result.sources.reserve(static_cast<std::size_t>(size.area()));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            result.sources.push_back(canvas.map().at(x, y));
    return result;
}

void Interiors::find(const CornerTiles& border, const std::vector<Colours>& tiles) {
    m_places.clear();
    for (const Colours& colours : tiles) {
        const auto tile = static_cast<int>(m_places.size());
        std::vector<PatchPosition> avoided = continued(border, colours);
        avoided.insert(avoided.end(), m_places.begin(), m_places.end());
        const std::vector<PatchPosition> places = bestPlaces(border, colours, drawnExemplar(tile), avoided);
        std::vector<std::int64_t> costs(places.size());
        m_context.parallel(0, static_cast<int>(places.size()),
                           [&](int i) { costs[at(i)] = covered(border, colours, places[at(i)]).cost; });
        m_places.push_back(
            places[static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin())]);
        m_context.progress(static_cast<double>(tile + 1) / static_cast<double>(tiles.size()));
    }
}

TileSet Interiors::cover(const CornerTiles& border, const std::vector<Colours>& tiles) const {
    std::vector<std::vector<Source>> all(tiles.size());
    m_context.parallel(0, static_cast<int>(tiles.size()),
                       [&](int i) { all[at(i)] = covered(border, tiles[at(i)], m_places[at(i)]).sources; });
    TileSet set(m_settings.colours, border.size());
    for (std::size_t i = 0; i < tiles.size(); ++i)
        set.add(tiles[i], std::move(all[i]));
    return set;
}

std::uint64_t Interiors::bytesFor(const Request& request, const Settings& settings, int threads) {
    std::uint64_t bytes = 0;
    for (const Size& size : request.exemplarSizes())
        bytes += MaskedDistances::bytesFor(size, request.channels()) +
                 3 * sizeof(float) * static_cast<std::uint64_t>(size.area());
    const Size tile{settings.tile, settings.tile};
    return bytes + Image::bytesFor(tile, request.channels() + 1) +
           static_cast<std::uint64_t>(threads + 1) *
               graph_cut::Canvas::bytesFor(tile, tile, request.channels());
}

} // namespace texloom::wang_tiles

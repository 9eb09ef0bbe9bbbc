#include "core/match/grid_match.h"

#include "core/match/patch_use.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace texloom {

namespace {

/// Longest side of the tiles that one thread scans at a time, in patches.
constexpr int kGridTile = 32;

/// Tiles along one axis: 1 or an even number, so that neighbours differ in colour across the border too.
int tilesAlong(int patches) {
    return patches <= kGridTile ? 1 : (patches + 2 * kGridTile - 1) / (2 * kGridTile) * 2;
}

int floatsPerPixel(int channels) {
    return Interleaved({1, 1}, channels).pixel;
}

} // namespace

GridMatcher::GridMatcher(std::span<const PatchSource> sources, const PatchLattice& lattice,
                         JobContext& context)
    : m_lattice(lattice), m_tiles{tilesAlong(lattice.count().width), tilesAlong(lattice.count().height)},
      m_channels(sources.front().image.channels), m_context(context) {
    for (const PatchSource& source : sources) {
        m_targets.emplace_back(source, lattice.patch);
        m_count += m_targets.back().count();
        context.check();
    }
}

Source GridMatcher::any(int x, int y) const {
    auto n = static_cast<std::int64_t>(m_context.random().uniform(x, y) * static_cast<double>(m_count));
    std::uint16_t exemplar = 0;
    for (; n >= m_targets[exemplar].count(); ++exemplar)
        n -= m_targets[exemplar].count();
    return m_targets[exemplar].nth(n, exemplar);
}

Source GridMatcher::allowed(const Source& source, int x, int y) const {
    return m_targets[source.exemplar].has(source.x, source.y) ? source : any(x, y);
}

void GridMatcher::discourage(const PatchField& field, double weight) {
    const auto unit = static_cast<float>(weight * field.meanDistance());
    if (unit <= 0)
        return m_penalties.clear();
    std::vector<Size> sizes;
    for (const PatchTarget& target : m_targets)
        sizes.push_back(target.pixels().size);
    const bool fresh = m_penalties.empty();
    m_penalties.resize(m_targets.size());
    for (int e = 0; e < exemplars(); ++e) {
        std::vector<float> use = patchUse(field, sizes, e, m_lattice.patch, [this] { m_context.check(); });
        std::vector<float>& penalties = m_penalties[static_cast<std::size_t>(e)];
        for (std::size_t i = 0; i < use.size(); ++i)
            use[i] = fresh ? unit * use[i] : 0.5F * (unit * use[i] + penalties[i]);
        penalties = std::move(use);
    }
}

float GridMatcher::penalty(const Source& source) const {
    if (m_penalties.empty())
        return 0;
    const auto width = static_cast<std::size_t>(m_targets[source.exemplar].positions().width);
    return m_penalties[source.exemplar][source.y * width + source.x];
}

GridMatcher::Tile GridMatcher::tile(int number) const {
    const Size count = m_lattice.count();
    const int column = number % m_tiles.width, row = number / m_tiles.width;
    return {count.width * column / m_tiles.width, count.height * row / m_tiles.height,
            count.width * (column + 1) / m_tiles.width, count.height * (row + 1) / m_tiles.height};
}

void GridMatcher::improve(PatchField& field, const Gather& gather, int round, int radius) {
    const int tiles = static_cast<int>(m_tiles.area());
    for (int color = 0; color < 2; ++color)
        m_context.parallel(0, tiles, [&](int number) {
            if ((number % m_tiles.width + number / m_tiles.width) % 2 == color)
                improveTile(field, gather, number, round, radius);
        });
}

bool GridMatcher::anyWanted(const Tile& area) const {
    for (int y = area.top; y < area.bottom; ++y)
        for (int x = area.left; x < area.right; ++x)
            if (wanted(x, y))
                return true;
    return false;
}

void GridMatcher::improveTile(PatchField& field, const Gather& gather, int number, int round, int radius) {
    const Tile area = tile(number);
    if (!anyWanted(area))
        return;
    const int columns = area.right - area.left, rows = area.bottom - area.top;
    const int side = (kGridTile - 1) * m_lattice.stride + m_lattice.patch;
    const auto pixels = m_pool.borrow([&] { return Interleaved({side, side}, m_channels); });
    gather(
        area.left * m_lattice.stride, area.top * m_lattice.stride,
        {(columns - 1) * m_lattice.stride + m_lattice.patch, (rows - 1) * m_lattice.stride + m_lattice.patch},
        *pixels);
    const int step = round % 2 == 0 ? 1 : -1;
    for (int j = 0; j < rows; ++j) {
        m_context.check();
        for (int i = 0; i < columns; ++i) {
            const int x = step > 0 ? area.left + i : area.right - 1 - i;
            const int y = step > 0 ? area.top + j : area.bottom - 1 - j;
            if (!wanted(x, y))
                continue;
            improvePatch(field, x, y,
                         pixels->at((x - area.left) * m_lattice.stride, (y - area.top) * m_lattice.stride),
                         pixels->stride(), round, radius);
        }
    }
}

void GridMatcher::improvePatch(PatchField& field, int x, int y, const float* patch, std::ptrdiff_t stride,
                               int round, int radius) const {
    PatchMatch best{field.at(x, y).source, HUGE_VALF};
    float cost = HUGE_VALF;
    const auto far = [&](const PatchTarget& target, int toX, int toY) {
        return m_limit.radius > 0 && target.pixels().size == m_lattice.canvas &&
               (std::abs(toX - x * m_lattice.stride) > m_limit.radius ||
                std::abs(toY - y * m_lattice.stride) > m_limit.radius);
    };
    const auto attempt = [&](std::uint16_t exemplar, int toX, int toY) {
        // Neighbours that are left out have no match.
        if (exemplar == Source::kNone)
            return;
        const PatchTarget& target = m_targets[exemplar];
        if (!target.has(toX, toY) || far(target, toX, toY))
            return;
        const Source source{static_cast<std::uint16_t>(toX), static_cast<std::uint16_t>(toY), exemplar};
        if (source == best.source && cost < HUGE_VALF)
            return;
        const float extra = penalty(source);
        if (extra >= cost)
            return;
        const Interleaved& pixels = target.pixels();
        const float found = squaredDistance(patch, stride, pixels.at(toX, toY), pixels.stride(),
                                            m_lattice.patch, m_lattice.patch * pixels.pixel, cost - extra);
        if (found + extra < cost) {
            best = {source, found};
            cost = found + extra;
        }
    };
    attempt(best.source.exemplar, best.source.x, best.source.y);
    const Size count = field.size();
    const int step = m_lattice.stride;
    const Source left = field.at((x + count.width - 1) % count.width, y).source;
    const Source right = field.at((x + 1) % count.width, y).source;
    const Source above = field.at(x, (y + count.height - 1) % count.height).source;
    const Source below = field.at(x, (y + 1) % count.height).source;
    attempt(left.exemplar, left.x + step, left.y);
    attempt(above.exemplar, above.x, above.y + step);
    attempt(right.exemplar, right.x - step, right.y);
    attempt(below.exemplar, below.x, below.y - step);
    QuickRandom random(m_context.random().bits(x, y, static_cast<std::uint32_t>(round) + 1));
    for (int reach = std::min(radius, m_targets[best.source.exemplar].longerSide()); reach >= 1; reach /= 2) {
        const int toX = best.source.x + random.within(reach);
        attempt(best.source.exemplar, toX, best.source.y + random.within(reach));
    }
    field.at(x, y) = best;
}

std::uint64_t GridMatcher::bytesFor(std::span<const Size> exemplars, int channels, int patch, int stride,
                                    int threads) {
    const auto pixel = static_cast<std::uint64_t>(floatsPerPixel(channels)) * sizeof(float);
    const int pixels = (kGridTile - 1) * stride + patch;
    const auto side = static_cast<std::uint64_t>(pixels);
    std::uint64_t bytes = static_cast<std::uint64_t>(threads) * side * side * pixel;
    for (const Size& size : exemplars)
        bytes += static_cast<std::uint64_t>(size.area()) * (pixel + 32);
    return bytes;
}

} // namespace texloom

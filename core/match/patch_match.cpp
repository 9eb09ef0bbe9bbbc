#include "core/match/patch_match.h"

#include "core/job/pool.h"
#include "core/match/interleaved.h"
#include "core/match/patch_target.h"
#include "core/match/patch_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace texloom {

namespace {

/// Side of the tiles that one thread scans at a time.
constexpr int kTile = 64;
/// Leaves of the tree searched for a start, unless an identical patch is found.
constexpr int kLeaves = 4;

class Matcher {
public:
    Matcher(const ImageView& query, std::span<const PatchSource> sources, const PatchMatchOptions& options,
            JobContext& context)
        : m_query(query), m_patch(options.patch), m_iterations(options.iterations),
          m_startStep(options.startStep), m_context(context),
          m_field({options.wrap.x ? query.width : query.width - options.patch + 1,
                   options.wrap.y ? query.height : query.height - options.patch + 1}),
          m_tiles{(m_field.size().width + kTile - 1) / kTile, (m_field.size().height + kTile - 1) / kTile} {
        for (const PatchSource& source : sources) {
            m_targets.emplace_back(source, options.patch);
            m_count += m_targets.back().count();
            context.check();
        }
        std::vector<const Interleaved*> images;
        for (const PatchTarget& target : m_targets)
            images.push_back(&target.pixels());
        m_tree.emplace(
            images, query.channels, m_patch,
            [this](const Source& source) { return m_targets[source.exemplar].has(source.x, source.y); },
            [&context] { context.check(); });
    }

    PatchField run() {
        const int tiles = static_cast<int>(m_tiles.area());
        m_context.parallel(0, tiles, [this](int tile) { start(tile); });
        for (int iteration = 0; iteration < m_iterations; ++iteration)
            for (int color = 0; color < 2; ++color) {
                m_context.parallel(0, tiles, [&](int tile) {
                    if ((tile % m_tiles.width + tile / m_tiles.width) % 2 == color)
                        improve(tile, iteration);
                });
                m_context.progress((iteration + 0.5 * (color + 1)) / m_iterations);
            }
        return std::move(m_field);
    }

private:
    /// A tile with the part of the query that its patches cover.
    struct Tile {
        int left, top, right, bottom; ///< of the field; right and bottom excluded
    };

    Tile tile(int number) const {
        const int left = number % m_tiles.width * kTile, top = number / m_tiles.width * kTile;
        return {left, top, std::min(left + kTile, m_field.size().width),
                std::min(top + kTile, m_field.size().height)};
    }

    Pool<Interleaved>::Loan pixelsOf(const Tile& tile) {
        const int margin = m_patch - 1;
        auto pixels = m_pool.borrow([&] {
            return Interleaved({kTile + margin, kTile + margin}, m_query.channels);
        });
        pixels->load(m_query, tile.left, tile.top,
                     {tile.right - tile.left + margin, tile.bottom - tile.top + margin});
        return pixels;
    }

    float distance(const float* patch, std::ptrdiff_t stride, const Source& source, float limit) const {
        const Interleaved& pixels = m_targets[source.exemplar].pixels();
        return squaredDistance(patch, stride, pixels.at(source.x, source.y), pixels.stride(), m_patch,
                               m_patch * pixels.pixel, limit);
    }

    Source anySource(int x, int y) const {
        auto n =
            static_cast<std::int64_t>(m_context.random().uniform(x, y, 0) * static_cast<double>(m_count));
        std::uint16_t exemplar = 0;
        for (; n >= m_targets[exemplar].count(); ++exemplar)
            n -= m_targets[exemplar].count();
        return m_targets[exemplar].nth(n, exemplar);
    }

    /// The tree is searched for one patch in each square of m_startStep; the others start next to the match
    /// of the one before.
    void start(int number) {
        const Tile area = tile(number);
        const auto pixels = pixelsOf(area);
        for (int y = area.top; y < area.bottom; ++y)
            for (int x = area.left; x < area.right; ++x) {
                const int dx = (x - area.left) % m_startStep, dy = (y - area.top) % m_startStep;
                const float* patch = pixels->at(x - area.left, y - area.top);
                m_field.at(x, y) = dx == 0 && dy == 0 ? lookedUp(x, y, patch, pixels->stride())
                                                      : beside(m_field.at(x - dx, y - dy).source, dx, dy,
                                                               patch, pixels->stride());
            }
    }

    PatchMatch lookedUp(int x, int y, const float* patch, std::ptrdiff_t stride) const {
        PatchMatch best{anySource(x, y), HUGE_VALF};
        PatchTree::Lookup lookup(*m_tree, patch, stride);
        for (int leaf = 0; leaf < kLeaves && best.distance > 0; ++leaf)
            for (const Source& source : lookup.next()) {
                const float found = distance(patch, stride, source, best.distance);
                if (found < best.distance)
                    best = {source, found};
            }
        if (best.distance == HUGE_VALF)
            best.distance = distance(patch, stride, best.source, HUGE_VALF);
        return best;
    }

    PatchMatch beside(Source source, int dx, int dy, const float* patch, std::ptrdiff_t stride) const {
        if (m_targets[source.exemplar].has(source.x + dx, source.y + dy)) {
            source.x = static_cast<std::uint16_t>(source.x + dx);
            source.y = static_cast<std::uint16_t>(source.y + dy);
        }
        return {source, distance(patch, stride, source, HUGE_VALF)};
    }

    /// The scan runs right and down in even iterations, left and up in odd ones.
    void improve(int number, int iteration) {
        const Tile area = tile(number);
        const auto pixels = pixelsOf(area);
        const int step = iteration % 2 == 0 ? 1 : -1;
        const int columns = area.right - area.left, rows = area.bottom - area.top;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const int x = step > 0 ? area.left + i : area.right - 1 - i;
                const int y = step > 0 ? area.top + j : area.bottom - 1 - j;
                improvePatch(x, y, pixels->at(x - area.left, y - area.top), pixels->stride(), step,
                             iteration);
            }
    }

    void improvePatch(int x, int y, const float* patch, std::ptrdiff_t stride, int step, int iteration) {
        PatchMatch best = m_field.at(x, y);
        if (best.distance <= 0)
            return;
        const auto attempt = [&](std::uint16_t exemplar, int toX, int toY) {
            if (!m_targets[exemplar].has(toX, toY))
                return;
            const Source source{static_cast<std::uint16_t>(toX), static_cast<std::uint16_t>(toY), exemplar};
            if (source == best.source)
                return;
            const float found = distance(patch, stride, source, best.distance);
            if (found < best.distance)
                best = {source, found};
        };
        for (const int ahead : {step, -step}) {
            if (const int beside = x - ahead; beside >= 0 && beside < m_field.size().width) {
                const Source& near = m_field.at(beside, y).source;
                attempt(near.exemplar, near.x + ahead, near.y);
            }
            if (const int beside = y - ahead; beside >= 0 && beside < m_field.size().height) {
                const Source& near = m_field.at(x, beside).source;
                attempt(near.exemplar, near.x, near.y + ahead);
            }
        }
        QuickRandom random(m_context.random().bits(x, y, static_cast<std::uint32_t>(iteration) + 1));
        for (int radius = m_targets[best.source.exemplar].longerSide(); radius >= 1; radius /= 2) {
            const int toX = best.source.x + random.within(radius);
            attempt(best.source.exemplar, toX, best.source.y + random.within(radius));
        }
        m_field.at(x, y) = best;
    }

    ImageView m_query;
    int m_patch;
    int m_iterations;
    int m_startStep;
    JobContext& m_context;
    std::vector<PatchTarget> m_targets;
    std::int64_t m_count = 0; ///< patches in all targets
    std::optional<PatchTree> m_tree;
    PatchField m_field;
    Size m_tiles;
    Pool<Interleaved> m_pool;
};

} // namespace

double PatchField::meanDistance() const {
    double sum = 0;
    for (const PatchMatch& match : m_matches)
        sum += static_cast<double>(match.distance);
    return sum / static_cast<double>(m_matches.size());
}

PatchField matchPatches(const ImageView& query, std::span<const PatchSource> sources,
                        const PatchMatchOptions& options, JobContext& context) {
    return Matcher(query, sources, options, context).run();
}

} // namespace texloom

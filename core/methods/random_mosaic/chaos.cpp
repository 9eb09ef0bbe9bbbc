#include "core/methods/random_mosaic/chaos.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/patch_grid.h"
#include "core/match/patch_search.h"
#include "core/match/patch_stitch.h"
#include "core/match/whole_patches.h"

#include <algorithm>
#include <cmath>

namespace texloom::random_mosaic {

namespace {

/// The places in all exemplars that blocks may be taken from.
class Places {
public:
    Places(const Request& request, int side, JobContext& context) {
        for (const Exemplar& exemplar : request.exemplars) {
            Own own;
            own.positions = {exemplar.image->width() - side + 1, exemplar.image->height() - side + 1};
            own.count = own.positions.area();
            if (exemplar.mask()) {
                anyWholePatch(
                    exemplar.mask()->view().plane(0), side,
                    [&](int x, int y) {
                        own.allowed.push_back({0, x, y});
                        return false;
                    },
                    [&] { context.check(); });
                own.count = static_cast<std::int64_t>(own.allowed.size());
            }
            m_count += own.count;
            m_exemplars.push_back(std::move(own));
        }
        if (m_count == 0)
            failUsage("The mask leaves no whole block of {} px to lay; choose smaller blocks or mask less.",
                      side);
    }

    PatchPosition drawn(double uniform) const {
        auto n = static_cast<std::int64_t>(uniform * static_cast<double>(m_count));
        for (std::size_t e = 0;; ++e) {
            const Own& own = m_exemplars[e];
            if (n < own.count) {
                PatchPosition position{0, static_cast<int>(n % own.positions.width),
                                       static_cast<int>(n / own.positions.width)};
                if (!own.allowed.empty())
                    position = own.allowed[static_cast<std::size_t>(n)];
                position.exemplar = static_cast<int>(e);
                return position;
            }
            n -= own.count;
        }
    }

private:
    struct Own {
        Size positions;
        std::int64_t count = 0;
        std::vector<PatchPosition> allowed; ///< where there is a mask
    };
    std::vector<Own> m_exemplars;
    std::int64_t m_count = 0;
};

/// Lays blocks one after another.
class Mover {
public:
    Mover(Canvas& canvas, const Request& request, const Settings& settings, int side)
        : m_canvas(canvas), m_request(request), m_stitch(settings.stitch), m_side(side),
          m_overlap(settings.stitch == Stitch::Cut || settings.stitch == Stitch::Feather
                        ? std::min(overlapFor(side, settings.overlap), side / 2)
                        : 0),
          m_old({side, side}, request.channels()), m_error({side, side}, 1), m_weight({side, side}, 1) {}

    /// Lays the block of an exemplar at a place of the output, which may reach over borders that wrap.
    void lay(const PatchPosition& from, int toX, int toY) {
        const ImageView fresh =
            m_request.exemplars[static_cast<std::size_t>(from.exemplar)].image->view().crop(from.x, from.y,
                                                                                            {m_side, m_side});
        weigh(fresh, toX, toY);
        const Size size = m_canvas.image.size();
        for (int y = 0; y < m_side; ++y)
            for (int x = 0; x < m_side; ++x) {
                const float old = m_weight(x, y, 0);
                if (old == 1)
                    continue;
                const int u = (toX + x) % size.width, v = (toY + y) % size.height;
                for (int c = 0; c < fresh.channels; ++c) {
                    float& pixel = m_canvas.image(u, v, c);
                    pixel = old == 0 ? fresh(x, y, c) : old * pixel + (1 - old) * fresh(x, y, c);
                }
                if (old < 0.5F) {
                    m_canvas.map.at(u, v) = {static_cast<std::uint16_t>(from.x + x),
                                             static_cast<std::uint16_t>(from.y + y),
                                             static_cast<std::uint16_t>(from.exemplar)};
                    m_canvas.turn(u, v) = 0;
                }
            }
    }

private:
    void weigh(const ImageView& fresh, int toX, int toY) {
        const Overlap around{m_overlap, m_overlap, m_overlap, m_overlap};
        if (m_stitch == Stitch::Feather)
            return rampWeights(around, m_weight.plane(0));
        if (m_stitch != Stitch::Cut)
            return; // all 0: the block hides what it covers
        const Size size = m_canvas.image.size();
        for (int c = 0; c < fresh.channels; ++c)
            for (int y = 0; y < m_side; ++y)
                for (int x = 0; x < m_side; ++x)
                    m_old(x, y, c) = m_canvas.image((toX + x) % size.width, (toY + y) % size.height, c);
        cutWeights(m_old, fresh, around, 0, m_error.plane(0), m_weight.plane(0));
    }

    Canvas& m_canvas;
    const Request& m_request;
    Stitch m_stitch;
    int m_side, m_overlap;
    Image m_old, m_error, m_weight;
};

/// Where the cat map sends a point of the unit square, turned so many times.
std::pair<double, double> sent(double x, double y, int turns) {
    for (int n = 0; n < turns; ++n) {
        const double u = x + y, v = x + 2 * y;
        x = u - std::floor(u);
        y = v - std::floor(v);
    }
    return {x, y};
}

/// A place along an axis, moved where the block would leave an output that does not wrap.
int settled(double at, int side, int length, bool wraps) {
    const int place = static_cast<int>(at);
    return wraps ? place % length : std::clamp(place, 0, std::max(0, length - side));
}

} // namespace

int moveBlocks(Canvas& canvas, const Request& request, const Settings& settings, Size cell, double weight,
               JobContext& context) {
    context.stage(weight, TR("Moving blocks"));
    const Size size = canvas.image.size();
    const int side = std::min(settings.size, size.shorterSide());
    const Places places(request, side, context);
    Mover mover(canvas, request, settings, side);
    const int columns = (size.width + cell.width - 1) / cell.width;
    const int rows = (size.height + cell.height - 1) / cell.height;
    const int blocks = std::max(1, static_cast<int>(cell.area() / (static_cast<std::int64_t>(side) * side)));
    const Random& random = context.random();
    constexpr int kMostTurns = 4;
    for (int tile = 0; tile < columns * rows; ++tile) {
        context.progress(static_cast<double>(tile) / (columns * rows));
        context.preview(canvas.image, &canvas.map);
        const int column = tile % columns, row = tile / columns;
        const int turns = 1 + static_cast<int>(random.below(kMostTurns, tile, -1));
        for (int block = 0; block < blocks; ++block) {
            context.check();
            const PatchPosition from = places.drawn(random.uniform(tile, block));
            const Size exemplar = request.exemplars[static_cast<std::size_t>(from.exemplar)].image->size();
            const auto [x, y] = sent(static_cast<double>(from.x) / exemplar.width,
                                     static_cast<double>(from.y) / exemplar.height, turns);
            mover.lay(from, settled((column + x) * cell.width, side, size.width, request.wrap.x),
                      settled((row + y) * cell.height, side, size.height, request.wrap.y));
        }
    }
    context.progress(1);
    return columns * rows * blocks;
}

} // namespace texloom::random_mosaic

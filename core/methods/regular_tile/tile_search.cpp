#include "core/methods/regular_tile/tile_search.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace texloom::regular_tile {

namespace {

struct Offset {
    int x = 0, y = 0;
};

Offset whole(Vec2 v) {
    return {static_cast<int>(std::lround(v.x)), static_cast<int>(std::lround(v.y))};
}

/// A row of a border: the offsets [from, to) at height y from the tile's corner.
struct Span {
    int y = 0, from = 0, to = 0;
};

/// The border along `side`, which begins at the tile's corner.
std::vector<Span> borderAlong(Vec2 side, int border) {
    const double length = side.length(), half = 0.5 * border;
    const int reach = static_cast<int>(std::ceil(half)) + 1;
    const int top = static_cast<int>(std::floor(std::min(0.0, side.y))) - reach;
    const int bottom = static_cast<int>(std::ceil(std::max(0.0, side.y))) + reach;
    const int left = static_cast<int>(std::floor(std::min(0.0, side.x))) - reach;
    const int right = static_cast<int>(std::ceil(std::max(0.0, side.x))) + reach;
    std::vector<Span> spans;
    for (int y = top; y <= bottom; ++y) {
        Span span{y, 0, 0};
        for (int x = left; x <= right; ++x) {
            const Vec2 at{double(x), double(y)};
            const double along = dot(at, side) / length, beside = cross(at, side) / length;
            if (along < 0 || along >= length || beside < -half || beside >= half)
                continue;
            if (span.from == span.to)
                span.from = x;
            span.to = x + 1;
        }
        if (span.from < span.to)
            spans.push_back(span);
    }
    return spans;
}

/// For each row, running sums of the squared differences between pixels and those at `step` from them.
class Differences {
public:
    Differences(const ImageView& exemplar, Offset step)
        : m_area{std::max(0, -step.x),
                 std::max(0, -step.y),
                 {exemplar.width - std::abs(step.x), exemplar.height - std::abs(step.y)}} {
        m_sums.assign(static_cast<std::size_t>(exemplar.height), {});
        for (int y = m_area.y; y < m_area.bottom(); ++y) {
            std::vector<double>& row = m_sums[static_cast<std::size_t>(y)];
            row.assign(static_cast<std::size_t>(exemplar.width) + 1, 0.0);
            for (int x = m_area.x; x < m_area.right(); ++x) {
                double sum = 0;
                for (int c = 0; c < exemplar.channels; ++c) {
                    const double difference = static_cast<double>(exemplar(x, y, c)) -
                                              static_cast<double>(exemplar(x + step.x, y + step.y, c));
                    sum += difference * difference;
                }
                row[static_cast<std::size_t>(x) + 1] = row[static_cast<std::size_t>(x)] + sum;
            }
        }
    }

    /// The sum over a border of the tile at (x, y); infinite where it is not all inside.
    double over(const std::vector<Span>& border, int x, int y) const {
        double sum = 0;
        for (const Span& span : border) {
            if (y + span.y < m_area.y || y + span.y >= m_area.bottom() || x + span.from < m_area.x ||
                x + span.to > m_area.right())
                return std::numeric_limits<double>::infinity();
            const int at = y + span.y, from = x + span.from, to = x + span.to;
            const std::vector<double>& row = m_sums[static_cast<std::size_t>(at)];
            sum += row[static_cast<std::size_t>(to)] - row[static_cast<std::size_t>(from)];
        }
        return sum;
    }

private:
    Region m_area; ///< pixels whose partner is in the exemplar too
    std::vector<std::vector<double>> m_sums;
};

} // namespace

Image tileCosts(const ImageView& exemplar, const Lattice& lattice, int border,
                const std::function<void()>& check) {
    const Differences acrossV1(exemplar, whole(lattice.v1)), acrossV2(exemplar, whole(lattice.v2));
    const std::vector<Span> alongV2 = borderAlong(lattice.v2, border),
                            alongV1 = borderAlong(lattice.v1, border);
    const Offset far = whole(lattice.v1 + lattice.v2);
    Image costs(exemplar.size(), 1);
    for (int y = 0; y < costs.height(); ++y) {
        check();
        for (int x = 0; x < costs.width(); ++x) {
            const bool inside =
                x + far.x >= 0 && x + far.x < costs.width() && y + far.y >= 0 && y + far.y < costs.height();
            costs(x, y, 0) =
                inside ? static_cast<float>(acrossV1.over(alongV2, x, y) + acrossV2.over(alongV1, x, y))
                       : std::numeric_limits<float>::infinity();
        }
    }
    return costs;
}

namespace {

/// Pixels of a tile in one row, relative to its corner.
struct Run {
    int row, first, last;
};

/// All pixels that copies of the tile may take, whose places are rounded: the parallelogram and half a pixel
/// around it.
std::vector<Run> runsOf(const Lattice& lattice) {
    const Vec2 corners[] = {{0, 0}, lattice.v1, lattice.v1 + lattice.v2, lattice.v2};
    double top = 0, bottom = 0;
    for (const Vec2& corner : corners) {
        top = std::min(top, corner.y);
        bottom = std::max(bottom, corner.y);
    }
    std::vector<Run> runs;
    for (int row = static_cast<int>(std::floor(top)) - 1; row <= static_cast<int>(std::ceil(bottom)); ++row) {
        double left = HUGE_VAL, right = -HUGE_VAL;
        const double from = row - 0.5, to = row + 1.5;
        for (int i = 0; i < 4; ++i) {
            const Vec2 a = corners[i], b = corners[(i + 1) % 4];
            for (const double y : {std::clamp(from, std::min(a.y, b.y), std::max(a.y, b.y)),
                                   std::clamp(to, std::min(a.y, b.y), std::max(a.y, b.y))}) {
                if (y < from || y > to)
                    continue;
                const double along = b.y == a.y ? 0 : (y - a.y) / (b.y - a.y);
                for (const double x :
                     {a.x + along * (b.x - a.x), b.y == a.y ? b.x : a.x + along * (b.x - a.x)}) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                }
            }
        }
        if (left <= right)
            runs.push_back({row, static_cast<int>(std::floor(left)) - 1, static_cast<int>(std::ceil(right))});
    }
    return runs;
}

} // namespace

void forbidTiles(Image& costs, const PlaneView& mask, const Lattice& lattice,
                 const std::function<void()>& check) {
    const std::vector<Run> runs = runsOf(lattice);
    const auto stride = static_cast<std::size_t>(mask.width) + 1;
    std::vector<int> hidden(stride * static_cast<std::size_t>(mask.height)); // so far in each row
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x);
            hidden[at + 1] = hidden[at] + (mask(x, y) == 0 ? 1 : 0);
        }
    const auto hides = [&](int x, int y) {
        for (const Run& run : runs) {
            const auto row = static_cast<std::size_t>(std::clamp(y + run.row, 0, mask.height - 1)) * stride;
            const auto first = static_cast<std::size_t>(std::clamp(x + run.first, 0, mask.width - 1));
            const auto last = static_cast<std::size_t>(std::clamp(x + run.last, 0, mask.width - 1));
            if (hidden[row + last + 1] > hidden[row + first])
                return true;
        }
        return false;
    };
    for (int y = 0; y < costs.height(); ++y) {
        check();
        for (int x = 0; x < costs.width(); ++x)
            if (std::isfinite(costs(x, y, 0)) && hides(x, y))
                costs(x, y, 0) = std::numeric_limits<float>::infinity();
    }
}

Tile drawTile(const Image& costs, double tolerance, const Random& random) {
    float least = std::numeric_limits<float>::infinity();
    for (int y = 0; y < costs.height(); ++y)
        least =
            std::min(least, *std::min_element(costs.plane(0).row(y), costs.plane(0).row(y) + costs.width()));
    if (std::isinf(least))
        fail("No tile fits in the exemplar of {} × {} px.", costs.width(), costs.height());
    const float limit = least * static_cast<float>(1 + tolerance);
    std::vector<Tile> drawn;
    for (int y = 0; y < costs.height(); ++y)
        for (int x = 0; x < costs.width(); ++x)
            if (costs(x, y, 0) <= limit)
                drawn.push_back({x, y, costs(x, y, 0)});
    return drawn[random.below(static_cast<std::uint32_t>(drawn.size()), 0, 0)];
}

} // namespace texloom::regular_tile

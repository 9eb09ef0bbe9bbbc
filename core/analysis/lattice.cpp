#include "core/analysis/lattice.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace texloom {

namespace {

/// A lattice of integer vectors as rows: (x, y) ≡ (x − shift, y − rows) and (x, y) ≡ (x − columns, y).
struct Hermite {
    std::int64_t columns, rows, shift;

    Hermite(std::int64_t x1, std::int64_t y1, std::int64_t x2, std::int64_t y2) {
        // Euclid's algorithm on the vectors until one of them is horizontal.
        while (y2 != 0) {
            const std::int64_t times = y1 / y2;
            x1 -= times * x2;
            y1 -= times * y2;
            std::swap(x1, x2);
            std::swap(y1, y2);
        }
        columns = std::abs(x2);
        rows = std::abs(y1);
        shift = y1 < 0 ? -x1 : x1;
        if (columns > 0)
            shift = ((shift % columns) + columns) % columns;
    }
};

/// Number of residues modulo `period` in the union of [start, start + length) over all starts.
std::int64_t unionLength(std::vector<std::int64_t>& starts, std::int64_t length, std::int64_t period) {
    if (length >= period)
        return period;
    std::sort(starts.begin(), starts.end());
    std::int64_t covered = 0;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const std::int64_t next = i + 1 < starts.size() ? starts[i + 1] : starts.front() + period;
        covered += std::min(length, next - starts[i]);
    }
    return covered;
}

/// The integer points around a point, without 0.
std::vector<Vec2> around(Vec2 c) {
    std::vector<Vec2> points;
    for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
            if (const Vec2 p{std::round(c.x) + dx, std::round(c.y) + dy}; p.x != 0 || p.y != 0)
                points.push_back(p);
    return points;
}

Vec2 turned(Vec2 v) {
    return {-v.y, v.x};
}

/// The largest relative change of a length under the linear map with these columns: its singular values
/// compared with 1.
double largestStretch(Vec2 x, Vec2 y) {
    const double sum = 0.5 * (dot(x, x) + dot(y, y));
    const double spread = std::hypot(0.5 * (dot(x, x) - dot(y, y)), dot(x, y));
    const double longest = std::sqrt(sum + spread), shortest = std::sqrt(std::max(0.0, sum - spread));
    // A quarter turn preserves all lengths, so directions count as well.
    const double turn = std::max((x - Vec2{1, 0}).length(), (y - Vec2{0, 1}).length());
    return std::max({longest - 1, 1 - shortest, turn});
}

} // namespace

Lattice Lattice::reduced() const {
    Vec2 a = v1, b = v2;
    if (a.length() > b.length())
        std::swap(a, b);
    // Each round shortens b; the bound only guards against vectors that are not finite.
    for (int round = 0; round < 64; ++round) {
        b = b - std::round(dot(a, b) / dot(a, a)) * a;
        if (b.length() >= a.length() * (1 - 1e-9))
            break;
        std::swap(a, b);
    }
    if (std::abs(b.y) * a.length() < std::abs(a.y) * b.length())
        std::swap(a, b);
    if (a.x < 0 || (a.x == 0 && a.y < 0))
        a = -1.0 * a;
    if (b.y < 0 || (b.y == 0 && b.x < 0))
        b = -1.0 * b;
    return {a, b};
}

double Lattice::acrossRows(Size exemplar) const {
    const Vec2 along = alongRows(v1) ? v1 : v2;
    return std::abs(along.y) * exemplar.width + std::abs(along.x) * exemplar.height;
}

bool Lattice::keepsOrder(Size exemplar) const {
    constexpr double kRepeats = 2.5;
    return rowsOnly() && kRepeats * area() > acrossRows(exemplar);
}

bool Lattice::includes(const Lattice& other, double tolerance) const {
    const Lattice shortest = other.reduced();
    return (shortest.v1 - nearest(shortest.v1)).length() <= tolerance &&
           (shortest.v2 - nearest(shortest.v2)).length() <= tolerance;
}

bool Lattice::like(const Lattice& other, double tolerance) const {
    const double ratio = area() / other.area();
    return ratio > 0.7 && ratio < 1.4 && includes(other, tolerance) && other.includes(*this, tolerance);
}

WrappedLattice wrapped(const Lattice& lattice, Size size, const Wrap& wrap) {
    const Vec2 right{double(size.width), 0}, down{0, double(size.height)};
    WrappedLattice best{lattice, wrap.x || wrap.y ? std::numeric_limits<double>::infinity() : 0};
    const auto consider = [&](Vec2 across, Vec2 along) {
        // The linear map that takes these two lattice points to the ends of the output.
        const Lattice from{lattice.at(across.x, across.y), lattice.at(along.x, along.y)};
        if (from.area() < 0.01 * lattice.area())
            return;
        const auto moved = [&](Vec2 v) {
            const Vec2 c = from.coordinates(v);
            return (wrap.x ? c.x * right : c.x * from.v1) + (wrap.y ? c.y * down : c.y * from.v2);
        };
        const double stretch = largestStretch(moved({1, 0}), moved({0, 1}));
        if (stretch < best.stretch - 1e-12)
            best = {{moved(lattice.v1), moved(lattice.v2)}, stretch};
    };
    for (const Vec2 across : wrap.x ? around(lattice.coordinates(right)) : std::vector<Vec2>{{0, 0}})
        for (const Vec2 along : wrap.y ? around(lattice.coordinates(down)) : std::vector<Vec2>{{0, 0}}) {
            if (wrap.x && wrap.y)
                consider(across, along);
            else if (wrap.x) // the direction perpendicular to the closing one stays
                consider(across, lattice.coordinates(turned(lattice.at(across.x, across.y))));
            else if (wrap.y)
                consider(lattice.coordinates(turned(lattice.at(along.x, along.y))), along);
        }
    return best;
}

Size wrappingRectangle(const Lattice& lattice, int limit) {
    constexpr double kHardly = 0.01;
    const auto smallest = [&](bool vertical) {
        for (int side = 1; side <= limit; ++side) {
            const Vec2 end = vertical ? Vec2{0, double(side)} : Vec2{double(side), 0};
            const double off = (end - lattice.nearest(end)).length();
            if (off <= std::max(0.25, kHardly * side) && lattice.nearest(end).length() > 0.5)
                return side;
        }
        return 0;
    };
    const Size size{smallest(false), smallest(true)};
    return size.empty() ? Size{} : size;
}

double tileCoverage(const Lattice& lattice, Size rectangle) {
    const auto whole = [](double v) { return static_cast<std::int64_t>(std::llround(v)); };
    const Hermite tile(whole(lattice.v1.x), whole(lattice.v1.y), whole(lattice.v2.x), whole(lattice.v2.y));
    const std::int64_t area = tile.columns * tile.rows;
    if (area == 0 || rectangle.empty())
        return 0;
    // Rows y, y + rows, y + 2 rows … hold the same pixels of the tile, each offset by the shift.
    const std::int64_t cycle =
        tile.columns / std::gcd(tile.columns, tile.shift == 0 ? tile.columns : tile.shift);
    std::int64_t covered = 0, previousCount = -1, previous = 0;
    for (std::int64_t y = 0; y < std::min<std::int64_t>(tile.rows, rectangle.height); ++y) {
        const std::int64_t count = std::min(cycle, (rectangle.height - y - 1) / tile.rows + 1);
        if (count != previousCount) {
            std::vector<std::int64_t> starts;
            for (std::int64_t k = 0; k < count; ++k)
                starts.push_back(((-k * tile.shift) % tile.columns + tile.columns) % tile.columns);
            previous = unionLength(starts, rectangle.width, tile.columns);
            previousCount = count;
        }
        covered += previous;
    }
    return static_cast<double>(covered) / static_cast<double>(area);
}

} // namespace texloom

#include "core/methods/near_regular/sampler.h"

#include <algorithm>
#include <cmath>

namespace texloom::near_regular {

Sampler::Sampler(Size exemplar, const Lattice& from, const Lattice& to, Vec2 origin, const Layout& layout,
                 const Random& random, const BorderMatch& match)
    : m_positions{exemplar.width - layout.patch() + 1, exemplar.height - layout.patch() + 1}, m_from(from),
      m_to(to), m_origin(origin), m_layout(layout), m_random(random), m_match(match),
      m_ordered(from.keepsOrder(exemplar)) {
    if (match.allowed() == m_positions.area())
        return;
    for (int y = 0; y < m_positions.height; ++y)
        for (int x = 0; x < m_positions.width; ++x)
            if (match.allows(x, y))
                m_allowed.push_back({x, y});
}

/// Where the patch would lie if the exemplar were unbounded. The lattices may differ, so that the patch is
/// right at its middle.
Vec2 Sampler::target(Cell cell) const {
    const Cell own = m_layout.identity(cell);
    const double half = 0.5 * m_layout.patch();
    const Vec2 middle{m_layout.horizontal().start(own.column) - m_layout.reach() + half,
                      m_layout.vertical().start(own.row) - m_layout.reach() + half};
    const Vec2 c = m_to.coordinates(middle);
    return m_origin + m_from.at(c.x, c.y) - Vec2{half, half};
}

std::vector<Point> Sampler::alike(Cell cell) const {
    const Vec2 start = target(cell);
    const double right = m_positions.width - 1, bottom = m_positions.height - 1;
    // The positions' rectangle in coordinates of the lattice, seen from the target.
    double a0 = HUGE_VAL, a1 = -HUGE_VAL, b0 = HUGE_VAL, b1 = -HUGE_VAL;
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{right, 0}, Vec2{0, bottom}, Vec2{right, bottom}}) {
        const Vec2 c = m_from.coordinates(corner - start);
        a0 = std::min(a0, c.x);
        a1 = std::max(a1, c.x);
        b0 = std::min(b0, c.y);
        b1 = std::max(b1, c.y);
    }
    std::vector<Point> points;
    constexpr double kRounding = 0.5;
    for (double b = std::ceil(b0 - 1); b <= b1 + 1; ++b)
        for (double a = std::ceil(a0 - 1); a <= a1 + 1; ++a) {
            const Vec2 p = start + m_from.at(a, b);
            if (p.x >= -kRounding && p.y >= -kRounding && p.x < right + kRounding && p.y < bottom + kRounding)
                points.push_back({std::clamp(static_cast<int>(std::lround(p.x)), 0, m_positions.width - 1),
                                  std::clamp(static_cast<int>(std::lround(p.y)), 0, m_positions.height - 1)});
        }
    std::erase_if(points, [this](const Point& p) { return !m_match.allows(p.x, p.y) || !inOrder(p); });
    return points;
}

/// Of rows that keep their order, those of one period about the middle count.
bool Sampler::inOrder(const Point& p) const {
    if (!m_ordered)
        return true;
    const Vec2 fromMiddle{p.x - 0.5 * (m_positions.width - 1), p.y - 0.5 * (m_positions.height - 1)};
    const Vec2 at = m_from.coordinates(fromMiddle);
    const double across = alongRows(m_from.v1) ? at.y : at.x;
    constexpr double kRounding = 0.01; // positions are whole pixels
    return across >= -0.5 - kRounding && across <= 0.5 + kRounding;
}

/// Where no patch lies on the lattice, the one nearest to it.
Point Sampler::nearestAllowed(Cell cell) const {
    const Vec2 start = target(cell);
    const auto off = [&](const Point& p) {
        const Vec2 from = Vec2{static_cast<double>(p.x), static_cast<double>(p.y)} - start;
        return (from - m_from.nearest(from)).length();
    };
    return *std::min_element(m_allowed.begin(), m_allowed.end(),
                             [&](const Point& a, const Point& b) { return off(a) < off(b); });
}

Point Sampler::drawn(Cell cell) const {
    const Cell own = m_layout.identity(cell);
    const auto below = [&](std::size_t count, std::uint32_t draw) {
        return static_cast<int>(m_random.below(static_cast<std::uint32_t>(count), own.column, own.row, draw));
    };
    if (free() && !m_allowed.empty())
        return m_allowed[static_cast<std::size_t>(below(m_allowed.size(), 0))];
    if (free())
        return {below(static_cast<std::size_t>(m_positions.width), 0),
                below(static_cast<std::size_t>(m_positions.height), 1)};
    const std::vector<Point> points = alike(cell);
    if (!points.empty())
        return points[static_cast<std::size_t>(below(points.size(), 0))];
    if (!m_allowed.empty())
        return nearestAllowed(cell);
    const Vec2 middle{0.5 * (m_positions.width - 1), 0.5 * (m_positions.height - 1)};
    const Vec2 nearest = middle + (target(cell) - middle) - m_from.nearest(target(cell) - middle);
    return {std::clamp(static_cast<int>(std::lround(nearest.x)), 0, m_positions.width - 1),
            std::clamp(static_cast<int>(std::lround(nearest.y)), 0, m_positions.height - 1)};
}

} // namespace texloom::near_regular

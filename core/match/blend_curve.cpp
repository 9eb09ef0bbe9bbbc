#include "core/match/blend_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace texloom {

BlendCurve BlendCurve::horizontal(Size size, int y) {
    BlendCurve curve;
    curve.addLine({0, y + 0.5}, {static_cast<double>(size.width), y + 0.5});
    return curve;
}

BlendCurve BlendCurve::vertical(Size size, int x) {
    BlendCurve curve;
    curve.addLine({x + 0.5, static_cast<double>(size.height)}, {x + 0.5, 0});
    return curve;
}

BlendCurve BlendCurve::circular(Size size, double radius) {
    BlendCurve curve;
    curve.addArc({static_cast<double>(size.width), static_cast<double>(size.height)}, radius, 0, -1);
    return curve;
}

BlendCurve BlendCurve::at(Shape shape, double position, Size size) {
    const auto middle = [&](int length) {
        return std::clamp(static_cast<int>(std::lround(position * length)), 0, length - 1);
    };
    switch (shape) {
    case Shape::Vertical:
        return vertical(size, middle(size.width));
    case Shape::Circular:
        return circular(size, std::max(1.0, (1 - position) * size.shorterSide()));
    case Shape::Horizontal:
        break;
    }
    return horizontal(size, middle(size.height));
}

std::vector<BlendCurve> BlendCurve::around(const Overlap& overlap, int patch) {
    // Sides in the order in which the curve follows them, a quarter turn apart: each runs at `inset` from its
    // border, from the border on its left to the one on its right.
    const std::array<int, 4> widths = {overlap.left, overlap.top, overlap.right, overlap.bottom};
    const double side = patch;
    const auto turned = [side](int quarter, double inset, double walked) {
        switch (quarter) {
        case 0:
            return Point{inset, side - walked};
        case 1:
            return Point{walked, inset};
        case 2:
            return Point{side - inset, walked};
        default:
            return Point{side - walked, side - inset};
        }
    };
    const auto at = [](int quarter) { return static_cast<std::size_t>(quarter % 4); };
    const auto inset = [&](int quarter) { return widths[at(quarter)] / 2.0; };
    const bool closed = std::all_of(widths.begin(), widths.end(), [](int width) { return width > 0; });
    std::vector<BlendCurve> curves;
    for (int first = 0; first < (closed ? 1 : 4); ++first) {
        if (widths[at(first)] == 0 || (!closed && widths[at(first + 3)] > 0))
            continue;
        BlendCurve curve;
        double walked = closed ? side / 2 : 0;
        for (int quarter = first; quarter < first + (closed ? 5 : 4) && widths[at(quarter)] > 0; ++quarter) {
            const bool last = closed && quarter == first + 4;
            const bool turns = !last && widths[at(quarter + 1)] > 0;
            const double radius = turns ? std::min(inset(quarter), inset(quarter + 1)) : 0;
            const double end = last ? side / 2 : turns ? side - inset(quarter + 1) - radius : side;
            const Point from = turned(quarter % 4, inset(quarter), walked);
            const Point to = turned(quarter % 4, inset(quarter), end);
            curve.addLine(from, to);
            if (!turns)
                break;
            const double length = std::max(1e-9, end - walked);
            const double dx = (to.x - from.x) / length, dy = (to.y - from.y) / length;
            curve.addArc({to.x - radius * dy, to.y + radius * dx}, radius, dx, dy);
            walked = inset(quarter) + radius;
        }
        curves.push_back(curve);
    }
    return curves;
}

void BlendCurve::addLine(const Point& from, const Point& to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (length <= 0)
        return;
    m_pieces.push_back({from, (to.x - from.x) / length, (to.y - from.y) / length, length, 0, m_length});
    m_length += length;
}

void BlendCurve::addArc(const Point& centre, double radius, double dx, double dy) {
    const double length = radius * std::numbers::pi / 2;
    m_pieces.push_back({centre, dx, dy, length, radius, m_length});
    m_length += length;
}

BlendCurve::Place BlendCurve::placeOn(const Piece& piece, const Point& point) const {
    const double x = point.x - piece.from.x, y = point.y - piece.from.y;
    if (piece.radius == 0)
        return {piece.start + x * piece.dx + y * piece.dy, y * piece.dx - x * piece.dy};
    // From the centre, the arc starts on the left of its direction and turns right.
    const double left = x * piece.dy - y * piece.dx, ahead = x * piece.dx + y * piece.dy;
    if (left >= 0 && ahead >= 0)
        return {piece.start + piece.radius * std::atan2(ahead, left), piece.radius - std::hypot(x, y)};
    // Beyond the centre, one of the ends is nearest.
    const double toStart = std::hypot(left - piece.radius, ahead);
    const double toEnd = std::hypot(left, ahead - piece.radius);
    return toStart <= toEnd ? Place{piece.start, toStart} : Place{piece.start + piece.length, toEnd};
}

BlendCurve::Place BlendCurve::placeOf(const Point& point) const {
    Place best;
    double nearest = HUGE_VAL;
    for (const Piece& piece : m_pieces) {
        Place place = placeOn(piece, point);
        const double inside = std::clamp(place.along, piece.start, piece.start + piece.length);
        const double distance = std::hypot(place.along - inside, place.across);
        if (distance < nearest) {
            nearest = distance;
            best = {inside, place.across};
        }
    }
    return best;
}

BlendCurve::Point BlendCurve::pointAt(const Place& place) const {
    const auto next = std::find_if(m_pieces.begin(), m_pieces.end() - 1, [&](const Piece& piece) {
        return place.along <= piece.start + piece.length;
    });
    const double walked = place.along - next->start;
    if (next->radius == 0)
        return {next->from.x + walked * next->dx - place.across * next->dy,
                next->from.y + walked * next->dy + place.across * next->dx};
    const double angle = walked / next->radius, reach = next->radius - place.across;
    const double left = reach * std::cos(angle), ahead = reach * std::sin(angle);
    return {next->from.x + left * next->dy + ahead * next->dx,
            next->from.y - left * next->dx + ahead * next->dy};
}

} // namespace texloom

#include "core/image/placement.h"

#include "core/base/error.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

constexpr int kLargest = 65535; ///< what position maps can address
constexpr double kTurn = 360;

/// Cosine and sine of an angle in degrees, exact for quarter turns.
struct Turn {
    double cosine, sine;

    explicit Turn(double degrees) {
        const double quarters = degrees / 90;
        if (quarters == std::round(quarters)) {
            const int quarter = ((static_cast<int>(quarters) % 4) + 4) % 4;
            cosine = quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
            sine = quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
        } else {
            cosine = std::cos(degrees * std::numbers::pi / 180);
            sine = std::sin(degrees * std::numbers::pi / 180);
        }
    }
};

/// The largest upright rectangle in a turned one.
Size inscribed(Size size, const Turn& turn) {
    const double c = std::abs(turn.cosine), s = std::abs(turn.sine);
    const double w = size.width, h = size.height;
    if (c == 0 || s == 0)
        return c == 0 ? Size{size.height, size.width} : size;
    double width = 0, height = 0;
    const double shorter = std::min(w, h), longer = std::max(w, h);
    if (shorter <= 2 * s * c * longer || std::abs(s - c) < 1e-9) {
        // Two corners touch the longer sides, the others lie within.
        width = 0.5 * shorter / (w >= h ? s : c);
        height = 0.5 * shorter / (w >= h ? c : s);
    } else {
        const double twice = c * c - s * s;
        width = (w * c - h * s) / twice;
        height = (h * c - w * s) / twice;
    }
    constexpr double kRounding = 1e-6;
    return {static_cast<int>(width + kRounding), static_cast<int>(height + kRounding)};
}

double distance(PlanePoint a, PlanePoint b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

double crossAt(PlanePoint corner, PlanePoint before, PlanePoint after) {
    return (after.x - corner.x) * (before.y - corner.y) - (after.y - corner.y) * (before.x - corner.x);
}

void checkCorners(const RectifyEdit& edit, Size before) {
    for (std::size_t i = 0; i < 4; ++i) {
        const PlanePoint& corner = edit.corners[i];
        if (!(corner.x >= 0 && corner.x <= before.width && corner.y >= 0 && corner.y <= before.height))
            failUsage(
                "Corner {} of the rectification lies at {:.1f}, {:.1f}, outside the image of {} × {} px.",
                i + 1, corner.x, corner.y, before.width, before.height);
        if (crossAt(corner, edit.corners[(i + 3) % 4], edit.corners[(i + 1) % 4]) < 1)
            failUsage("The four corners of the rectification must go clockwise from the top left around an "
                      "area without a dent.");
    }
}

Size rectifiedSize(const RectifyEdit& edit) {
    if (!edit.size.empty())
        return edit.size;
    const auto& [topLeft, topRight, bottomRight, bottomLeft] = edit.corners;
    const double width = std::max(distance(topLeft, topRight), distance(bottomLeft, bottomRight));
    const double height = std::max(distance(topLeft, bottomLeft), distance(topRight, bottomRight));
    return {static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height))};
}

void need(const Message& name, double value, double least, double most) {
    if (!(value >= least && value <= most))
        failUsage("{} = {}: it goes from {} to {}.", name, value, least, most);
}

void checkFlatten(const FlattenEdit& edit) {
    need(TR("The window's width"), edit.width, 0.02, 1);
    need(TR("The polynomial's order"), edit.order, 1, 4);
    need(TR("The flattening's strength"), edit.strength, 0, 1);
}

struct SizeAfter {
    Size before;

    Size operator()(const CropEdit& edit) const {
        if (!edit.area.within(before))
            failUsage("The crop of {} × {} px at {}, {} does not lie within the image of {} × {} px.",
                      edit.area.size.width, edit.area.size.height, edit.area.x, edit.area.y, before.width,
                      before.height);
        return edit.area.size;
    }
    Size operator()(const RotateEdit& edit) const {
        need(TR("The angle in degrees"), edit.degrees, -kTurn, kTurn);
        const Size size = inscribed(before, Turn(edit.degrees));
        if (size.empty())
            failUsage("Turned by {}°, too little of the image of {} × {} px would be left.", edit.degrees,
                      before.width, before.height);
        return size;
    }
    Size operator()(const FlipEdit&) const { return before; }
    Size operator()(const RectifyEdit& edit) const {
        checkCorners(edit, before);
        const Size size = rectifiedSize(edit);
        if (size.width < 1 || size.height < 1 || size.width > kLargest || size.height > kLargest)
            failUsage("The rectified image would be {} × {} px; each side is 1 to {} px.", size.width,
                      size.height, kLargest);
        return size;
    }
    Size operator()(const FlattenEdit& edit) const {
        checkFlatten(edit);
        return before;
    }
};

/// The projective map from the rectangle of `size` to a quadrangle.
Eigen::Matrix3d fromRectangle(Size size, const std::array<PlanePoint, 4>& to) {
    const double w = size.width, h = size.height;
    const std::array<PlanePoint, 4> from = {PlanePoint{0, 0}, {w, 0}, {w, h}, {0, h}};
    Eigen::Matrix<double, 8, 8> equations;
    Eigen::Matrix<double, 8, 1> values;
    for (int i = 0; i < 4; ++i) {
        const PlanePoint& a = from[static_cast<std::size_t>(i)];
        const PlanePoint& b = to[static_cast<std::size_t>(i)];
        equations.row(2 * i) << a.x, a.y, 1, 0, 0, 0, -a.x * b.x, -a.y * b.x;
        equations.row(2 * i + 1) << 0, 0, 0, a.x, a.y, 1, -a.x * b.y, -a.y * b.y;
        values[2 * i] = b.x;
        values[2 * i + 1] = b.y;
    }
    const Eigen::Matrix<double, 8, 1> p = equations.fullPivLu().solve(values);
    Eigen::Matrix3d map;
    map << p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], 1;
    return map;
}

/// From an edited image of size `to` to the image before, of size `before`.
struct MapOf {
    Size before, to;

    Eigen::Matrix3d operator()(const CropEdit& edit) const { return shift(edit.area.x, edit.area.y); }
    Eigen::Matrix3d operator()(const RotateEdit& edit) const {
        const Turn turn(edit.degrees);
        Eigen::Matrix3d back = Eigen::Matrix3d::Identity();
        back.topLeftCorner<2, 2>() << turn.cosine, turn.sine, -turn.sine, turn.cosine;
        return shift(0.5 * before.width, 0.5 * before.height) * back *
               shift(-0.5 * to.width, -0.5 * to.height);
    }
    Eigen::Matrix3d operator()(const FlipEdit& edit) const {
        Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
        const int axis = edit.axis == FlipEdit::Axis::Horizontal ? 0 : 1;
        map(axis, axis) = -1;
        map(axis, 2) = axis == 0 ? before.width : before.height;
        return map;
    }
    Eigen::Matrix3d operator()(const RectifyEdit& edit) const { return fromRectangle(to, edit.corners); }
    Eigen::Matrix3d operator()(const FlattenEdit&) const { return Eigen::Matrix3d::Identity(); }

    static Eigen::Matrix3d shift(double x, double y) {
        Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
        map(0, 2) = x;
        map(1, 2) = y;
        return map;
    }
};

PlanePoint applied(const Eigen::Matrix3d& map, PlanePoint point) {
    const Eigen::Vector3d at = map * Eigen::Vector3d(point.x, point.y, 1);
    return {at.x() / at.z(), at.y() / at.z()};
}

} // namespace

Size sizeAfter(const ExemplarEdit& edit, Size before) {
    return std::visit(SizeAfter{before}, edit);
}

Size sizeAfter(const ExemplarEdits& edits, Size before) {
    for (const ExemplarEdit& edit : edits)
        before = sizeAfter(edit, before);
    return before;
}

PlanePoint Placement::toSource(PlanePoint point) const {
    return applied(m_toSource, point);
}

PlanePoint Placement::fromSource(PlanePoint point) const {
    return applied(m_toSource.inverse(), point);
}

Eigen::Matrix2d Placement::jacobian(PlanePoint point) const {
    const Eigen::Vector3d at = m_toSource * Eigen::Vector3d(point.x, point.y, 1);
    Eigen::Matrix2d derivative;
    for (int column = 0; column < 2; ++column)
        for (int row = 0; row < 2; ++row)
            derivative(row, column) =
                (m_toSource(row, column) * at.z() - at[row] * m_toSource(2, column)) / (at.z() * at.z());
    return derivative;
}

bool Placement::exact() const {
    const auto whole = [](double value) { return value == std::round(value); };
    const Eigen::Matrix2d turn = m_toSource.topLeftCorner<2, 2>();
    const PlanePoint first = toSource({0.5, 0.5});
    return m_toSource(2, 0) == 0 && m_toSource(2, 1) == 0 && m_toSource(2, 2) == 1 &&
           turn.cwiseAbs().colwise().sum() == Eigen::RowVector2d::Ones() &&
           turn.array().unaryExpr(whole).all() && whole(first.x - 0.5) && whole(first.y - 0.5);
}

Placement Placement::after(const ExemplarEdit& edit) const {
    Placement next(sizeAfter(edit, m_size));
    next.m_toSource = m_toSource * std::visit(MapOf{m_size, next.m_size}, edit);
    return next;
}

Placement placementOf(const ExemplarEdits& edits, Size source) {
    Placement placement(source);
    for (const ExemplarEdit& edit : edits)
        placement = placement.after(edit);
    return placement;
}

} // namespace texloom

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/size_fields.h"
#include "core/tools/tool.h"

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace texloom::rectify {

namespace {

constexpr int kLargest = 65535; ///< what position maps can address

using Corners = std::array<PlanePoint, 4>; ///< top left, top right, bottom right, bottom left

struct Settings {
    Corners corners{};
    Size size; ///< empty: as long as the longer of opposite sides
};

double distance(PlanePoint a, PlanePoint b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

double crossAt(PlanePoint corner, PlanePoint before, PlanePoint after) {
    return (after.x - corner.x) * (before.y - corner.y) - (after.y - corner.y) * (before.x - corner.x);
}

void checkCorners(const Corners& corners, Size before) {
    for (std::size_t i = 0; i < 4; ++i) {
        const PlanePoint& corner = corners[i];
        if (!(corner.x >= 0 && corner.x <= before.width && corner.y >= 0 && corner.y <= before.height))
            failUsage(
                "Corner {} of the rectification lies at {:.1f}, {:.1f}, outside the image of {} × {} px.",
                i + 1, corner.x, corner.y, before.width, before.height);
        if (crossAt(corner, corners[(i + 3) % 4], corners[(i + 1) % 4]) < 1)
            failUsage("The four corners of the rectification must go clockwise from the top left around an "
                      "area without a dent.");
    }
}

Size sizeFor(const Settings& settings) {
    if (!settings.size.empty())
        return settings.size;
    const auto& [topLeft, topRight, bottomRight, bottomLeft] = settings.corners;
    const double width = std::max(distance(topLeft, topRight), distance(bottomLeft, bottomRight));
    const double height = std::max(distance(topLeft, bottomLeft), distance(topRight, bottomRight));
    const Size size{static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height))};
    if (size.empty() || size.longerSide() > kLargest)
        failUsage("The rectified image would be {} × {} px; each side is 1 to {} px.", size.width,
                  size.height, kLargest);
    return size;
}

/// The projective map from the rectangle of `size` to a quadrangle.
Eigen::Matrix3d fromRectangle(Size size, const Corners& to) {
    const double w = size.width, h = size.height;
    const Corners from = {PlanePoint{0, 0}, {w, 0}, {w, h}, {0, h}};
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

Warp warp(const Settings& settings, Size before) {
    checkCorners(settings.corners, before);
    const Size size = sizeFor(settings);
    return Placement(size, fromRectangle(size, settings.corners));
}

} // namespace

extern const Tool self;
const Tool self = tool<Settings>(
    {.title = TR("Rectify"),
     .summary = TR("Makes a rectangle of a surface that was photographed at a slant.")},
    {field(&Settings::corners, "rectify", TR("Corners"))
         .choices({{"top-left", TR("Top left")},
                   {"top-right", TR("Top right")},
                   {"bottom-right", TR("Bottom right")},
                   {"bottom-left", TR("Bottom left")}})
         .help(TR("Put the corners on four that are a rectangle in reality.")),
     field(&Settings::size, "size", TR("Size"))
         .range(1, kLargest)
         .help(TR("Of the rectangle; if not given, as long as the longer of opposite sides."))},
    warp);

} // namespace texloom::rectify

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/tools/tool.h"

#include <cmath>
#include <numbers>

namespace texloom::rotate {

namespace {

struct Settings {
    double degrees = 0;
};

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

Warp warp(const Settings& settings, Size before) {
    const Turn turn(settings.degrees);
    const Size size = inscribed(before, turn);
    if (size.empty())
        failUsage("Turned by {}°, too little of the image of {} × {} px would be left.", settings.degrees,
                  before.width, before.height);
    Eigen::Matrix3d back = Eigen::Matrix3d::Identity();
    back.topLeftCorner<2, 2>() << turn.cosine, turn.sine, -turn.sine, turn.cosine;
    return Placement(size, shifted(0.5 * before.width, 0.5 * before.height) * back *
                               shifted(-0.5 * size.width, -0.5 * size.height));
}

} // namespace

extern const Tool self;
const Tool self = tool<Settings>(
    {.title = TR("Turn"),
     .summary =
         TR("Turns the exemplar clockwise. Quarter turns move pixels as they are; other angles keep the "
            "largest upright rectangle inside."),
     .presets = {{TR("↺ 90°"), TR("Turn left by 90°"), {{"rotate", -90.0}}},
                 {TR("↻ 90°"), TR("Turn right by 90°"), {{"rotate", 90.0}}}},
     .adjusts = true},
    {field(&Settings::degrees, "rotate", TR("Angle"))
         .range(-360, 360)
         .usual(-45, 45)
         .unit("°")
         .help(TR("Clockwise, in degrees."))},
    warp);

} // namespace texloom::rotate

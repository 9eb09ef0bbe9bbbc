#include "core/base/text.h"
#include "core/tools/tool.h"

namespace texloom::flip {

namespace {

enum class Axis { Horizontal, Vertical };

struct Settings {
    Axis axis = Axis::Horizontal;
};

Warp warp(const Settings& settings, Size before) {
    Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
    const int axis = settings.axis == Axis::Horizontal ? 0 : 1;
    map(axis, axis) = -1;
    map(axis, 2) = axis == 0 ? before.width : before.height;
    return Placement(before, map);
}

} // namespace

extern const Tool self;
const Tool self =
    tool<Settings>({.title = TR("Mirror"),
                    .summary = TR("Swaps left and right, or top and bottom."),
                    .presets = {{"↔", TR("Mirror left to right"), {{"flip", std::string("horizontal")}}},
                                {"↕", TR("Mirror top to bottom"), {{"flip", std::string("vertical")}}}}},
                   {field(&Settings::axis, "flip", TR("Direction"))
                        .choices({{"horizontal", TR("Left to right")}, {"vertical", TR("Top to bottom")}})
                        .help(TR("Which sides change places."))},
                   warp);

} // namespace texloom::flip

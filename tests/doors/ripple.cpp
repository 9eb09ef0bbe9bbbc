// A tool whose warp is a dense field: rows are moved to the side by a sine.

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/tools/registry.h"

#include <cmath>
#include <numbers>

namespace texloom::ripple {

namespace {

struct Settings {
    double height = 2;
    int length = 16;
};

/// Moves rows to the side by a sine.
class Ripple : public WarpField {
public:
    explicit Ripple(const Settings& settings) : m_settings(settings) {}

    PlanePoint toSource(PlanePoint point) const override {
        return {point.x + m_settings.height * std::sin(2 * std::numbers::pi * point.y / m_settings.length),
                point.y};
    }

private:
    Settings m_settings;
};

Warp warp(const Settings& settings, Size before) {
    if (settings.length > before.height)
        failUsage("length = {}: it goes up to the image's height, {} px.", settings.length, before.height);
    return {before, std::make_shared<const Ripple>(settings)};
}

} // namespace

const Tool self = tool<Settings>(
    {.title = TR("Ripple"), .summary = TR("Moves rows to the side by a sine."), .adjusts = true},
    {field(&Settings::height, "ripple", TR("Height")).range(0, 8).unit("px").help(TR("How far rows move.")),
     field(&Settings::length, "length", TR("Length"))
         .range(4, 64)
         .unit("px")
         .help(TR("From one crest to the next."))},
    warp);

namespace {
const ToolRegistration registered("ripple", self);
}

} // namespace texloom::ripple

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/size_fields.h"
#include "core/tools/tool.h"

namespace texloom::crop {

namespace {

struct Settings {
    Region area{0, 0, {1, 1}};
};

Warp warp(const Settings& settings, Size before) {
    const Region& area = settings.area;
    if (!area.within(before))
        failUsage("The crop of {} × {} px at {}, {} does not lie within the image of {} × {} px.",
                  area.size.width, area.size.height, area.x, area.y, before.width, before.height);
    return Placement(area.size, shifted(area.x, area.y));
}

} // namespace

extern const Tool self;
const Tool self = tool<Settings>(
    {.title = TR("Crop"), .summary = TR("Keeps a rectangle of the exemplar.")},
    {field(&Settings::area, "crop", TR("Area"))
         .help(TR("Left and upper edge, width and height, in the exemplar as the edits before it left it."))},
    warp);

} // namespace texloom::crop

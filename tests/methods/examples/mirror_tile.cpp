#include "core/base/text.h"
#include "core/match/patch_canvas.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

#include <algorithm>

namespace texloom::mirror_tile {

namespace {

struct Settings {
    int shift = 0; ///< the first column of the exemplar that is shown
};

void check(const Request&, const Settings&) {}

Estimate estimate(const Request& request, const Settings&, int) {
    return {Image::bytesFor(request.size, request.channels()) + PositionMap::bytesFor(request.size) +
                (1U << 20U),
            1e-8 * static_cast<double>(request.size.area())};
}

/// The exemplar, mirrored at its borders; on an axis that wraps in the middle, too, so that the ends are
/// alike.
Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    context.stage(1, TR("Mirroring"));
    const Size side = request.exemplarSizes().front(), size = request.size;
    Synthesis result;
    result.map = PositionMap(size, {side});
    result.mapKind = MapKind::Exact;
    for (int y = 0; y < size.height; ++y) {
        context.check();
        const int fromY = mirrored(request.wrap.y ? std::min(y, size.height - 1 - y) : y, side.height);
        for (int x = 0; x < size.width; ++x) {
            const int at = request.wrap.x ? std::min(x, size.width - 1 - x) : x;
            result.map.at(x, y) = {static_cast<std::uint16_t>(mirrored(at + settings.shift, side.width)),
                                   static_cast<std::uint16_t>(fromY), 0};
        }
        context.progress((y + 1.0) / size.height);
    }
    result.image = copied(result.map, request, context);
    return result;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Mirror tile"),
     .summary = TR("Mirrors the exemplar at its borders: no seams, but a pattern that is easily seen."),
     .citation = "common practice",
     .category = Category::Tools,
     .takes = {ports::exemplar()},
     .gives = {ports::wrappingImage(), ports::map()},
     .usesSeed = false},
    {field(&Settings::shift, "shift", TR("Shift"))
         .range(0, 4096)
         .unit("px")
         .help(TR("The first column of the exemplar that is shown: another one begins elsewhere."))},
    run, check, estimate);

} // namespace texloom::mirror_tile

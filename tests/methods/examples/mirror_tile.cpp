#include "core/image/mirror.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

#include <algorithm>

namespace texloom::mirror_tile {
namespace {

struct Settings {
    int shift = 0; ///< the first column of the exemplar that is shown
};

Estimate estimate(const Request& request, const Settings&, int) {
    const std::uint64_t little = 1U << 20U;
    return {Image::bytesFor(request.size, request.channels()) + PositionMap::bytesFor(request.size) + little,
            1e-8 * static_cast<double>(request.size.area())};
}

std::uint16_t place(int at, int side) {
    return static_cast<std::uint16_t>(mirrored(at, side));
}

/// The exemplar, mirrored at its borders; on an axis that wraps in the middle, too, so that the ends are
/// alike.
Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    context.stage(1, TR("Mirroring"));
    const Size side = request.exemplarSizes().front(), size = request.size;
    Synthesis result;
    result.map = PositionMap(size, {side});
    result.mapKind = MapKind::Exact;
    context.parallel(0, size.height, [&](int y) {
        const int row = request.wrap.y ? std::min(y, size.height - 1 - y) : y;
        for (int x = 0; x < size.width; ++x) {
            const int column = request.wrap.x ? std::min(x, size.width - 1 - x) : x;
            result.map.at(x, y) = {place(column + settings.shift, side.width), place(row, side.height), 0};
        }
    });
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
    run, estimate);

} // namespace texloom::mirror_tile

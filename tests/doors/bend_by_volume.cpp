// A method that takes a volume: the repeated exemplar, each pixel moved along its row as the volume says.

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/registry.h"
#include "core/volume/volume_source.h"

#include <algorithm>
#include <cmath>

namespace texloom::bend_by_volume {

namespace {

constexpr const char* kVolume = "volume";
constexpr int kRows = 16; ///< between two previews

struct Settings {
    int depth = 0;        ///< z of the slice
    double strength = 10; ///< px by which a value of 1 moves
};

Box boxOf(const Request& request, const Settings& settings, int begin, int rows) {
    return {0, begin, settings.depth, {request.size.width, rows, 1}};
}

void check(const Request& request, const Settings& settings) {
    const auto source = request.inputs.first<VolumeSource>(kVolume);
    const std::optional<Box> bounds = source ? source->bounds() : std::nullopt;
    const Box needed = boxOf(request, settings, 0, request.size.height);
    if (bounds && !needed.within(*bounds))
        failUsage("The volume has {}, and the slice needs {}.", boxText(*bounds), boxText(needed));
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const ImageView exemplar = *request.exemplars.front().image;
    const std::shared_ptr<const VolumeSource> source = request.inputs.first<VolumeSource>(kVolume);
    context.stage(1, TR("Bending rows"));
    Synthesis made;
    made.image = Image(request.size, request.channels());
    for (int begin = 0; begin < request.size.height; begin += kRows) {
        const int rows = std::min(kRows, request.size.height - begin);
        const Volume slab = source->sample(boxOf(request, settings, begin, rows), context);
        context.parallel(0, rows, [&](int row) {
            for (int x = 0; x < request.size.width; ++x) {
                const double moved = x + settings.strength * static_cast<double>(slab(x, row, 0, 0));
                const int at = static_cast<int>(std::llround(moved) % exemplar.width);
                for (int c = 0; c < exemplar.channels; ++c)
                    made.image(x, begin + row, c) =
                        exemplar(at < 0 ? at + exemplar.width : at, (begin + row) % exemplar.height, c);
            }
        });
        context.preview(made.image);
        context.progress(static_cast<double>(begin + rows) / request.size.height);
    }
    return made;
}

Estimate estimate(const Request& request, const Settings&, int) {
    constexpr int kMostChannels = 64;
    return {Image::bytesFor(request.size, request.channels()) +
                Volume::bytesFor({request.size.width, kRows, 1}, kMostChannels) + (1U << 20U),
            3e-8 * static_cast<double>(request.size.area())};
}

} // namespace

const Method self = method<Settings>(
    {.title = TR("Bend by a volume"),
     .summary = TR("Repeats the exemplar and moves its pixels along their rows as a volume says."),
     .citation = "None: an example that takes a volume",
     .category = Category::Solids,
     .takes = {ports::exemplar(),
               {.id = kVolume,
                .title = TR("Volume"),
                .help = TR("Its first channel says how far pixels are moved."),
                .kind = AssetKind::Volume,
                .least = 1}},
     .gives = {ports::image()},
     .usesSeed = false},
    {field(&Settings::depth, "depth", TR("Depth"))
         .range(-1000, 1000)
         .unit("voxels")
         .help(TR("Which slice of the volume counts: others bend in other places.")),
     field(&Settings::strength, "strength", TR("Strength"))
         .range(0, 1000)
         .unit("px")
         .help(TR("How far a value of 1 moves a pixel: 0 leaves the rows straight."))},
    run, check, estimate);

namespace {
const Registration registered("bend-by-volume", self);
}

} // namespace texloom::bend_by_volume

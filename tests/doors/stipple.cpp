// A method with a target image: the exemplar's pixel nearest in brightness to each of the target's.

#include "core/base/text.h"
#include "core/methods/registry.h"

#include <algorithm>
#include <cmath>

namespace texloom::stipple {

namespace {

constexpr const char* kTarget = "target";
/// Rows between two previews.
constexpr int kRows = 16;

struct Settings {
    double strength = 1; ///< how much the target counts beside the place itself, 0 to 1
};

double brightness(const ImageView& image, int x, int y) {
    double sum = 0;
    for (int c = 0; c < image.channels; ++c)
        sum += static_cast<double>(image(x, y, c));
    return sum / image.channels;
}

/// The exemplar's pixel in the same row, modulo its height, that is nearest in brightness.
Source nearest(const ImageView& exemplar, int x, int y, double wanted, double strength) {
    const int row = y % exemplar.height;
    int best = x % exemplar.width;
    double least = HUGE_VAL;
    for (int at = 0; at < exemplar.width; ++at) {
        const double apart = std::abs(at - x % exemplar.width) / static_cast<double>(exemplar.width);
        const double cost =
            strength * std::abs(brightness(exemplar, at, row) - wanted) + (1 - strength) * apart;
        if (cost < least) {
            least = cost;
            best = at;
        }
    }
    return {static_cast<std::uint16_t>(best), static_cast<std::uint16_t>(row), 0};
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const ImageView exemplar = *request.exemplars.front().image;
    const ImageView target = *request.inputs.image(kTarget);
    context.stage(1, TR("Choosing pixels"));
    Synthesis made;
    made.map = PositionMap(request.size, request.exemplarSizes());
    made.image = Image(request.size, request.channels());
    for (int begin = 0; begin < request.size.height; begin += kRows) {
        const int end = std::min(request.size.height, begin + kRows);
        context.parallel(begin, end, [&](int y) {
            for (int x = 0; x < request.size.width; ++x) {
                const Source source = nearest(exemplar, x, y, brightness(target, x, y), settings.strength);
                made.map.at(x, y) = source;
                for (int c = 0; c < exemplar.channels; ++c)
                    made.image(x, y, c) = exemplar(source.x, source.y, c);
            }
        });
        context.preview(made.image, &made.map);
        context.progress(static_cast<double>(end) / request.size.height);
    }
    made.mapKind = MapKind::Exact;
    return made;
}

Estimate estimate(const Request& request, const Settings&, int) {
    return {Image::bytesFor(request.size, request.channels()) + PositionMap::bytesFor(request.size) +
                (1U << 20U),
            1e-9 * static_cast<double>(request.size.area()) * request.exemplars.front().image->width()};
}

} // namespace

const Method self = method<Settings>(
    {.title = TR("Stipple"),
     .summary = TR("Shows a target image in the exemplar's pixels, each taken from the same row."),
     .citation = "None: an example with a target image",
     .category = Category::Tools,
     .takes = {ports::exemplar(),
               {.id = kTarget,
                .title = TR("Target"),
                .help = TR("The image that the result is to look like from afar."),
                .least = 1,
                .extent = Extent::Output}},
     .gives = {ports::image(), ports::map()},
     .usesSeed = false},
    {field(&Settings::strength, "strength", TR("Strength"))
         .range(0, 1)
         .help(TR("How much the target counts beside the place: 1 follows it, 0 repeats the exemplar."))},
    run, [](const Request&, const Settings&) {}, estimate);

namespace {
const Registration registered("stipple", self);
}

} // namespace texloom::stipple

// A method that repeats but for rounding: it sums in as many parts as there are threads.

#include "core/base/text.h"
#include "core/methods/registry.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace texloom::even_out {

namespace {

struct Settings {
    double strength = 0.5; ///< share of the contrast that is taken away
};

Estimate estimate(const Request& request, const Settings&, int) {
    return {2 * Image::bytesFor(request.size, request.channels()) + (1U << 20U),
            2e-8 * static_cast<double>(request.size.area())};
}

/// The mean of a channel, in single precision so that the order of the sum shows.
float meanOf(const PlaneView& plane, JobContext& context) {
    std::vector<float> sums(static_cast<std::size_t>(context.threads()), 0);
    context.parallel(0, context.threads(), [&](int part) {
        for (int y = part; y < plane.height; y += context.threads())
            sums[static_cast<std::size_t>(part)] = std::accumulate(plane.row(y), plane.row(y) + plane.width,
                                                                   sums[static_cast<std::size_t>(part)]);
    });
    const auto pixels = static_cast<float>(plane.width) * static_cast<float>(plane.height);
    return std::accumulate(sums.begin(), sums.end(), 0.0F) / pixels;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    context.stage(1, TR("Evening out"));
    const Image& exemplar = *request.exemplars.front().image;
    Synthesis made;
    made.image = Image(request.size, request.channels());
    for (int c = 0; c < made.image.channels(); ++c) {
        const float mean = meanOf(exemplar.plane(c), context);
        const auto kept = static_cast<float>(1 - settings.strength);
        for (int y = 0; y < request.size.height; ++y, context.check())
            for (int x = 0; x < request.size.width; ++x)
                made.image(x, y, c) =
                    mean + kept * (exemplar(x % exemplar.width(), y % exemplar.height(), c) - mean);
        context.preview(made.image);
        context.progress((c + 1.0) / made.image.channels());
    }
    return made;
}

} // namespace

const Method self = method<Settings>(
    {.title = TR("Even out"),
     .summary = TR("Repeats the exemplar with less contrast around its mean."),
     .citation = "None: an example that repeats but for rounding",
     .category = Category::Tools,
     .takes = {ports::exemplar()},
     .gives = {ports::image()},
     .repeats = Repeats::Nearly,
     .usesSeed = false},
    {field(&Settings::strength, "strength", TR("Strength"))
         .range(0, 1)
         .help(TR("How much of the contrast is taken away: 0 leaves all of it, 1 nothing but the mean."))},
    run, estimate);

namespace {
const Registration registered("even-out", self);
}

} // namespace texloom::even_out

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/portilla_simoncelli/synthesizer.h"
#include "core/methods/spectrum_fields.h"

#include <algorithm>
#include <cmath>

namespace texloom::portilla_simoncelli {

namespace {

void check(const Request& request, const Settings&) {
    if (request.exemplars.size() > 2)
        failUsage("Portilla–Simoncelli learns from one exemplar or goes between 2, but {} were given.",
                  request.exemplars.size());
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const int scales = Synthesizer::scalesFor(request, settings), channels = request.channels();
    const auto needAt = [&](Size size) {
        return SteerablePyramid::bytesFor(size, scales, settings.orientations) +
               Sweep::bytesFor(size, scales, channels, settings, threads) +
               2 * Image::bytesFor(size, channels);
    };
    const Size canvas = Synthesizer::canvasFor(request, settings);
    Estimate need;
    need.bytes = needAt(canvas);
    std::uint64_t learned = 0;
    for (const Exemplar& exemplar : request.exemplars)
        learned += Image::bytesFor(exemplar.image->size(), channels);
    for (const Exemplar& exemplar : request.exemplars)
        need.bytes = std::max(need.bytes, needAt(exemplar.image->size()) + learned);
    const double bands = static_cast<double>(channels) * settings.orientations;
    const auto pixels = static_cast<double>(canvas.area());
    need.seconds =
        settings.iterations * pixels * 4 / 3 * (bands * (5e-9 * std::log2(pixels)) + bands * bands * 1e-9);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Synthesizer(request, settings, context).run();
}

std::vector<Param> params() {
    return {
        octavesField(&Settings::scales).symbol("N"),
        orientationsField(&Settings::orientations).range(2, 8).symbol("K"),
        field(&Settings::neighbourhood, "neighbourhood", TR("Neighbourhood"))
            .range(1, 15)
            .unit("px")
            .symbol("M")
            .help(TR("Side of the square in which pixels and magnitudes are compared at each scale: larger "
                     "keeps larger patterns, but copies chance ones.")),
        field(&Settings::iterations, "iterations", TR("Iterations"))
            .range(1, 500)
            .help(TR("Rounds over all statistics: more bring them closer to the exemplar's.")),
        field(&Settings::momentum, "momentum", TR("Momentum"))
            .range(0, 1)
            .group(TR("Advanced"))
            .help(TR(
                "Share of each round's change that is added once more: some brings the statistics closer in "
                "fewer rounds.")),
        field(&Settings::weight, "weight", TR("Weight of the second exemplar"))
            .range(0, 1)
            .help(TR("With two exemplars, how far the statistics go from the first to the second, before "
                     "their own weights.")),
        field(&Settings::jointChannels, "joint-channels", TR("Channels that count"))
            .range(0, 64)
            .when("cross-channel", true)
            .group(TR("Statistics"))
            .help(TR(
                "How many of the first channels are synthesised jointly, 0 for all; the others follow them "
                "point by point and have no say.")),
        field(&Settings::crossChannel, "cross-channel", TR("Across channels"))
            .group(TR("Statistics"))
            .help(TR(
                "Whether channels are synthesised jointly; without, each principal component is by itself.")),
        field(&Settings::marginals, "marginals", TR("Marginals"))
            .group(TR("Statistics"))
            .help(TR("Mean, variance, skewness, kurtosis and range of the pixels and of blurred images.")),
        field(&Settings::autocorrelation, "autocorrelation", TR("Autocorrelation"))
            .group(TR("Statistics"))
            .help(TR("How pixels and blurred images repeat within the neighbourhood.")),
        field(&Settings::magnitudeAutocorrelation, "magnitude-autocorrelation",
              TR("Magnitudes: autocorrelation"))
            .group(TR("Statistics"))
            .help(TR("How strong lines of one angle and size come in groups.")),
        field(&Settings::magnitudeOrientations, "magnitude-orientations", TR("Magnitudes: orientations"))
            .group(TR("Statistics"))
            .help(TR("Which angles come together: corners and crossings.")),
        field(&Settings::magnitudeScales, "magnitude-scales", TR("Magnitudes: scales"))
            .group(TR("Statistics"))
            .help(TR("Which sizes come together: edges against thin lines.")),
        field(&Settings::bandOrientations, "band-orientations", TR("Bands: orientations"))
            .group(TR("Statistics"))
            .help(TR("How the bands of one scale go together in sign, across angles and channels.")),
        field(&Settings::phases, "phases", TR("Bands: phases across scales"))
            .group(TR("Statistics"))
            .help(TR("How phases line up from one scale to the next: lit edges against shaded ones.")),
        periodicField(&Settings::periodic),
    };
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Portilla–Simoncelli"),
     .summary =
         TR("Gives noise the exemplar's joint statistics in a complex steerable pyramid, round after round. "
            "Never copies; suits gravel, grass, bark and other dense textures, and loses regular layouts."),
     .citation = "Portilla & Simoncelli, IJCV 2000; Vacher & Briand, IPOL 2021",
     .category = Category::Statistics,
     .suits = {.regular = 1, .grain = 5, .objects = 2, .large = 1},
     .takes = {ports::weighedExemplars(), ports::initial()},
     .gives = {ports::wrappingImage()}},
    params(), run, check, estimate);

} // namespace texloom::portilla_simoncelli

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/channel_text.h"
#include "core/methods/ashikhmin/synthesizer.h"
#include "core/methods/method.h"
#include "core/methods/pixel_fields.h"

namespace texloom::ashikhmin {

namespace {

Port target() {
    return {.id = std::string(kTargetPort),
            .title = TR("Target"),
            .help = TR("A picture of the result's size whose shapes the exemplar takes on."),
            .extent = Extent::Output};
}

void check(const Request& request, const Settings& settings) {
    checkSquares(request, oddSide(settings.neighbourhood));
    const Image* const target = request.inputs.image(kTargetPort);
    if (target && target->channels() != request.channels())
        failUsage("The target has {}, the exemplar {}; they need the same number.",
                  channelText(target->channels()), request.channels());
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const int channels = request.channels();
    Estimate need;
    need.bytes = PixelCanvas::bytesFor(request.size, channels) + Image::bytesFor(request.size, channels) +
                 ScanOrder::bytesFor(request.size) + PixelPyramid::bytesFor(request) +
                 NeighbourhoodSet::bytesFor(request.exemplarSizes()) + (6U << 20U) +
                 static_cast<std::uint64_t>(threads) * 65536;
    if (request.inputs.image(kTargetPort))
        need.bytes += Interleaved::bytesFor(request.size, channels);
    const double pixels = 0.5 * settings.neighbourhood * settings.neighbourhood;
    need.seconds =
        static_cast<double>(request.size.area()) * settings.passes * pixels * (2e-9 + 1e-9 * channels);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Synthesizer(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Ashikhmin"),
     .summary = TR("Makes one pixel after another in rows; each continues one of the copies that its "
                   "neighbours belong to, "
                   "so that pieces of the exemplar grow until they meet. Very fast, and at its best on "
                   "natural textures "
                   "such as grass, leaves and pebbles."),
     .citation = "Ashikhmin, I3D 2001",
     .category = Category::Pixels,
     .suits = {.regular = 1, .grain = 3, .objects = 3, .large = 2},
     .takes = {ports::weighedExemplars(), ports::mask(), target()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {neighbourhoodField(&Settings::neighbourhood, 21).symbol("n"),
     passesField(&Settings::passes, 10)
         .help(TR(
             "How often the output is gone through: passes after the first see all that surrounds a pixel, "
             "which repairs seams.")),
     field(&Settings::targetWeight, "target-weight", TR("Target weight"))
         .range(0, 10)
         .symbol("w")
         .help(
             TR("How closely the target is followed, if there is one: larger follows it more, smaller keeps "
                "more of the exemplar's structure.")),
     field(&Settings::jump, "jump", TR("Jump"))
         .range(0, 1)
         .group(TR("Advanced"))
         .help(
             TR("How likely a random pixel of the exemplar may be chosen too: larger varies more and copies "
                "smaller pieces."))},
    run, check, estimate);

} // namespace texloom::ashikhmin

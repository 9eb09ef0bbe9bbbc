#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/patch_quilter.h"
#include "core/math/waves.h"
#include "core/methods/fourier_mask/settings.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace texloom::fourier_mask {

namespace {

constexpr const char* kRegularPort = "regular-part";

/// Below this share of the variance there is hardly a regular part.
constexpr double kLeastShare = 0.05;

PlaneView maskOf(const Exemplar& exemplar) {
    return exemplar.mask() ? exemplar.mask()->view().plane(0) : PlaneView{};
}

/// The output's regular part begins anywhere in the exemplar's.
void shiftAtRandom(WaveModel& model, Size exemplar, const Random& random) {
    const int x = static_cast<int>(random.below(static_cast<std::uint32_t>(exemplar.width), -1, -1, 0));
    const int y = static_cast<int>(random.below(static_cast<std::uint32_t>(exemplar.height), -1, -1, 1));
    for (Wave& wave : model.waves)
        for (auto& strength : wave.strengths)
            strength *= std::polar(1.0, 2 * std::numbers::pi * (wave.x * x + wave.y * y));
}

/// How far waves may have run out of step at the output's far end, in cycles: their uncertainty times its
/// sides.
double driftOf(const WaveModel& model, Size size) {
    double worst = 0;
    for (const Wave& wave : model.waves)
        worst = std::max(worst, wave.uncertainty * size.longerSide());
    return worst;
}

void check(const Request& request, const Settings& settings) {
    checkPatchRequest(request, settings.patch);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size exemplar = request.exemplars.front().image->size();
    const int channels = request.channels();
    const Estimate quilt = growthEstimate(request, settings.patch, settings.overlapPixels(), threads, false);
    Estimate need;
    need.bytes = 2 * quilt.bytes + PatchQuilter::mapBytesFor(request.size, settings.patch) +
                 findWavesBytes(exemplar, channels, settings.waveOptions()) +
                 Image::bytesFor(exemplar, channels) + 3 * Image::bytesFor(request.size, channels) +
                 (4U << 20);
    const auto pixels = static_cast<double>(exemplar.area());
    need.seconds = 2 * quilt.seconds + pixels * channels * (1e-6 + 1.5e-7 * settings.waves) +
                   static_cast<double>(request.size.area()) * channels * settings.waves * 2e-9;
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const Exemplar& exemplar = request.exemplars.front();
    context.stage(0.2, TR("Finding waves"));
    const WaveModel model =
        findWaves(*exemplar.image, maskOf(exemplar), settings.waveOptions(), [&] { context.check(); });
    double move = 0;
    WaveModel output = closed(model, request.size, request.wrap, move);
    shiftAtRandom(output, exemplar.image->size(), context.random());
    context.stage(0.1, TR("Drawing the regular part"));
    const Image own = drawn(model, {0, 0, exemplar.image->size()}, context);
    Image regular = drawn(output, {0, 0, request.size}, context);
    context.preview(regular);
    const std::vector<PatchSource> exemplars = patchSources(request);
    const QuiltGuide guide{{{own.view(), maskOf(exemplar), exemplar.weight}}, regular, settings.weight};
    QuiltOptions options;
    options.size = request.size;
    options.wrap = request.wrap;
    options.patch = settings.patch;
    options.overlap = settings.overlapPixels();
    options.tolerance = settings.tolerance;
    options.initial = request.initial();
    options.guide = model.waves.empty() ? nullptr : &guide;
    Quilt quilt = PatchQuilter(exemplars, options, context).run(0.7);
    Synthesis result;
    result.image = std::move(quilt.image);
    result.map = std::move(quilt.map);
    result.mapKind = MapKind::Exact;
    result.figures = {{TR("Waves"), static_cast<double>(model.waves.size())},
                      {TR("Share of the variance in the regular part"), model.share},
                      {TR("Drift over the output, in cycles"), driftOf(model, request.size)},
                      {TR("Largest move to close, in cycles"), move},
                      {TR("Mean error along a cut"), *quilt.meanCutError}};
    result.outputs.add(kRegularPort, std::make_shared<const Image>(
                                         regular.view().channelRange(0, request.resultChannels())));
    if (model.share < kLeastShare)
        result.notes.push_back(
            message("Only {:.1f} % of {} is regular, less than {:.0f} %, so hardly anything guides the "
                    "patches; lower the threshold, or use image quilting.",
                    100 * std::max(0.0, model.share), exemplar.name, 100 * kLeastShare));
    return result;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Fourier mask"),
     .summary =
         TR("Finds the waves that a near-regular exemplar is made of, to a fraction of a cycle, continues "
            "them over the output, and quilts patches that follow them. Suits weaves, bricks and tiles "
            "that are seen straight on."),
     .citation = "Nicoll, Meseth, Müller & Klein, Eurographics 2005; Efros & Freeman, SIGGRAPH 2001",
     .category = Category::NearRegular,
     .suits = {.regular = 4, .grain = 1, .objects = 1, .large = 1},
     .takes = {ports::exemplar(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage(), ports::map(),
               Port{.id = kRegularPort,
                    .title = TR("Regular part"),
                    .help =
                        TR("The waves alone, of the output's size: the texture without its irregularities."),
                    .kind = AssetKind::Image}}},
    {field(&Settings::threshold, "threshold", TR("Threshold"))
         .range(0.01, 1)
         .help(TR("Peaks of the spectrum this high, over the highest, count as waves: smaller finds more of "
                  "them, and takes chance for rule.")),
     field(&Settings::waves, "waves", TR("Waves"))
         .range(1, 64)
         .group(TR("Advanced"))
         .help(TR("At most so many waves, the strongest: more follow finer regularity and take longer.")),
     field(&Settings::weight, "weight", TR("Weight of the waves"))
         .range(0, 100)
         .help(TR(
             "How much the regular part counts beside the fit of overlaps: larger keeps the order, 0 quilts "
             "without it.")),
     patchField(&Settings::patch, 0.2)
         .help(
             TR("Side of the squares that are copied: larger keeps larger structures whole, smaller follows "
                "the waves more closely.")),
     overlapField(&Settings::overlap)
         .help(TR("Share of the patch that overlaps its neighbours: larger joins better, but repeats itself "
                  "sooner.")),
     toleranceField(&Settings::tolerance)
         .help(TR("How much worse than the best a patch may fit and still be drawn: larger varies more."))},
    run, check, estimate);

} // namespace texloom::fourier_mask

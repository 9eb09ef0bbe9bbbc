#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/patch_canvas.h"
#include "core/methods/method.h"
#include "core/methods/multiscale_gaussian/scale.h"
#include "core/methods/multiscale_gaussian/settings.h"
#include "core/methods/patch_request.h"

namespace texloom::multiscale_gaussian {

namespace {

constexpr double kMapWeight = 0.05;

Size halved(Size size, int times) {
    for (; times > 0; --times)
        size = {(size.width + 1) / 2, (size.height + 1) / 2};
    return size;
}

std::vector<Size> exemplarsAt(const Request& request, int scale) {
    std::vector<Size> sizes = request.exemplarSizes();
    for (Size& size : sizes)
        size = halved(size, scale);
    return sizes;
}

void check(const Request& request, const Settings& settings) {
    checkPatchRequest(request, settings.patch);
    const int coarsest = settings.scales - 1;
    for (const Exemplar& exemplar : request.exemplars)
        if (const Size size = halved(exemplar.image->size(), coarsest); size.shorterSide() < settings.patch)
            failUsage(
                "At the coarsest of {} scales {} is {} × {} px, smaller than the patch of {} px; choose "
                "fewer scales or a smaller patch.",
                settings.scales, exemplar.name, size.width, size.height, settings.patch);
    const Size output = halved(request.size, coarsest);
    if ((request.wrap.x && output.width < settings.patch) ||
        (request.wrap.y && output.height < settings.patch))
        failUsage(
            "To wrap, the output of {} × {} px at the coarsest of {} scales must be at least the patch, {} "
            "px; choose fewer scales or a smaller patch.",
            output.width, output.height, settings.scales, settings.patch);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    Estimate need;
    for (int scale = 0; scale < settings.scales; ++scale) {
        const double patches = PatchCanvas::countFor(halved(request.size, scale), request.wrap,
                                                     settings.patch, settings.overlapPixels());
        need.seconds += patches * patchSearchSeconds(exemplarsAt(request, scale), request.channels()) *
                        (scale + 1 < settings.scales ? 2 : 1);
    }
    need.bytes = 4 * PatchCanvas::bytesFor(request.size, request.wrap, request.channels(), settings.patch,
                                           settings.overlapPixels()) +
                 2 * patchSearchBytes(exemplarsAt(request, 0), request.channels(), settings.patch, threads,
                                      settings.contrast > 0);
    for (const Exemplar& exemplar : request.exemplars)
        need.bytes += 5 * Image::bytesFor(exemplar.image->size(), request.channels());
    addEstimatedMap(request, need);
    return need;
}

/// Share of the work that a scale makes up; each has four times as many patches and pixels as the next
/// coarser, and the finer ones compare twice.
double weightOf(int scale, int scales) {
    double whole = 0, one = 0;
    for (int k = 0; k < scales; ++k) {
        const double work = (k + 1 < scales ? 2.0 : 1.0) / static_cast<double>(1 << (4 * k));
        whole += work;
        if (k == scale)
            one = work;
    }
    return one / whole;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    context.stage(0.02, TR("Preparing the exemplar"));
    const auto check = [&context] { context.check(); };
    std::vector<ExemplarScales> exemplars;
    for (const Exemplar& exemplar : request.exemplars)
        exemplars.push_back(exemplarScales(exemplar, settings.scales, check));
    Image coarser;
    double patches = 0;
    for (int scale = settings.scales - 1; scale >= 0; --scale) {
        context.stage((0.98 - kMapWeight) * weightOf(scale, settings.scales),
                      message("Sampling scale {} of {}", settings.scales - scale, settings.scales));
        const Size size = halved(request.size, scale);
        Image low;
        if (scale + 1 < settings.scales)
            low = zoomedIn(coarser, size, request.wrap, check);
        ScaleSampler sampler(exemplars, scale, settings, size, request.wrap, low, context);
        patches += sampler.patches();
        sampler.prepare();
        coarser = sampler.grow();
    }
    exemplars.clear();
    Synthesis result = withEstimatedMap(std::move(coarser), request, kMapWeight, context);
    result.figures = {{TR("Patches"), patches}};
    return result;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Multiscale Gaussian"),
     .summary =
         TR("Lays out large structures at a coarse scale and adds new detail at each finer one. Keeps the "
            "layout of macro-textures with small patches; softer than quilting."),
     .citation = "Raad, Desolneux & Morel, JMIV 2016; Raad, thesis 2016, algorithm 5",
     .category = Category::Patches,
     .suits = {.regular = 1, .grain = 3, .objects = 2, .large = 2},
     .takes = {ports::exemplars(), ports::mask()},
     .gives = {ports::wrappingImage()}},
    {patchField(&Settings::patch, 0.08)
         .range(8, 256)
         .help(
             TR("Side of the patches at every scale: at the coarsest one they cover 2 to the power of scales "
                "− 1 times as much.")),
     neighboursField(&Settings::neighbours)
         .help(TR("Similar patches that each new one is blended from: more vary more and blur more.")),
     field(&Settings::scales, "scales", TR("Scales"))
         .range(1, 6)
         .symbol("K")
         .help(TR("How often the exemplar is halved, plus one: more keep larger structures.")),
     field(&Settings::stitch, "stitch", TR("Stitch"))
         .choices(patchStitchChoices())
         .group(TR("Advanced"))
         .help(
             TR("How patches join at all scales but the coarsest: along the cut of least error, blended, or "
                "pasted, as published.")),
     field(&Settings::coarsest, "coarsest-stitch", TR("Coarsest stitch"))
         .choices(patchStitchChoices())
         .group(TR("Advanced"))
         .help(TR("How patches join at the coarsest scale: the cut keeps contrast that the average, as "
                  "published, loses.")),
     contrastField(&Settings::contrast), boundedField(&Settings::bounded)},
    run, check, estimate);

} // namespace texloom::multiscale_gaussian

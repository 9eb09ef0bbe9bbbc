#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/fill_join.h"
#include "core/methods/fill_request.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/quilting/hole_quilter.h"
#include "core/methods/quilting/settings.h"

#include <functional>

namespace texloom::quilting {

namespace {

Request prepared(
    const Request& request, const Settings& settings, const std::function<void()>& checked = [] {}) {
    return withoutHole(request, settings.context, HoleQuilter::patchFor(request, settings), checked);
}

void checkHole(const Request& request, const Settings& settings) {
    const int patch = HoleQuilter::patchFor(request, settings);
    checkPatchRequest(prepared(request, settings), patch);
    const bool cuts = settings.stitch == PatchStitch::Cut || settings.stitch == PatchStitch::SmoothCut;
    if (!cuts && settings.stitch != PatchStitch::None && settings.stitch != PatchStitch::Poisson)
        failUsage("A hole has no overlaps of even width to blend; choose the stitch cut, smooth-cut, none or "
                  "poisson.");
}

void check(const Request& request, const Settings& settings) {
    checkSomeKnown(request);
    if (knownOf(request))
        checkHole(request, settings);
    else
        checkPatchRequest(request, settings.patch);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    if (knownOf(request))
        return HoleQuilter::estimate(request, settings, threads);
    Estimate need =
        growthEstimate(request, settings.patch, settings.overlapPixels(), threads, settings.contrast > 0);
    // Where an axis wraps, overlaps differ by a pixel.
    const int overlaps = request.wrap.x || request.wrap.y ? 35 : 3;
    need.bytes +=
        PatchQuilter::mapBytesFor(request.size, settings.patch) +
        PatchStitcher::bytesFor(settings.stitch, settings.patch, settings.overlapPixels(), overlaps, threads);
    if (settings.stitch == PatchStitch::Poisson || settings.stitch == PatchStitch::Midway)
        need.seconds *= 1.5;
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    if (knownOf(request)) {
        const auto checked = [&context] { context.check(); };
        const Request hidden = prepared(request, settings, checked);
        const FillWindow window(hidden, HoleQuilter::patchFor(request, settings), checked);
        return HoleQuilter(window, settings, context).run();
    }
    const std::vector<PatchSource> exemplars = patchSources(request);
    const QuiltOptions options = settings.quiltOptions(request);
    return quilted(PatchQuilter(exemplars, options, context).run(),
                   settings.stitch == PatchStitch::Cut || settings.stitch == PatchStitch::None
                       ? MapKind::Exact
                       : MapKind::Dominant);
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Image quilting"),
     .summary =
         TR("Sews square patches of the exemplar together along the cuts where they differ least. Fast and "
            "faithful to structure such as bricks or leaves; copies larger areas verbatim."),
     .citation = "Efros & Freeman, SIGGRAPH 2001; Raad & Galerne, IPOL 2017",
     .category = Category::Patches,
     .suits = {.regular = 3, .grain = 4, .objects = 4, .large = 4},
     .takes = {ports::weighedExemplars(), ports::mask(), ports::initial(), ports::known()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {patchField(&Settings::patch, 0.16)
         .range(4, 512)
         .symbol("w_p")
         .help(TR("Side of the squares that are copied: larger keeps larger structures whole, smaller varies "
                  "more.")),
     quiltOverlapField(&Settings::overlap), quiltToleranceField(&Settings::tolerance),
     field(&Settings::stitch, "stitch", TR("Stitch"))
         .choices(patchStitchChoices())
         .group(TR("Advanced"))
         .help(
             TR("How a patch is joined to its neighbours: a cut, or none, keeps every pixel as it is in the "
                "exemplar; the others blend where patches overlap.")),
     field(&Settings::softness, "softness", TR("Softness"))
         .range(1, 16)
         .unit("px")
         .when("stitch", std::string("smooth-cut"))
         .group(TR("Advanced"))
         .help(TR("How far the smoothed cut blends to either side.")),
     field(&Settings::variety, "variety", TR("Variety"))
         .range(0, 10)
         .symbol("λ")
         .help(TR(
             "How much pieces that were copied near by are avoided in whole outputs: larger repeats itself "
             "less, but joins worse; 0 takes whatever fits best, as published.")),
     contrastField(&Settings::contrast)
         .help(TR(
             "How far flat patches are kept from winning in whole outputs where nothing fits well, and parts "
             "of one flat colour from growing beyond their share: 1 holds the exemplar's contrast; 0 "
             "compares as published, and outputs may fade.")),
     radiusField(&Settings::radius)
         .help(TR("Where a hole is filled, how far from its own place in an exemplar of the output's size a "
                  "pixel's source may lie: smaller takes what is near; 0 looks everywhere.")),
     contextField(&Settings::context),
     seamsField(&Settings::seams)
         .help(TR("Where a hole is filled with the stitch cut, moves the borders between what is copied to "
                  "where they are seen least.")),
     toneField(&Settings::tone)
         .help(TR(
             "Where a hole is filled with the stitch cut, takes the brightness and colour of what is copied "
             "from what is around it, as the stitch poisson does; off: every pixel is a copy."))},
    run, check, estimate);

} // namespace texloom::quilting

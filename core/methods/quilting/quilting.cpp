#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/quilting/settings.h"

namespace texloom::quilting {

namespace {

Estimate estimate(const Request& request, const Settings& settings, int threads) {
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
     .takes = {ports::weighedExemplars(), ports::mask(), ports::initial()},
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
     contrastField(&Settings::contrast)},
    run, checkPatch, estimate);

} // namespace texloom::quilting

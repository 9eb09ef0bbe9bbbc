#include "core/base/text.h"
#include "core/match/patch_quilter.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/texture_transfer/correspondence.h"
#include "core/methods/texture_transfer/settings.h"

#include <limits>

namespace texloom::texture_transfer {

namespace {

constexpr double kPreparing = 0.02;

void check(const Request& request, const Settings& settings) {
    checkPatchRequest(request, settings.patch);
    checkCorrespondence(request);
}

/// Each pass covers the output with smaller patches, and so with more of them.
double patchesOf(const Request& request, const Settings& settings, int pass) {
    return PatchCanvas::countFor(request.size, request.wrap, settings.patchOf(pass),
                                 settings.overlapOf(pass));
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const std::vector<Size> sizes = request.exemplarSizes();
    const int compared = correspondenceChannels(request);
    Estimate need;
    for (int pass = 0; pass < settings.passes; ++pass) {
        const int patch = settings.patchOf(pass), overlap = settings.overlapOf(pass);
        const Estimate quilt = growthEstimate(request, patch, overlap, threads, false);
        need.bytes = std::max(
            need.bytes, quilt.bytes + PatchQuilter::mapBytesFor(request.size, patch) +
                            PatchCanvas::bytesFor(request.size, request.wrap, compared, patch, overlap) +
                            patchSearchBytes(sizes, compared, patch, threads, false));
        need.seconds +=
            quilt.seconds + patchesOf(request, settings, pass) * patchSearchSeconds(sizes, compared);
    }
    need.bytes += Correspondence::bytesFor(request) + Image::bytesFor(request.size, request.channels());
    return need;
}

/// The exemplars' correspondence, with their masks.
QuiltGuide guideFor(const std::vector<PatchSource>& exemplars, const Correspondence& correspondence) {
    QuiltGuide guide;
    guide.exemplars = exemplars;
    for (std::size_t i = 0; i < exemplars.size(); ++i)
        guide.exemplars[i].image = correspondence.exemplars()[i];
    guide.output = correspondence.target();
    return guide;
}

/// α of the overlap's error and 1 − α of the correspondence's, up to a factor.
double guideWeight(double alpha) {
    return alpha > 0 ? (1 - alpha) / alpha : std::numeric_limits<double>::infinity();
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    context.stage(kPreparing, TR("Preparing the correspondence"));
    const std::vector<PatchSource> exemplars = patchSources(request);
    const Correspondence correspondence(request, settings, context);
    QuiltGuide guide = guideFor(exemplars, correspondence);

    double patches = 0;
    for (int pass = 0; pass < settings.passes; ++pass)
        patches += patchesOf(request, settings, pass);
    Quilt quilt;
    int placed = 0;
    for (int pass = 0; pass < settings.passes; ++pass) {
        const Image before = std::move(quilt.image);
        quilt = {};
        guide.weight = guideWeight(settings.alpha(pass));
        QuiltOptions options;
        options.size = request.size;
        options.wrap = request.wrap;
        options.patch = settings.patchOf(pass);
        options.overlap = settings.overlapOf(pass);
        options.tolerance = settings.tolerance;
        options.initial = pass > 0 ? &before : nullptr;
        options.guide = &guide;
        const double share = patchesOf(request, settings, pass) / patches;
        quilt = PatchQuilter(exemplars, options, context).run((1 - kPreparing) * share);
        placed += quilt.patches;
    }
    quilt.patches = placed;
    return quilted(std::move(quilt), MapKind::Exact);
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Texture transfer"),
     .summary = TR("Shows a target picture in the exemplar's material: patches are quilted that follow the "
                   "target's light and dark, with smaller patches in each pass."),
     .citation = "Efros & Freeman, SIGGRAPH 2001, section 4",
     .category = Category::Patches,
     .takes = {ports::weighedExemplars(),
               ports::mask(),
               {.id = kTarget,
                .title = TR("Target"),
                .help = TR("The picture that the result is to look like from afar, of the output's size."),
                .least = 1,
                .extent = Extent::Output},
               {.id = kCorrespondence,
                .title = TR("Correspondence"),
                .help = TR("A picture of the exemplar to compare with the target, such as its height or its "
                           "labels; without one, the blurred luminance of both is compared."),
                .extent = Extent::Exemplar}},
     .gives = {ports::wrappingImage(), ports::map()}},
    {patchField(&Settings::patch, 0.08)
         .range(Settings::kLeastPatch, 256)
         .symbol("w_p")
         .help(TR(
             "Side of the patches in the first pass; each further pass takes two thirds of it. Larger shows "
             "more of the material, smaller more of the target.")),
     quiltOverlapField(&Settings::overlap), quiltToleranceField(&Settings::tolerance),
     field(&Settings::passes, "passes", TR("Passes"))
         .range(1, 6)
         .symbol("N")
         .help(TR(
             "How often the output is quilted over, each time with smaller patches: more follow the target "
             "more closely.")),
     field(&Settings::firstAlpha, "alpha-first", TR("Texture in the first pass"))
         .range(0, 1)
         .symbol("α_1")
         .help(
             TR("How much the joins count in the first pass; the target has the rest. 1 is plain quilting.")),
     field(&Settings::lastAlpha, "alpha-last", TR("Texture in the last pass"))
         .range(0, 1)
         .symbol("α_N")
         .help(
             TR("How much the joins, and the pass before, count in the last pass; the target has the rest.")),
     field(&Settings::blur, "blur", TR("Blur"))
         .range(0, 32)
         .unit("px")
         .symbol("σ")
         .help(TR(
             "How much luminance is blurred before it is compared: larger heeds only broad light and dark.")),
     field(&Settings::matchTones, "match-tones", TR("Match tones"))
         .help(TR("Gives the target's luminance the mean and the contrast of the exemplar's, so that dark "
                  "targets, too, find patches of all tones."))},
    run, check, estimate);

} // namespace texloom::texture_transfer

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/fill_join.h"
#include "core/methods/fill_request.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/patchmatch/completer.h"
#include "core/methods/patchmatch/synthesizer.h"

namespace texloom::patchmatch {

namespace {

void check(const Request& request, const Settings& settings) {
    checkSomeKnown(request);
    checkPatchRequest(withoutHole(request, settings.context, settings.patch), settings.patch);
    if (knownOf(request) && request.size.shorterSide() < settings.patch)
        failUsage(
            "The image to start from is {} × {} px, smaller than the patch of {} px; choose a patch of at "
            "most {} px.",
            request.size.width, request.size.height, settings.patch, request.size.shorterSide());
}

Estimate fillEstimate(const Request& request, const Settings& settings, int threads) {
    const int patch = Completer::patchFor(request, settings);
    const double values = patch * patch * (request.channels() + 1);
    return {Completer::bytesFor(request, settings, threads),
            unknownPixels(request) * settings.iterations * (1e-6 + 2e-8 * values) +
                1e-7 * static_cast<double>(request.size.area())};
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    if (knownOf(request))
        return fillEstimate(request, settings, threads);
    const Size canvas = Synthesizer::canvasFor(request.size, request.wrap, settings.patch);
    const auto area = static_cast<std::uint64_t>(canvas.area());
    const std::vector<Size> exemplars = request.exemplarSizes();
    Estimate need;
    // The map, the coarser one it was made from, and the matches of the lattice.
    need.bytes =
        PositionMap::bytesFor(canvas) * 5 / 4 +
        PatchField::bytesFor({canvas.width / 2 + 1, canvas.height / 2 + 1}) * 4 / 3 +
        Image::bytesFor(request.size, request.channels()) +
        ExemplarPyramid::bytesFor(exemplars, request.channels()) +
        GridMatcher::bytesFor(exemplars, request.channels(), settings.patch, Synthesizer::kStride, threads) +
        (4U << 20U);
    if (request.initial())
        need.bytes += Image::bytesFor(request.size, request.channels()) * 3 / 2;
    const double values = settings.patch * settings.patch * (request.channels() + 1);
    need.seconds = static_cast<double>(area) * (3e-7 + 4e-9 * values);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    if (!knownOf(request))
        return Synthesizer(request, settings, context).run();
    const auto checked = [&context] { context.check(); };
    const int patch = Completer::patchFor(request, settings);
    const Request hidden = withoutHole(request, settings.context, patch, checked);
    const FillWindow window(hidden, patch, checked);
    return Completer(window, patch, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("PatchMatch"),
     .summary =
         TR("Lets overlapping patches of the output find similar ones in the exemplar, from coarse to fine, "
            "and copies the pixels that most of them agree on. Very fast, at its best on textures without "
            "large structure."),
     .citation = "Barnes et al., SIGGRAPH 2009; Han et al. 2006; Kaspar et al., Eurographics 2015",
     .category = Category::Optimisation,
     .suits = {.regular = 2, .grain = 4, .objects = 4, .large = 4},
     .takes = {ports::exemplars(), ports::mask(), ports::initial(), ports::known()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {field(&Settings::patch, "patch", TR("Patch size"))
         .range(3, 32)
         .unit("px")
         .symbol("w")
         .help(TR("Side of the patches that are compared: larger keeps larger structures, smaller varies "
                  "more. Where "
                  "a hole is filled, they are half as large again.")),
     field(&Settings::iterations, "iterations", TR("Iterations"))
         .range(1, 50)
         .help(TR("Rounds of matching and voting on each scale: more join better, but take longer.")),
     scalesField(&Settings::scales),
     uniformityField(&Settings::uniformity, 4)
         .help(TR(
             "How much a patch that is used too often is avoided: larger shows all of the exemplar, 0 takes "
             "whatever fits best, as a hole does that is filled.")),
     radiusField(&Settings::radius)
         .help(TR("Where a hole is filled, how far from its own place in an exemplar of the output's size a "
                  "pixel's source may lie: smaller takes what is near; 0 looks everywhere.")),
     contextField(&Settings::context), seamsField(&Settings::seams), toneField(&Settings::tone)},
    run, check, estimate);

} // namespace texloom::patchmatch

#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/patchmatch/synthesizer.h"

namespace texloom::patchmatch {

namespace {

Estimate estimate(const Request& request, const Settings& settings, int threads) {
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
    return Synthesizer(request, settings, context).run();
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
     .takes = {ports::exemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {field(&Settings::patch, "patch", TR("Patch size"))
         .range(3, 32)
         .unit("px")
         .symbol("w")
         .help(TR(
             "Side of the patches that are compared: larger keeps larger structures, smaller varies more.")),
     field(&Settings::iterations, "iterations", TR("Iterations"))
         .range(1, 50)
         .help(TR("Rounds of matching and voting on each scale: more join better, but take longer.")),
     scalesField(&Settings::scales), uniformityField(&Settings::uniformity)},
    run, checkPatch, estimate);

} // namespace texloom::patchmatch

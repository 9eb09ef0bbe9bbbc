#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/texture_optimization/optimizer.h"

namespace texloom::texture_optimization {

namespace {

void check(const Request& request, const Settings&) {
    checkPatchRequest(request, Optimizer::kSmallestPatch);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size canvas = Optimizer::canvasFor(request.size, request.wrap);
    const Size padded{canvas.width + 32, canvas.height + 32};
    const std::vector<Size> exemplars = request.exemplarSizes();
    const int channels = request.channels();
    const auto pixel = static_cast<std::uint64_t>(Interleaved({1, 1}, channels).pixel) * sizeof(float);
    const auto patches = static_cast<std::uint64_t>(canvas.area()) / 4 + 4096;
    Estimate need;
    // The canvas, the image made from it, the map, and two matches and a weight for every patch.
    need.bytes =
        static_cast<std::uint64_t>(padded.area()) * pixel + Image::bytesFor(canvas, channels) * 3 / 2 +
        PositionMap::bytesFor(canvas) + patches * (2 * sizeof(PatchMatch) + sizeof(float)) +
        ExemplarPyramid::bytesFor(exemplars, channels) +
        static_cast<std::uint64_t>(threads) * static_cast<std::uint64_t>(canvas.width) * 16 * (pixel + 4) +
        (8U << 20U);
    double candidates = 0;
    for (const Size& size : exemplars) {
        need.bytes += static_cast<std::uint64_t>(size.area()) * (pixel * 2 + 64);
        if (settings.uniformity > 0)
            need.bytes += static_cast<std::uint64_t>(size.area()) * 12 + patches * 8;
        candidates += static_cast<double>(size.area()) / 4;
    }
    if (settings.bidirectional)
        need.bytes += patches * 96;
    if (request.initial())
        need.bytes += Image::bytesFor(request.size, channels) * 3 / 2;
    const bool exact = settings.search == Search::Exact || settings.uniformity > 0;
    const double each = exact ? 3e-6 + 2e-10 * candidates : 6e-6;
    need.seconds = 1.6 * settings.iterations * static_cast<double>(patches) * each;
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Optimizer(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Texture optimisation"),
     .summary =
         TR("Changes the whole output until all its patches are like patches of the exemplar, from coarse to "
            "fine and with ever smaller patches. Smooth joins and good large structure; may simplify what "
            "is irregular."),
     .citation =
         "Kwatra et al., SIGGRAPH 2005; Kopf et al., SIGGRAPH 2007; Wei et al. 2008; Kaspar et al. 2015",
     .category = Category::Optimisation,
     .suits = {.regular = 3, .grain = 3, .objects = 4, .large = 2},
     .takes = {ports::exemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {scalesField(&Settings::scales),
     field(&Settings::iterations, "iterations", TR("Iterations"))
         .range(1, 100)
         .help(TR("Most rounds for each patch size on each scale: more join better, but take longer.")),
     field(&Settings::largestPatch, "largest-patch", TR("Largest patch"))
         .range(8, 32)
         .unit("px")
         .symbol("w")
         .help(TR(
             "Patches shrink from this size to 8 px by halves: larger ones keep larger structures whole.")),
     field(&Settings::aggregation, "aggregation", TR("Aggregation"))
         .choices({{"mean", TR("Mean")},
                   {"robust", TR("Robust")},
                   {"robust-falloff", TR("Robust, Gaussian falloff")},
                   {"median", TR("Geometric median")}})
         .symbol("r")
         .help(TR(
             "How overlapping patches are joined: the mean (r = 2) blurs, robust weights (r = 0.8) and the "
             "geometric median stay sharp.")),
     field(&Settings::search, "search", TR("Search"))
         .choices({{"exact", TR("Exact")}, {"patchmatch", TR("PatchMatch")}})
         .group(TR("Advanced"))
         .help(TR(
             "How the most similar patch is found: exactly, or nearly and faster with large exemplars. With "
             "uniformity, always exactly.")),
     field(&Settings::histogram, "histogram", TR("Match colours"))
         .group(TR("Uniformity"))
         .help(TR(
             "Avoids colours that there are too many of already, so that all colours of the exemplar show.")),
     field(&Settings::bidirectional, "bidirectional", TR("Both directions"))
         .group(TR("Uniformity"))
         .help(TR(
             "Every patch of the exemplar looks for its place in the output, too, so that less gets lost.")),
     field(&Settings::alpha, "alpha", TR("Forward share"))
         .range(0.05, 1)
         .symbol("α")
         .when("bidirectional", true)
         .group(TR("Uniformity"))
         .help(TR(
             "How much the output's patches count against the exemplar's: larger joins better, smaller loses "
             "less.")),
     uniformityField(&Settings::uniformity, 10).group(TR("Uniformity")), finishField(&Settings::finish)},
    run, check, estimate);

} // namespace texloom::texture_optimization

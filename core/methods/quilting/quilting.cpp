#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/quilting/quilter.h"

namespace texloom::quilting {

namespace {

void check(const Request& request, const Settings& settings) {
    checkPatchRequest(request, settings.patch);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const int overlap = settings.overlapPixels();
    Estimate need;
    need.bytes =
        PatchCanvas::bytesFor(request.size, request.wrap, request.channels(), settings.patch, overlap) +
        PositionMap::bytesFor({request.size.width + settings.patch, request.size.height + settings.patch}) +
        patchSearchBytes(request, settings.patch, threads, settings.contrast > 0);
    need.seconds = PatchCanvas::countFor(request.size, request.wrap, settings.patch, overlap) *
                   patchSearchSeconds(request);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Quilter(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Image quilting"),
     .summary =
         TR("Sews square patches of the exemplar together along the cuts where they differ least. Fast and "
            "faithful to structure such as bricks or leaves; copies larger areas verbatim."),
     .citation = "Efros & Freeman, SIGGRAPH 2001; Raad & Galerne, IPOL 2017",
     .wraps = true,
     .startsFromImage = true,
     .usesMask = true,
     .severalExemplars = true,
     .weighsExemplars = true,
     .copiesPixels = true},
    {field(&Settings::patch, "patch", TR("Patch size"))
         .range(4, 512)
         .unit("px")
         .scaled(0.16)
         .symbol("w_p")
         .help(TR("Side of the squares that are copied: larger keeps larger structures whole, smaller varies "
                  "more.")),
     field(&Settings::overlap, "overlap", TR("Overlap"))
         .range(0.02, 0.5)
         .symbol("w_o")
         .help(TR("Share of the patch that overlaps its neighbours: larger joins better, but repeats itself "
                  "sooner.")),
     field(&Settings::tolerance, "tolerance", TR("Tolerance"))
         .range(0, 10)
         .symbol("ε")
         .help(TR("How much worse than the best a patch may fit and still be drawn: larger varies more, "
                  "smaller copies "
                  "longer stretches.")),
     field(&Settings::stitch, "stitch", TR("Stitch"))
         .choices({{"cut", TR("Minimum-error cut")}, {"smooth-cut", TR("Smoothed cut")}})
         .group(TR("Advanced"))
         .help(TR("A cut keeps every pixel as it is in the exemplar; a smoothed one blends across it.")),
     field(&Settings::softness, "softness", TR("Softness"))
         .range(1, 16)
         .unit("px")
         .when("stitch", std::string("smooth-cut"))
         .group(TR("Advanced"))
         .help(TR("How far the smoothed cut blends to either side.")),
     contrastField(&Settings::contrast)},
    run, check, estimate);

} // namespace texloom::quilting

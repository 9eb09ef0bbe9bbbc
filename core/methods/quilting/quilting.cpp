#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/quilting/quilter.h"

#include <cmath>

namespace texloom::quilting {

namespace {

void checkExemplar(const Exemplar& exemplar, const Settings& settings) {
    const Size size = exemplar.image->size();
    if (size.shorterSide() < settings.patch)
        failUsage("{} is {} × {} px, smaller than the patch of {} px; choose a patch of at most {} px.",
                  exemplar.name, size.width, size.height, settings.patch, size.shorterSide());
}

bool leavesPatch(const Image& mask, int patch) {
    const PatchDistances distances(mask.view(), mask.view().plane(0), {0.0}, patch);
    return distances.allowed() > 0;
}

void checkWrap(bool wraps, int length, const char* side, int patch) {
    if (wraps && length < patch)
        failUsage("To wrap, the output's {} of {} px must be at least the patch, {} px.", side, length,
                  patch);
}

void check(const Request& request, const Settings& settings) {
    bool anyPatch = false;
    for (const Exemplar& exemplar : request.exemplars) {
        checkExemplar(exemplar, settings);
        anyPatch = anyPatch || !exemplar.mask || leavesPatch(*exemplar.mask, settings.patch);
    }
    if (!anyPatch)
        failUsage("The mask leaves no whole patch of {} px to copy; choose a smaller patch or mask less.",
                  settings.patch);
    checkWrap(request.wrap.x, request.size.width, "width", settings.patch);
    checkWrap(request.wrap.y, request.size.height, "height", settings.patch);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Axis horizontal(request.size.width, settings.patch, settings.overlapPixels(), request.wrap.x);
    const Axis vertical(request.size.height, settings.patch, settings.overlapPixels(), request.wrap.y);
    const double patches = static_cast<double>(horizontal.count()) * vertical.count();
    const Size canvas{horizontal.canvas(), vertical.canvas()};
    // On an axis that wraps overlaps differ by a pixel: at most seven kinds along a row, for five kinds of
    // row.
    constexpr int kShapes = 35;
    constexpr std::uint64_t kCellBytes = 160;

    Estimate need;
    need.bytes = Image::bytesFor(canvas, request.channels()) + PositionMap::bytesFor(canvas) +
                 static_cast<std::uint64_t>(patches) * kCellBytes;
    for (const Exemplar& exemplar : request.exemplars) {
        const Size size = exemplar.image->size();
        need.bytes +=
            PatchDistances::bytesFor(size, request.channels(), settings.patch, kShapes) +
            static_cast<std::uint64_t>(threads) * PatchDistances::scratchBytesFor(size, request.channels());
        const double pixels = static_cast<double>(size.area());
        need.seconds += patches * pixels * (3e-9 + 7e-11 * std::log2(pixels) * (request.channels() + 1));
    }
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
         .help(TR("How far the smoothed cut blends to either side."))},
    run, check, estimate);

} // namespace texloom::quilting

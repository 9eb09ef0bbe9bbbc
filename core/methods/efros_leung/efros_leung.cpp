#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/fill_request.h"
#include "core/methods/fill_tone.h"
#include "core/methods/method.h"
#include "core/methods/patch_fields.h"
#include "core/methods/pixel_grower.h"
#include "core/methods/pixel_request.h"

#include <algorithm>
#include <functional>

namespace texloom::efros_leung {

namespace {

using pixel_growth::Grower;
using pixel_growth::Settings;

Request prepared(
    const Request& request, const Settings& settings, const std::function<void()>& checked = [] {}) {
    return withoutHole(request, settings.context, Grower::window(settings), checked);
}

void check(const Request& request, const Settings& settings) {
    checkSquares(prepared(request, settings), Grower::window(settings));
    if (request.initial() && !knownOf(request))
        failUsage("Nothing says what to keep of the image to start from; give a mask of what is known.");
    checkFill(request);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    double windows = 0;
    for (const Size& size : request.exemplarSizes()) {
        const auto area = static_cast<double>(size.area());
        const bool limited = settings.radius > 0 && size == request.size;
        windows += limited ? std::min(area, 4.0 * settings.radius * settings.radius) : area;
    }
    const double values = static_cast<double>(settings.window) * settings.window * request.channels();
    const double compared = settings.exact(knownOf(request) != nullptr) ? 1.5e-9 * windows : 2.4e-5;
    Estimate need;
    need.bytes = Grower::bytesFor(request, settings, threads) + fillMaskBytes(request);
    if (settings.tone && knownOf(request))
        need.bytes += toneBytes(request);
    need.seconds = unknownPixels(request) * (compared + values * 6e-9);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const Request hidden = prepared(request, settings, [&context] { context.check(); });
    const bool evens = settings.tone && knownOf(request);
    Synthesis result =
        Grower(hidden, settings, {request.initial(), knownOf(request)}, context).run(evens ? 0.9 : 1);
    if (evens)
        evenFilledTone(hidden, 0.1, context, result);
    return result;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Efros–Leung"),
     .summary = TR("Grows the output pixel by pixel from a seed; each becomes one of the exemplar's whose "
                   "surroundings fit what is known around it. Faithful to small structures; slow, and a "
                   "window of the wrong size grows garbage or copies verbatim."),
     .citation = "Efros & Leung, ICCV 1999; Aguerrebere, Gousseau & Tartavel, IPOL 2013",
     .category = Category::Pixels,
     .suits = {.regular = 2, .grain = 3, .objects = 3, .large = 2},
     .takes = {ports::weighedExemplars(), ports::mask(), ports::initial(), ports::known()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {field(&Settings::window, "window", TR("Window"))
         .range(3, 63)
         .unit("px")
         .symbol("n")
         .help(TR("Side of the square that is compared (an even one counts as the next odd): too small grows "
                  "garbage, too large copies verbatim.")),
     toleranceField(&Settings::tolerance)
         .help(TR(
             "How much worse than the best a window may fit and still be drawn: larger varies more, smaller "
             "copies longer stretches.")),
     field(&Settings::sigma, "sigma", TR("Sigma"))
         .range(0.02, 1)
         .symbol("σ")
         .help(
             TR("How far from the middle pixels of the window count, as a share of the window: larger looks "
                "further, smaller trusts the nearest.")),
     field(&Settings::order, "order", TR("Order"))
         .choices({{"onion", TR("Onion")}, {"raster", TR("Rows")}})
         .help(TR("Grows outwards from what is known, layer by layer, or row by row from the top left.")),
     field(&Settings::seedSize, "seed-size", TR("Seed size"))
         .range(1, 63)
         .unit("px")
         .group(TR("Advanced"))
         .help(TR(
             "Side of the square of the exemplar that growth begins with, at most the window: larger begins "
             "with more structure.")),
     field(&Settings::search, "search", TR("Search"))
         .choices({{"auto", TR("Automatic")}, {"exact", TR("Exact")}, {"pca", TR("Principal components")}})
         .group(TR("Advanced"))
         .help(
             TR("Compares all windows exactly, or only those that are likely by their principal components, "
                "in time that hardly grows with the exemplar. Automatic: all, but where a hole is filled the "
                "likely ones.")),
     field(&Settings::components, "components", TR("Components"))
         .range(4, 64)
         .group(TR("Advanced"))
         .help(TR("Principal components by which likely windows are found: more find nearer ones, but take "
                  "longer.")),
     radiusField(&Settings::radius), contextField(&Settings::context), toneField(&Settings::tone)},
    run, check, estimate);

} // namespace texloom::efros_leung

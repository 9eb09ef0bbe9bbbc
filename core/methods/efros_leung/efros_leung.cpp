#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/efros_leung/hole_grower.h"
#include "core/methods/efros_leung/scale_grower.h"
#include "core/methods/fill_join.h"
#include "core/methods/fill_request.h"
#include "core/methods/method.h"
#include "core/methods/patch_fields.h"
#include "core/methods/pixel_grower.h"
#include "core/methods/pixel_request.h"

#include <algorithm>
#include <functional>

namespace texloom::efros_leung {

namespace {

using pixel_growth::Grower;

Request prepared(
    const Request& request, const Settings& settings, const std::function<void()>& checked = [] {}) {
    return withoutHole(request, settings.context, Grower::window(settings), checked);
}

/// Whether growth begins from what is around a hole: where nothing is known it begins from a seed.
bool fillsHole(const Request& request) {
    return knownOf(request) && unknownPixels(request) < static_cast<double>(request.size.area());
}

void check(const Request& request, const Settings& settings) {
    if (request.initial() && !knownOf(request))
        failUsage("Nothing says what to keep of the image to start from; give a mask of what is known.");
    checkFill(request);
    checkSquares(prepared(request, settings), Grower::window(settings));
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    double windows = 0;
    for (const Size& size : request.exemplarSizes()) {
        const auto area = static_cast<double>(size.area());
        const bool limited = settings.radius > 0 && size == request.size;
        windows += limited ? std::min(area, 4.0 * settings.radius * settings.radius) : area;
    }
    const double values = static_cast<double>(settings.window) * settings.window * request.channels();
    const bool near = settings.scales > 1 && settings.search == pixel_growth::Search::Auto;
    const double compared = near                                           ? 1e-5
                            : settings.search == pixel_growth::Search::Pca ? 2.4e-5
                                                                           : 1.5e-9 * windows;
    Estimate need;
    need.bytes = fillsHole(request)    ? HoleGrower::bytesFor(request, settings, threads)
                 : settings.scales > 1 ? ScaleGrower::bytesFor(request, settings, threads)
                                       : Grower::bytesFor(request, settings, threads);
    need.bytes += fillMaskBytes(request);
    need.seconds = unknownPixels(request) * (compared + values * 6e-9);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const auto checked = [&context] { context.check(); };
    const Request hidden = prepared(request, settings, checked);
    if (!fillsHole(request))
        return settings.scales > 1 ? ScaleGrower(hidden, settings, context).run()
                                   : Grower(hidden, settings, {}, context).run();
    const FillWindow window(hidden, Grower::window(settings), checked);
    return HoleGrower(window, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Efros–Leung"),
     .summary =
         TR("Grows the output pixel by pixel, from coarse to fine; each becomes one of the exemplar's "
            "whose surroundings fit what is around it. Faithful to small structures and large ones. "
            "With one scale, as published, it is slow, and a window of the wrong size grows garbage or "
            "copies verbatim."),
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
                "in time that hardly grows with the exemplar. Automatic: all on the coarsest scale, or the "
                "likely ones of large exemplars, and on finer scales those near the coarser one's sources.")),
     field(&Settings::components, "components", TR("Components"))
         .range(4, 64)
         .group(TR("Advanced"))
         .help(TR("Principal components by which likely windows are found: more find nearer ones, but take "
                  "longer.")),
     field(&Settings::scales, "scales", TR("Scales"))
         .range(1, 8)
         .group(TR("Advanced"))
         .help(TR("At most so many, each half the size of the one before: a finer one sees the coarser one's "
                  "result where it has made nothing yet, so that large structures are kept, and what grows "
                  "from opposite sides meets. 1 grows as published.")),
     radiusField(&Settings::radius), contextField(&Settings::context),
     seamsField(&Settings::seams)
         .help(TR("Moves the borders between what is copied to where they are seen least, so that few large "
                  "pieces take the place of many small ones; where a whole output grows, on coarse scales "
                  "only.")),
     toneField(&Settings::tone)},
    run, check, estimate);

} // namespace texloom::efros_leung

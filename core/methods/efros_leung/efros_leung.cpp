#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/efros_leung/grower.h"
#include "core/methods/method.h"
#include "core/methods/patch_fields.h"
#include "core/methods/pixel_request.h"

#include <algorithm>

namespace texloom::efros_leung {

namespace {

constexpr std::string_view kKnownPort = "known";

Port known() {
    return {.id = std::string(kKnownPort),
            .title = TR("Known"),
            .help = TR("What of the image to start from is kept; the rest, where it is black, is made anew."),
            .kind = AssetKind::Mask,
            .extent = Extent::Output};
}

/// Pixels that are to be made.
double unknownOf(const Request& request) {
    const Image* const mask = request.inputs.image(kKnownPort);
    double pixels = 0;
    for (int y = 0; mask && y < mask->height(); ++y)
        for (int x = 0; x < mask->width(); ++x)
            pixels += (*mask)(x, y, 0) == 0 ? 1 : 0;
    return mask ? pixels : static_cast<double>(request.size.area());
}

/// The exemplars without the hole: where one is the very picture that is completed, and no mask says what of
/// it may be copied, what is to be made anew is hidden in it.
Request withoutHole(const Request& request) {
    Request hidden = request;
    const auto mask = request.inputs.first<Image>(kKnownPort);
    for (Exemplar& exemplar : hidden.exemplars)
        if (mask && request.initial() && !exemplar.mask() && samePixels(*exemplar.image, *request.initial()))
            exemplar.inputs.set(kMaskPort, mask);
    return hidden;
}

void check(const Request& request, const Settings& settings) {
    checkSquares(withoutHole(request), Grower::window(settings));
    const Image* const mask = request.inputs.image(kKnownPort);
    if (request.initial() && !mask)
        failUsage("What is to be kept of the image to start from is not said; give a mask of what is known.");
    if (mask && !request.initial())
        failUsage("There is a mask of what is known, but no image to start from; give that too.");
    if (unknownOf(request) == 0)
        failUsage("All of the image to start from is known, so that there is nothing to make; mask less.");
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    double windows = 0;
    for (const Size& size : request.exemplarSizes()) {
        const auto area = static_cast<double>(size.area());
        const bool limited = settings.radius > 0 && size == request.size;
        windows += limited ? std::min(area, 4.0 * settings.radius * settings.radius) : area;
    }
    const double values = static_cast<double>(settings.window) * settings.window * request.channels();
    const double compared = settings.search == Search::Exact ? 1.5e-9 * windows : 1.2e-5;
    Estimate need;
    need.bytes = Grower::bytesFor(request, settings, threads);
    need.seconds = unknownOf(request) * (compared + values * 6e-9);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const Request hidden = withoutHole(request);
    return Grower(hidden, settings, {request.initial(), request.inputs.image(kKnownPort)}, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Efros–Leung"),
     .summary = TR(
         "Grows the output pixel by pixel from a seed; each becomes one of the exemplar's whose surroundings "
         "fit "
         "what is known around it. Faithful to small structures; slow, and a window of the wrong size grows "
         "garbage or copies verbatim."),
     .citation = "Efros & Leung, ICCV 1999; Aguerrebere, Gousseau & Tartavel, IPOL 2013",
     .category = Category::Pixels,
     .takes = {ports::weighedExemplars(), ports::mask(), ports::initial(), known()},
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
         .choices({{"exact", TR("Exact")}, {"pca", TR("Principal components")}})
         .group(TR("Advanced"))
         .help(TR("Compares all windows exactly, or only those that are likely by their principal "
                  "components, in time "
                  "that hardly grows with the exemplar.")),
     field(&Settings::components, "components", TR("Components"))
         .range(4, 64)
         .when("search", std::string("pca"))
         .group(TR("Advanced"))
         .help(TR("Principal components by which likely windows are found: more find nearer ones, but take "
                  "longer.")),
     field(&Settings::radius, "radius", TR("Search radius"))
         .range(0, 4096)
         .unit("px")
         .group(TR("Advanced"))
         .help(TR(
             "How far from its own place in an exemplar of the output's size a pixel's source may lie, as "
             "in a photo that is mended: smaller takes what is near, and is faster; 0 looks everywhere."))},
    run, check, estimate);

} // namespace texloom::efros_leung

#include "core/base/text.h"
#include "core/image/mirror.h"
#include "core/match/patch_grid.h"
#include "core/match/patch_quilter.h"
#include "core/methods/low_frequency/low_band.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/spectrum_fields.h"

#include <cmath>
#include <optional>

namespace texloom::low_frequency {

namespace {

/// As image quilting has them by default.
constexpr double kOverlap = QuiltOptions::kUsualOverlap, kTolerance = QuiltOptions::kUsualTolerance;

/// The torus on which the low band is drawn.
Size torusFor(const Request& request) {
    return PhaseSpot::torusFor(request.exemplars.front().image->size(), request.size, request.wrap);
}

/// Whether the high band must be grown, there being no picture of the size to take it from.
bool quilts(const Request& request) {
    return !request.initial() && torusFor(request) != request.exemplars.front().image->size();
}

Request quiltRequest(const Request& request) {
    Request quilt = request;
    quilt.size = torusFor(request);
    return quilt;
}

QuiltOptions quiltOptions(const Request& request, const Settings& settings) {
    QuiltOptions options;
    options.size = torusFor(request);
    options.wrap = request.wrap;
    options.patch = settings.patch;
    options.overlap = overlapFor(settings.patch, kOverlap);
    options.tolerance = kTolerance;
    options.contrast = QuiltOptions::kUsualContrast;
    options.variety = QuiltOptions::kUsualVariety;
    options.traced = false;
    return options;
}

/// The image whose high band is kept, of the torus's size.
Image source(const Request& request, const Settings& settings, double weight, JobContext& context) {
    const Size torus = torusFor(request);
    if (quilts(request)) {
        const std::vector<PatchSource> exemplars = patchSources(request);
        const Image quilt =
            PatchQuilter(exemplars, quiltOptions(request, settings), context).run(weight).image;
        // The canvas reached beyond the output; transforms want rows of just its size.
        return Image(quilt.view());
    }
    context.stage(weight, TR("Preparing the exemplar"));
    const Image& from = request.initial() ? *request.initial() : *request.exemplars.front().image;
    Image image(torus, request.channels());
    context.parallel(0, torus.height, [&](int y) {
        for (int c = 0; c < image.channels(); ++c) {
            const float* row = from.plane(c).row(mirrored(y, from.height()));
            float* to = image.plane(c).row(y);
            for (int x = 0; x < torus.width; ++x)
                to[x] = row[mirrored(x, from.width())];
        }
    });
    return image;
}

void check(const Request& request, const Settings& settings) {
    if (quilts(request))
        checkPatchRequest(quiltRequest(request), settings.patch);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size torus = torusFor(request), exemplar = request.exemplars.front().image->size();
    const bool spot = request.initial() || torus != exemplar;
    Estimate need;
    need.bytes = LowBand::bytesFor(torus, spot) + Image::bytesFor(torus, request.channels());
    if (spot)
        need.bytes += PhaseSpot::bytesFor(exemplar, request.channels());
    const auto pixels = static_cast<double>(torus.area());
    need.seconds = pixels * (3e-8 + request.channels() * (2e-8 + (spot ? 2e-9 : 1e-9) * std::log2(pixels)));
    if (quilts(request)) {
        const Estimate quilt = growthEstimate(quiltRequest(request), settings.patch,
                                              overlapFor(settings.patch, kOverlap), threads, true);
        need.bytes += quilt.bytes;
        need.seconds += quilt.seconds;
    }
    need.bytes += need.bytes / 16; // plans, threads and what the allocator keeps back
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const double prepared = quilts(request) ? 0.6 : 0.05;
    Synthesis result;
    result.image = source(request, settings, prepared, context);
    Settings bands = settings;
    // What wraps must not jump at its borders.
    bands.periodic = settings.periodic || request.wrap.x || request.wrap.y;
    std::optional<PhaseSpot> spot;
    if (request.initial() || quilts(request)) {
        context.stage(0.05, TR("Preparing the exemplar"));
        spot.emplace(*request.exemplars.front().image, result.image.size(),
                     SpotOptions{bands.periodic, settings.transition}, [&] { context.check(); });
    }
    LowBand(result.image.size(), bands, context)
        .change(result.image, spot ? &*spot : nullptr, request.size, spot ? 0.95 - prepared : 1 - prepared);
    result.image.shrink(request.size);
    return result;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Random low frequencies"),
     .summary =
         TR("Keeps the detail of the exemplar, or of an initial image, and draws the phase of its slow "
            "changes at random, so that stains and shades lie elsewhere. Suits metal and stone seen from "
            "afar; where detail follows the shades, as in wood, the two part."),
     .citation = "Raad, thesis 2016, section 5.7; Galerne, Gousseau & Morel, IEEE TIP 2011",
     .category = Category::Statistics,
     .takes = {ports::exemplar(), ports::initial()},
     .gives = {ports::wrappingImage()}},
    {field(&Settings::theta, "theta", TR("Cut-off"))
         .range(0, 512)
         .unit("px")
         .scaled(0.05)
         .symbol("θ")
         .help(TR("Deviation of the Gaussian that parts the bands: larger changes only what is slower, 0 "
                  "changes everything.")),
     periodicField(&Settings::periodic)
         .help(TR("Works on the periodic component, without which the borders draw horizontal and vertical "
                  "streaks. Outputs that wrap always need it.")),
     transitionField(&Settings::transition),
     field(&Settings::patch, "patch", TR("Detail patch"))
         .range(4, 256)
         .unit("px")
         .scaled(0.2)
         .group(TR("Advanced"))
         .help(TR("Where the output has another size and there is no initial image, detail is quilted from "
                  "patches of this side: larger keeps larger structures whole."))},
    run, check, estimate);

} // namespace texloom::low_frequency

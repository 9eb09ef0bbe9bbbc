#include "core/math/anamorphosis.h"

#include "core/base/text.h"
#include "core/image/stmap.h"
#include "core/math/anamorphosis_fields.h"
#include "core/methods/anamorphosis/deformer.h"
#include "core/methods/anamorphosis/picture.h"
#include "core/methods/method.h"

#include <algorithm>

namespace texloom::anamorphosis {

namespace {

constexpr const char* kCurvePort = "curve";

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size part = request.part().size;
    Estimate need;
    need.bytes = Image::bytesFor(part, request.channels()) + Image::bytesFor(part, 4) +
                 Image::bytesFor({kPictureSide, kPictureSide}, request.resultChannels()) +
                 static_cast<std::uint64_t>(part.width) * static_cast<std::uint64_t>(threads) *
                     (sizeof(PlanePoint) + sizeof(Eigen::Matrix2d)) +
                 (2U << 20);
    if (settings.kind == AnamorphosisKind::Turbulence)
        need.bytes += Anamorphosis::bytesFor();
    need.seconds = static_cast<double>(part.area()) * (4e-8 + 1.5e-8 * request.channels());
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    Synthesis result;
    result.image = Image(request.part().size, request.channels());
    const auto stmap = std::make_shared<Image>(request.part().size, 4);
    context.stage(0.1, TR("Drawing the deformation"));
    const Anamorphosis warp(request.size, anamorphosisOptions(settings), request.wrap, context.random());
    result.outputs.add(
        kCurvePort, std::make_shared<const Image>(pictureOf(warp, request.size, request.resultChannels())));
    context.stage(0.9, TR("Deforming"));
    const bool initial = request.initial() != nullptr;
    const Image& source = initial ? *request.initial() : *request.exemplars.front().image;
    Deformer(source, initial, request.size, request.wrap, settings, warp)
        .make(request.part(), result.image, *stmap, context);
    result.outputs.add(kStMapPort, std::shared_ptr<const Image>(stmap));
    result.figures = {{TR("Amplitude"), warp.amplitude()},
                      {TR("Least determinant of the Jacobian"), warp.leastDeterminant()}};
    if (warp.amplitude() < settings.amplitude)
        result.notes.push_back(message("An amplitude of {} would fold the picture; it was lowered to {:.3f}, "
                                       "the most that surely does not.",
                                       numberText(settings.amplitude), warp.amplitude()));
    return result;
}

Port curve() {
    return {.id = kCurvePort,
            .title = TR("Curve of the map"),
            .help =
                TR("The place that each pixel comes from, along the axis, with a grey line for what does not "
                   "move, as in figure 5.30 of the thesis; of turbulence, squares as they are deformed."),
            .kind = AssetKind::Image,
            .least = 1,
            .most = 1,
            .extent = Extent::Any};
}

Port stMap() {
    return {.id = std::string(kStMapPort),
            .title = TR("STMap"),
            .help = TR("Where each pixel comes from, between pixels too, as compositors read it: .exr, of "
                       "32-bit floats. `apply` lays out another map by it."),
            .kind = AssetKind::Image,
            .least = 1,
            .most = 1,
            .extent = Extent::Any};
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Anamorphosis"),
     .summary =
         TR("Deforms the exemplar, or what another method made of it, lightly and without folds: "
            "stretched along one axis, or as if seen through hot air. Hides repetitions a little; what "
            "is salient is still known again."),
     .citation = "Raad, thesis 2016, section 5.5",
     .category = Category::Tools,
     .takes = {ports::exemplar(), ports::initial()},
     .gives = {ports::inParts(ports::wrappingImage()), stMap(), curve()}},
    {anamorphosisKindField(&Settings::kind, "kind"), anamorphosisAxisField(&Settings::axis),
     anamorphosisAmplitudeField(&Settings::amplitude),
     anamorphosisFrequencyField(&Settings::frequency, "kind"),
     anamorphosisScaleField(&Settings::scale, "kind").scaled(0.125),
     field(&Settings::border, "border", TR("Beyond the border"))
         .choices({{"mirror", TR("Mirror")}, {"repeat", TR("Repeat")}})
         .group(TR("Advanced"))
         .help(TR("How the exemplar goes on where the output is larger or wraps: mirrored it joins with "
                  "itself; repeat one that tiles.")),
     field(&Settings::interpolation, "interpolation", TR("Interpolation"))
         .choices({{"cubic", TR("Cubic")}, {"linear", TR("Linear")}, {"nearest", TR("Nearest pixel")}})
         .group(TR("Advanced"))
         .help(
             TR("Between pixels: cubic is sharpest, linear never overshoots, the nearest pixel is copied as "
                "it is."))},
    run, estimate);

} // namespace texloom::anamorphosis

#include "core/match/blend.h"

#include "core/base/text.h"
#include "core/tools/tool.h"

#include <optional>

namespace texloom::blend {

namespace {

struct Settings {
    BlendCurve::Shape curve = BlendCurve::Shape::Horizontal;
    double position = 0.5;
    int band = 32;
    BlendMethod method = BlendMethod::Midway;
    Propagation propagation = Propagation::Linear;
    BlendColor color = BlendColor::Dct;
};

BlendOptions optionsOf(const Settings& settings) {
    return {settings.method, settings.band, {settings.propagation, settings.color}};
}

Image make(const JoinPictures& pictures, const Settings& settings, JobContext& context) {
    return blendAlong(pictures.first, pictures.second,
                      BlendCurve::at(settings.curve, settings.position, pictures.first.size()),
                      optionsOf(settings), context);
}

void check(const JoinPictures& pictures, const Settings& settings) {
    checkBlend(pictures.first.size(), pictures.second.size(), optionsOf(settings));
}

std::uint64_t bytes(const JoinPictures& pictures, const Settings& settings) {
    return blendBytesFor(pictures.first.size(), pictures.first.channels, optionsOf(settings));
}

ToolPreset way(std::string title, std::string help, std::string method,
               std::optional<std::string> propagation = {}) {
    ToolPreset preset{std::move(title), std::move(help), {{"method", std::move(method)}}};
    if (propagation)
        preset.values["propagation"] = *propagation;
    return preset;
}

} // namespace

extern const Tool self;
const Tool self = tool<Settings>(
    {.title = TR("Blend"),
     .summary = TR("Joins two images along a curve, so that the seam does not show."),
     .citation = "Efros & Freeman 2001; Pérez, Gangnet & Blake 2003; Raad, thesis 2016, chapter 4",
     .presets = {way(TR("Minimum-error cut"), TR("Cuts where the images differ least."), "cut"),
                 way(TR("Poisson editing"), TR("Joins the gradients of both images."), "poisson"),
                 way(TR("Midway, linear"), TR("Deforms both images until they agree; fades out evenly."),
                     "midway", "linear"),
                 way(TR("Midway, progressive"),
                     TR("Deforms both images until they agree; draws lines from the middle to the border."),
                     "midway", "progressive"),
                 way(TR("Not blended"), TR("Leaves the images as they are, to compare with."), "edge")},
     .handle = ToolHandle::Curve},
    {field(&Settings::curve, "curve", TR("Curve"))
         .choices(
             {{"horizontal", TR("Horizontal")}, {"vertical", TR("Vertical")}, {"circular", TR("Circular")}})
         .help(TR(
             "The first image lies above, left of or outside the curve; circles go around the bottom right "
             "corner.")),
     field(&Settings::position, "position", TR("Position"))
         .range(0, 1)
         .help(TR("Where the curve lies, from 0 (top, left, the whole circle) to 1.")),
     field(&Settings::band, "band", TR("Band"))
         .range(2, 4096)
         .upToShare(0.5)
         .unit("px")
         .help(TR("How far from the curve, on either side, pixels may change: up to half the images' shorter "
                  "side.")),
     field(&Settings::method, "method", TR("Method"))
         .choices({{"cut", TR("Minimum-error cut")},
                   {"poisson", TR("Poisson editing")},
                   {"midway", TR("Midway")},
                   {"edge", TR("Not blended")}})
         .help(TR("How the images meet.")),
     field(&Settings::propagation, "propagation", TR("Fading"))
         .choices({{"linear", TR("Linear")}, {"progressive", TR("Progressive")}})
         .when("method", std::string("midway"))
         .help(TR("How midway blending fades out towards the border of the band.")),
     field(&Settings::color, "color", TR("Colours"))
         .choices({{"rgb", TR("As they are (RGB)")},
                   {"dct", TR("Cosine axes (DCT)")},
                   {"pca", TR("Principal axes (PCA)")}})
         .when("method", std::string("midway"))
         .help(TR("The colour axes that midway blending treats one by one."))},
    Tool::Join<Settings>{make, check, bytes});

} // namespace texloom::blend

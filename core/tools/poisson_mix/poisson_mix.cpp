#include "core/match/gradient_mix.h"
#include "core/math/poisson.h"
#include "core/tools/tool.h"

#include <algorithm>

namespace texloom::poisson_mix {

namespace {

/// What holds at the border of the result.
enum class Border { Free, First, Wraps };

struct Settings {
    double preference = 1;
    Border border = Border::Free;
    bool perChannel = false;
};

PoissonBorder beyond(const Settings& settings) {
    return settings.border == Border::Wraps ? PoissonBorder::Wraps : PoissonBorder::NoFlux;
}

/// Only the pixels inside are unknown; those of the border are the first picture's.
Image withinBorder(const ImageView& first, const ImageView& sums, JobContext& context) {
    const int width = first.width, height = first.height;
    Image result(first);
    if (first.size().shorterSide() < 3)
        return result;
    std::vector<std::uint8_t> unknown(static_cast<std::size_t>(first.size().area()), 0);
    for (int y = 1; y < height - 1; ++y)
        std::fill_n(unknown.begin() + static_cast<std::ptrdiff_t>(y) * width + 1, width - 2, 1);
    std::vector<float> wanted;
    wanted.reserve(static_cast<std::size_t>(first.channels) * static_cast<std::size_t>(width - 2) *
                   static_cast<std::size_t>(height - 2));
    for (int c = 0; c < first.channels; ++c)
        for (int y = 1; y < height - 1; ++y)
            wanted.insert(wanted.end(), sums.plane(c).row(y) + 1, sums.plane(c).row(y) + width - 1);
    solvePoisson(unknown, wanted, result, [&](double share) {
        context.check();
        context.progress(share);
    });
    return result;
}

Image make(const JoinPictures& pictures, const Settings& settings, JobContext& context) {
    const ImageView& first = pictures.first;
    context.stage(0.1, TR("Choosing gradients"));
    const Image sums = mixedDivergence(
        first, pictures.second, {settings.preference, settings.perChannel, settings.border == Border::Wraps},
        context);
    context.stage(0.9, TR("Joining gradients"));
    Image result = settings.border == Border::First
                       ? withinBorder(first, sums, context)
                       : solvePoisson(sums, channelMeans(first, [&] { context.check(); }), beyond(settings),
                                      [&](double share) {
                                          context.check();
                                          context.progress(share);
                                      });
    context.progress(1);
    return result;
}

void check(const JoinPictures&, const Settings&) {}

std::uint64_t bytes(const JoinPictures& of, const Settings& settings) {
    const Size first = of.first.size();
    const int channels = of.first.channels;
    const auto area = static_cast<std::uint64_t>(first.area());
    const std::uint64_t pictures = 2 * Image::bytesFor(first, channels) + (1U << 20);
    if (settings.border == Border::First)
        return pictures + regionPoissonBytes(area, channels) + area;
    return pictures + wholePoissonBytes(first, beyond(settings));
}

ToolPreset way(std::string title, std::string help, bool perChannel, const char* border) {
    return {
        std::move(title), std::move(help), {{"per-channel", perChannel}, {"border", std::string(border)}}};
}

} // namespace

extern const Tool self;
const Tool self = tool<Settings>(
    {.title = TR("Mix by gradients"),
     .summary = TR("Lays the structure of one image over another: each pixel gets the stronger of the two "
                   "gradients. Suits a plain material and one with marks of the same kind."),
     .citation = "Pérez, Gangnet & Blake 2003; Raad, thesis 2016, section 5.8",
     .presets = {way(TR("All channels together"),
                     TR("The longer gradient over all channels: no colour that neither image has."), false,
                     "free"),
                 way(TR("Each channel for itself"),
                     TR("As the source prints it: channels may choose differently."), true, "free"),
                 way(TR("Border of the first"),
                     TR("The pixels at the border stay as they are in the first image."), false, "first"),
                 way(TR("Closed"), TR("Goes on over the border, for images that wrap."), false, "wrap")}},
    {field(&Settings::preference, "preference", TR("Preference"))
         .range(0.1, 10)
         .help(TR("Factor on the first image's gradients before they are compared: larger keeps more of the "
                  "first image.")),
     field(&Settings::border, "border", TR("Border"))
         .choices({{"free", TR("Free, mean of the first")},
                   {"first", TR("That of the first")},
                   {"wrap", TR("Closed")}})
         .help(TR("What holds at the border: nothing, and the mean is that of the first image; the pixels of "
                  "the first image; or that the image closes on itself.")),
     field(&Settings::perChannel, "per-channel", TR("Each channel for itself"))
         .help(TR("Each channel takes its own stronger gradient, as printed; otherwise the length over all "
                  "channels decides for the pixel, so that no false colours appear."))},
    Tool::Join<Settings>{make, check, bytes});

} // namespace texloom::poisson_mix

// A method that completes an image: what is not known of it is filled with the exemplar, repeated.

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/registry.h"

#include <algorithm>

namespace texloom::fill_hole {

namespace {

constexpr const char* kPicture = "picture";
constexpr const char* kKnown = "known";
constexpr int kRows = 16; ///< between two previews

struct Settings {
    double least = 0.5; ///< what a mask's value must be above for a pixel to be known
};

void check(const Request& request, const Settings&) {
    if ((request.inputs.image(kPicture) == nullptr) != (request.inputs.image(kKnown) == nullptr))
        failUsage("A picture and a mask of what is known of it belong together; give both, or neither.");
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const ImageView exemplar = *request.exemplars.front().image;
    const Image* const picture = request.inputs.image(kPicture);
    const Image* const known = request.inputs.image(kKnown);
    context.stage(1, TR("Filling"));
    Synthesis made;
    made.image = Image(request.size, request.channels());
    for (int begin = 0; begin < request.size.height; begin += kRows) {
        const int end = std::min(request.size.height, begin + kRows);
        context.parallel(begin, end, [&](int y) {
            for (int x = 0; x < request.size.width; ++x) {
                const bool kept = known && static_cast<double>((*known)(x, y, 0)) > settings.least;
                for (int c = 0; c < exemplar.channels; ++c)
                    made.image(x, y, c) =
                        kept ? (*picture)(x, y, c) : exemplar(x % exemplar.width, y % exemplar.height, c);
            }
        });
        context.preview(made.image);
        context.progress(static_cast<double>(end) / request.size.height);
    }
    return made;
}

Estimate estimate(const Request& request, const Settings&, int) {
    return {Image::bytesFor(request.size, request.channels()) + (1U << 20U),
            3e-9 * static_cast<double>(request.size.area())};
}

} // namespace

const Method self = method<Settings>(
    {.title = TR("Fill a hole"),
     .summary = TR("Fills what is not known of a picture with the exemplar, repeated."),
     .citation = "None: an example that completes an image",
     .category = Category::Tools,
     .takes = {ports::exemplar(),
               {.id = kPicture,
                .title = TR("Picture"),
                .help = TR("The image that is completed."),
                .extent = Extent::Output},
               {.id = kKnown,
                .title = TR("Known"),
                .help = TR("What of the picture is kept; the rest, where it is black, is filled."),
                .kind = AssetKind::Mask,
                .extent = Extent::Output}},
     .gives = {ports::image()},
     .usesSeed = false},
    {field(&Settings::least, "least", TR("Least"))
         .range(0, 1)
         .help(TR("What the mask must be above for a pixel to be kept: more fills soft edges, too."))},
    run, check, estimate);

namespace {
const Registration registered("fill-hole", self);
}

} // namespace texloom::fill_hole

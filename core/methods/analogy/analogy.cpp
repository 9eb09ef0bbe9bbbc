#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/channel_text.h"
#include "core/image/labels.h"
#include "core/methods/analogy/settings.h"
#include "core/methods/method.h"
#include "core/methods/pixel_fields.h"
#include "core/methods/pixel_request.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace texloom::analogy {

namespace {

constexpr std::string_view kGuidePort = "guide", kOutputGuidePort = "output-guide";

Port guide() {
    return {.id = std::string(kGuidePort),
            .title = TR("Picture A"),
            .help =
                TR("What the exemplar is made of, pixel for pixel: flat colours for its materials, or the "
                   "picture before a filter made the exemplar of it."),
            .extent = Extent::Exemplar};
}

Port outputGuide() {
    return {.id = std::string(kOutputGuidePort),
            .title = TR("Picture B"),
            .help = TR("What the result is to be made of, in the colours of picture A."),
            .extent = Extent::Output};
}

/// The options with the pictures of the request, if it has any.
CausalOptions optionsOf(const Request& request, const Settings& settings) {
    CausalOptions options = settings.options();
    const Image* const output = request.inputs.image(kOutputGuidePort);
    if (!output)
        return options;
    CausalGuides& guides = options.guides.emplace();
    guides.output = output;
    guides.weight = settings.guideWeight;
    for (const Exemplar& exemplar : request.exemplars)
        guides.exemplars.push_back(exemplar.inputs.image(kGuidePort));
    return options;
}

using Colours = std::set<labels::Colour>;

/// The colours of a picture that is painted flat; none if there are more than anyone would paint.
Colours flatColours(const Image& picture) {
    const auto colours = labels::flatColours(picture, labels::kMostColours);
    return colours ? Colours(colours->begin(), colours->end()) : Colours();
}

std::string textOf(const labels::Colour& colour) {
    return fmt::format("({:.3g})", fmt::join(colour, ", "));
}

/// Where both are painted flat, picture B has colours of picture A alone.
void checkColours(const Request& request, const Image& output) {
    Colours known;
    for (const Exemplar& exemplar : request.exemplars) {
        const Colours own = flatColours(*exemplar.inputs.image(kGuidePort));
        if (own.empty())
            return;
        known.insert(own.begin(), own.end());
    }
    std::vector<std::string> names;
    for (const labels::Colour& colour : known)
        names.push_back(textOf(colour));
    for (const labels::Colour& colour : flatColours(output))
        if (!known.contains(colour))
            failUsage("Picture B has the colour {}, which picture A has nowhere; paint it in A, too, or use "
                      "A's colours: {}.",
                      textOf(colour), listOf(names));
}

void check(const Request& request, const Settings& settings) {
    checkSquares(request, settings.options().side);
    const Image* const output = request.inputs.image(kOutputGuidePort);
    for (const Exemplar& exemplar : request.exemplars) {
        const Image* const own = exemplar.inputs.image(kGuidePort);
        if (!own && !output)
            continue;
        if (!own)
            failUsage("There is a picture B, but {} has no picture A; give both, or none.", exemplar.name);
        if (!output)
            failUsage("{} has a picture A, but there is no picture B; give both, or none.", exemplar.name);
        if (own->channels() != output->channels())
            failUsage("Picture A of {} has {} and picture B {}; they need the same number.", exemplar.name,
                      channelText(own->channels()), output->channels());
    }
    if (output)
        checkColours(request, *output);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    return CausalSynthesis::estimate(request, optionsOf(request, settings), threads);
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return CausalSynthesis(request, optionsOf(request, settings), context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Image analogies"),
     .summary = TR(
         "Makes what stands to picture B as the exemplar stands to picture A: paint the exemplar's materials "
         "as flat colours in A, and where they are to be in B. Without the pictures it makes more of the "
         "exemplar."),
     .citation = "Hertzmann et al., SIGGRAPH 2001",
     .category = Category::Pixels,
     .takes = {ports::exemplars(), ports::mask(), guide(), outputGuide()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {neighbourhoodField(&Settings::neighbourhood, 15), levelsField(&Settings::levels),
     field(&Settings::coherence, "coherence", TR("Coherence"))
         .range(0, 100)
         .symbol("κ")
         .help(TR("How much worse a pixel may fit that continues the copy beside it: larger copies larger "
                  "pieces, 0 takes whatever fits best.")),
     field(&Settings::guideWeight, "guide-weight", TR("Weight of A and B"))
         .range(0, 100)
         .help(TR("How much pictures A and B count beside the exemplar: larger follows them more closely.")),
     leafField(&Settings::leaf)},
    run, check, estimate);

} // namespace texloom::analogy

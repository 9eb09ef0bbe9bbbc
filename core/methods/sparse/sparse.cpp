#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/dictionary_fields.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"
#include "core/methods/sparse/cost.h"
#include "core/methods/sparse/synthesizer.h"

#include <utility>

namespace texloom::sparse {

namespace {

void check(const Request& request, const Settings& settings) {
    checkDictionaryRequest(request, settings.patch, settings.sparsity);
    if (settings.spacing > settings.patch)
        failUsage("The spacing of {} px leaves gaps between patches of {} px; choose at most {} px.",
                  settings.spacing, settings.patch, settings.patch);
    const Size exemplar = request.exemplars.front().image->size();
    if (settings.lowPass && settings.lowPassTarget == LowPassTarget::Exemplar && request.size != exemplar)
        failUsage("The exemplar's own low frequencies fit an output of its size, {} × {} px, and this one is "
                  "{} × {} px; choose random phases.",
                  exemplar.width, exemplar.height, request.size.width, request.size.height);
    // Where another method makes the dictionary, it is not there before the run.
    if (const auto model = request.inputs.first<Model>(kDictionaryPort))
        checkDictionaries(TextureDictionaries::from(*model), settings.patch, request.channels());
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    Estimate need{bytesFor(request, settings, threads), secondsFor(request, settings)};
    addEstimatedMap(request, need);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Synthesizer(request, settings, context).run();
}

std::vector<Param> energyFields() {
    return {
        field(&Settings::frequency, "frequency", TR("Frequencies of atoms"))
            .group(TR("Energy"))
            .help(TR("No atom is used more often than in the exemplar: brings all features back, and keeps "
                     "smooth patches from spreading.")),
        field(&Settings::reconstruction, "reconstruction", TR("Reconstruction"))
            .choices({{"cut", TR("Cuts")}, {"average", TR("Average")}})
            .group(TR("Energy"))
            .help(TR("How overlapping patches are put together: joined along cuts, which is sharp, or "
                     "averaged, which blurs.")),
        field(&Settings::histogram, "histogram", TR("Histogram"))
            .group(TR("Energy"))
            .help(TR("Draws the colours towards the exemplar's distribution.")),
        field(&Settings::alpha, "histogram-weight", TR("Weight of the histogram"))
            .range(0, 100)
            .usual(0, 4)
            .symbol("α")
            .when("histogram", true)
            .group(TR("Energy"))
            .help(TR("How much the distribution of colours counts against the patches.")),
        field(&Settings::colours, "colours", TR("Colour axes"))
            .choices({{"pca", TR("Principal axes")}, {"channels", TR("Channels")}})
            .when("histogram", true)
            .group(TR("Energy"))
            .help(TR("Along which axes colours are distributed as in the exemplar: principal axes keep how "
                     "channels go together.")),
        field(&Settings::lowPass, "low-pass", TR("Low frequencies"))
            .group(TR("Energy"))
            .help(TR("Draws what is larger than a patch towards a target, so that no large blotches arise.")),
        field(&Settings::beta, "low-pass-weight", TR("Weight of low frequencies"))
            .range(0, 100)
            .usual(0, 4)
            .symbol("β")
            .when("low-pass", true)
            .group(TR("Energy"))
            .help(TR("How much the low frequencies count against the patches.")),
        field(&Settings::lowPassTarget, "low-pass-target", TR("Low frequencies of"))
            .choices({{"auto", TR("Whatever fits")},
                      {"exemplar", TR("Exemplar")},
                      {"random-phase", TR("Random phase")}})
            .when("low-pass", true)
            .group(TR("Energy"))
            .help(TR("The exemplar itself, as published, gives its own layout of light and dark, and is only "
                     "possible at its size; random phases give a new one at any size. Whatever fits takes "
                     "the exemplar where sizes are the same and nothing wraps.")),
        field(&Settings::spectrum, "spectrum", TR("Spectrum"))
            .group(TR("Energy"))
            .help(TR("Draws the image towards the exemplar's Fourier spectrum: brings fine grain back, which "
                     "few atoms cannot code.")),
        field(&Settings::gamma, "spectrum-weight", TR("Weight of the spectrum"))
            .range(0, 100)
            .usual(0, 4)
            .symbol("γ")
            .when("spectrum", true)
            .group(TR("Energy"))
            .help(TR("How much the spectrum counts against the patches.")),
    };
}

std::vector<Param> params() {
    std::vector<Param> all = dictionaryPatchFields<Settings>();
    all.push_back(
        field(&Settings::spacing, "spacing", TR("Spacing"))
            .range(1, 32)
            .unit("px")
            .symbol("Δ")
            .help(TR("From one patch to the next, at most the patch size: closer is surer and takes "
                     "longer; half the patch is published.")));
    all.push_back(field(&Settings::iterations, "iterations", TR("Iterations"))
                      .range(1, 500)
                      .help(TR("Most rounds at each scale: more bring patches and image closer together.")));
    all.push_back(field(&Settings::gradientSteps, "gradient-steps", TR("Gradient steps"))
                      .range(1, 50)
                      .group(TR("Advanced"))
                      .help(TR("Steps of the image in each round, between two codings of its patches.")));
    all.push_back(
        field(&Settings::pursuit, "pursuit", TR("Pursuit"))
            .choices({{"plain", TR("Plain")}, {"orthogonal", TR("Orthogonal")}})
            .group(TR("Advanced"))
            .help(TR("How the weights of a patch's atoms are found: plain, as published, adds one "
                     "atom after another; orthogonal finds all weights again with every atom, which "
                     "follows the patch more closely and takes a little longer.")));
    for (auto& part : {energyFields(), dictionaryLearningFields<Settings>()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Sparse synthesis"),
     .summary = TR("Makes an image whose patches are each a sum of few learnt atoms, used as often as in the "
                   "exemplar. New pixels rather than copies; sharp on small structures such as scales, "
                   "weaves and cracks, and lost on large objects and on grain."),
     .citation = "Tartavel, Gousseau & Peyré, SSVM 2013; Tartavel, Gousseau & Peyré, JMIV 2015; "
                 "Peyré, JMIV 2009",
     .category = Category::Sparse,
     .suits = {.regular = 2, .grain = 2, .objects = 2, .large = 1},
     .takes = {ports::exemplar(), ports::mask(), ports::initial(), dictionaryInput()},
     .gives = {ports::wrappingImage()},
     .keepsCheckpoints = true},
    params(), run, check, estimate);

} // namespace texloom::sparse

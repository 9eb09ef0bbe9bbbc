#include "core/base/text.h"
#include "core/match/gaussian_patches.h"
#include "core/match/patch_grower.h"
#include "core/methods/locally_gaussian/settings.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

namespace texloom::locally_gaussian {

namespace {

constexpr double kMapWeight = 0.15;

/// Every patch is a sample of the Gaussian of the exemplar patches that fit best where it overlaps the
/// others.
class Sampler : public PatchGrower {
public:
    Sampler(const Request& request, const Settings& settings, JobContext& context)
        : PatchGrower(patchSources(request), layoutOf(request, settings), context,
                      PatchStitcher(settings.stitch, settings.patch)),
          m_settings(settings) {}

private:
    /// Draw 0 chooses the seed patch; the following draws are the Gaussian's coefficients.
    void make(const PatchCell& cell, Workspace& work) override {
        const std::vector<ImageView> patches = search().pixels(nearest(cell, m_settings.neighbours, work));
        drawPatch(patches, context().random(), cell, 2, m_settings.bounded, work.fresh);
        join(cell, work);
    }

    const Settings& m_settings;
};

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    Estimate need =
        growthEstimate(request, settings.patch, settings.overlapPixels(), threads, settings.contrast > 0);
    addEstimatedMap(request, need);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    Sampler sampler(request, settings, context);
    return grown(sampler, request, TR("Sampling patches"), kMapWeight, context);
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Locally Gaussian"),
     .summary = TR("Like quilting, but every patch is new: a random blend of the exemplar patches that fit "
                   "best. Innovates where quilting copies; a little softer."),
     .citation = "Raad, Desolneux & Morel, SSVM 2015; Raad, thesis 2016, algorithm 2",
     .category = Category::Patches,
     .suits = {.regular = 2, .grain = 3, .objects = 3, .large = 3},
     .takes = {ports::exemplars(), ports::mask()},
     .gives = {ports::wrappingImage()}},
    {patchField(&Settings::patch, 0.12)
         .help(TR("Side of the patches: larger keeps larger structures whole, smaller finds more that are "
                  "alike.")),
     neighboursField(&Settings::neighbours)
         .help(TR(
             "Similar patches that each new one is blended from: more vary more and blur more; 1 copies.")),
     overlapField(&Settings::overlap)
         .help(TR("Share of the patch that overlaps its neighbours: larger fits better and takes longer.")),
     field(&Settings::stitch, "stitch", TR("Stitch"))
         .choices(patchStitchChoices())
         .group(TR("Advanced"))
         .help(TR("How a patch joins its neighbours: along the cut of least error, or blended over the "
                  "overlap.")),
     contrastField(&Settings::contrast), boundedField(&Settings::bounded)},
    run, checkPatch, estimate);

} // namespace texloom::locally_gaussian

#include "core/base/text.h"
#include "core/job/pool.h"
#include "core/match/gaussian_patches.h"
#include "core/match/patch_canvas.h"
#include "core/match/patch_search.h"
#include "core/methods/locally_gaussian/settings.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

namespace texloom::locally_gaussian {

namespace {

constexpr double kMapWeight = 0.15;

/// Grows one output in raster order; every patch is a sample of the Gaussian of the exemplar patches that fit
/// best where it overlaps the others.
class Sampler {
public:
    Sampler(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context),
          m_search(
              patchSources(request), settings.patch, [&context] { context.check(); }, settings.contrast),
          m_canvas(request.size, request.wrap, request.channels(), settings.patch, settings.overlapPixels()),
          m_stitcher(settings.stitch, settings.patch) {}

    Synthesis run() {
        m_context.stage(0.02, TR("Preparing the exemplar"));
        for (const PatchCell& cell : m_canvas.grid().cells()) {
            m_search.prepare(compared(cell));
            m_stitcher.prepare(cell.overlap);
        }
        return grown(
            m_canvas, m_request, TR("Sampling patches"), kMapWeight,
            [this](const PatchCell& cell) { place(cell); }, m_context);
    }

private:
    struct Workspace {
        Image known, fresh;
        PatchStitcher::Scratch stitch;
        PatchSearch::Scratch search;
    };

    Footprint compared(const PatchCell& cell) const {
        // The seed patch is compared whole with the one that is drawn for it.
        return cell.overlap.none() ? Footprint::filled({m_settings.patch, m_settings.patch})
                                   : Footprint(cell.overlap);
    }

    /// Draw 0 chooses the seed patch; the Gaussian's coefficients are the following ones.
    void place(const PatchCell& cell) {
        const auto work = m_pool.borrow([this] {
            const Size patch{m_settings.patch, m_settings.patch};
            return Workspace{Image(patch, m_request.channels()), Image(patch, m_request.channels()),
                             m_stitcher.scratch(), m_search.scratch()};
        });
        m_canvas.read(cell, work->known);
        if (cell.overlap.none())
            work->known = Image(m_search.pixels(m_search.drawn(m_context.random().uniform(0, 0))));
        m_search.compute(work->known, compared(cell), work->search, [this] { m_context.check(); });
        const std::vector<ImageView> patches =
            m_search.pixels(m_search.nearest(m_settings.neighbours, work->search));
        combinePatches(patches, gaussianWeights(normalNumbers(m_context.random(), cell, patches.size(), 2)),
                       work->fresh);
        m_stitcher.join(work->known, cell.overlap, work->fresh, work->stitch);
        m_canvas.place(cell, work->fresh);
    }

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    PatchSearch m_search;
    PatchCanvas m_canvas;
    PatchStitcher m_stitcher;
    Pool<Workspace> m_pool;
};

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    Estimate need =
        growthEstimate(request, settings.patch, settings.overlapPixels(), threads, settings.contrast > 0);
    addEstimatedMap(request, need);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Sampler(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Locally Gaussian"),
     .summary = TR("Like quilting, but every patch is new: a random blend of the exemplar patches that fit "
                   "best. Innovates where quilting copies; a little softer."),
     .citation = "Raad, Desolneux & Morel, SSVM 2015; Raad, thesis 2016, algorithm 2",
     .category = Category::Patches,
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
     contrastField(&Settings::contrast)},
    run, checkPatch, estimate);

} // namespace texloom::locally_gaussian

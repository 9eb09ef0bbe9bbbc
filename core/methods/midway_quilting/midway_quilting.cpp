#include "core/base/text.h"
#include "core/job/pool.h"
#include "core/match/patch_canvas.h"
#include "core/match/patch_search.h"
#include "core/match/patch_stitch.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

namespace texloom::midway_quilting {

namespace {

constexpr double kMapWeight = 0.1;

/// Parameters of quilting with midway blending (Raad, thesis 2016, algorithm 11).
struct Settings {
    int patch = 40;
    double overlap = 0.25;
    double tolerance = 0.1;
    Propagation propagation = Propagation::Linear;
    BlendColor color = BlendColor::Dct;
    double contrast = 0; ///< see ContrastBalance::share

    int overlapPixels() const { return overlapFor(patch, overlap); }
};

/// Quilting whose patches are deformed in the middle of their overlaps until they agree.
class MidwayQuilter {
public:
    MidwayQuilter(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context),
          m_search(
              patchSources(request), settings.patch, [&context] { context.check(); }, settings.contrast),
          m_canvas(request.size, request.wrap, request.channels(), settings.patch, settings.overlapPixels()),
          m_stitcher(PatchStitch::Midway, settings.patch, {settings.propagation, settings.color}) {}

    Synthesis run() {
        m_context.stage(0.02, TR("Preparing the exemplar"));
        for (const PatchCell& cell : m_canvas.grid().cells()) {
            m_search.prepare(compared(cell));
            m_stitcher.prepare(cell.overlap);
        }
        if (m_request.initial())
            m_canvas.fill(*m_request.initial());
        return grown(
            m_canvas, m_request, TR("Placing patches"), kMapWeight,
            [this](const PatchCell& cell) { place(cell); }, m_context);
    }

private:
    struct Workspace {
        Image known;
        PatchStitcher::Scratch stitch;
        PatchSearch::Scratch search;
    };

    Footprint compared(const PatchCell& cell) const {
        return m_request.initial() ? Footprint::filled(m_canvas.visible(cell)) : Footprint(cell.overlap);
    }

    PatchPosition choose(const PatchCell& cell, Workspace& work) const {
        const Random& random = m_context.random();
        if (cell.overlap.none() && !m_request.initial())
            return m_search.drawn(random.uniform(cell.column, cell.row));
        m_search.compute(work.known, compared(cell), work.search, [this] { m_context.check(); });
        return m_search.drawn(m_search.within(m_settings.tolerance, work.search), random, cell.column,
                              cell.row);
    }

    void place(const PatchCell& cell) {
        const auto work = m_pool.borrow([this] {
            return Workspace{Image({m_settings.patch, m_settings.patch}, m_request.channels()),
                             m_stitcher.scratch(), m_search.scratch()};
        });
        m_canvas.read(cell, work->known);
        Image fresh(m_search.pixels(choose(cell, *work)));
        m_stitcher.join(work->known, cell.overlap, fresh, work->stitch);
        m_canvas.place(cell, fresh);
    }

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    PatchSearch m_search;
    PatchCanvas m_canvas;
    PatchStitcher m_stitcher;
    Pool<Workspace> m_pool;
};

/// What sorting and moving the mass of one patch's lines takes on a thread, with room for the allocator's
/// own.
constexpr std::uint64_t kScratchBytes = 4ULL << 20;

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    Estimate need =
        growthEstimate(request, settings.patch, settings.overlapPixels(), threads, settings.contrast > 0);
    need.bytes += static_cast<std::uint64_t>(threads) * kScratchBytes;
    need.seconds *= 1.5;
    addEstimatedMap(request, need);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return MidwayQuilter(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Midway quilting"),
     .summary =
         TR("Quilting that bends patches to meet instead of cutting them: structures such as stripes are "
            "drawn together along the overlap."),
     .citation = "Raad, thesis 2016, algorithm 11",
     .category = Category::Patches,
     .takes = {ports::weighedExemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage()}},
    {patchField(&Settings::patch, 0.16)
         .help(TR("Side of the squares that are copied: larger keeps larger structures whole, smaller varies "
                  "more.")),
     overlapField(&Settings::overlap)
         .help(TR("Share of the patch that overlaps its neighbours: larger bends more gently.")),
     toleranceField(&Settings::tolerance)
         .help(TR("How much worse than the best a patch may fit and still be drawn: larger varies more.")),
     field(&Settings::propagation, "propagation", TR("Propagation"))
         .choices({{"linear", TR("Linear")}, {"progressive", TR("Progressive")}})
         .group(TR("Advanced"))
         .help(TR("Whether the bending fades out over the overlap, or lines pass into each other.")),
     field(&Settings::color, "color", TR("Colour axes"))
         .choices({{"rgb", TR("Channels")}, {"dct", TR("Cosine")}, {"pca", TR("Principal axes")}})
         .group(TR("Advanced"))
         .help(TR("Axes that are bent one by one; channels as they are may show false colours.")),
     contrastField(&Settings::contrast)},
    run, checkPatch, estimate);

} // namespace texloom::midway_quilting

#include "core/base/text.h"
#include "core/match/patch_grower.h"
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
class MidwayQuilter : public PatchGrower {
public:
    MidwayQuilter(const Request& request, const Settings& settings, JobContext& context)
        : PatchGrower(
              patchSources(request), layoutOf(request, settings), context,
              PatchStitcher(PatchStitch::Midway, settings.patch, {settings.propagation, settings.color})),
          m_settings(settings), m_guided(request.initial() != nullptr) {
        if (m_guided)
            canvas().fill(*request.initial(), context);
    }

private:
    Footprint compared(const PatchCell& cell) const override {
        return m_guided ? Footprint::filled(canvas().visible(cell)) : Footprint(cell.overlap);
    }

    PatchPosition choose(const PatchCell& cell, Workspace& work) const {
        const Random& random = context().random();
        if (cell.overlap.none() && !m_guided)
            return search().drawn(random.uniform(cell.column, cell.row));
        compare(cell, work.known, work);
        return search().drawn(search().within(m_settings.tolerance, work.search), random, cell.column,
                              cell.row);
    }

    void make(const PatchCell& cell, Workspace& work) override {
        work.fresh = Image(search().pixels(choose(cell, work)));
        join(cell, work);
    }

    const Settings& m_settings;
    bool m_guided; ///< whether the canvas starts from an image
};

/// The memory that a thread needs for sorting and moving the mass of one patch's lines, with the allocator's
/// overhead.
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
    MidwayQuilter quilter(request, settings, context);
    return grown(quilter, request, TR("Placing patches"), kMapWeight, context);
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
     .suits = {.regular = 2, .grain = 3, .objects = 3, .large = 3},
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

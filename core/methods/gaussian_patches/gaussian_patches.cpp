#include "core/match/gaussian_patches.h"

#include "core/base/text.h"
#include "core/match/patch_grower.h"
#include "core/match/patch_quilter.h"
#include "core/match/patch_stitch.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace texloom::gaussian_patches {

namespace {

constexpr double kMapWeight = 0.15;
/// What the layout is quilted with, as image quilting is by default: patches as a share of the exemplar's
/// shorter side.
constexpr double kLayoutPatch = 0.16;
/// Share of the run that quilting the layout makes up.
constexpr double kLayoutWeight = 0.4;

/// What outputs that the exemplar does not cover are laid out by: a quilt of it, or its mirror images.
enum class Layout { Quilted, Mirrored };

/// Parameters of the replacement of patches by Gaussian samples (Raad, thesis 2016, algorithm 1).
struct Settings {
    int patch = 30;       ///< side n in pixels
    int neighbours = 10;  ///< m: patches that a Gaussian is learnt from
    double overlap = 0.5; ///< o as a share of the patch
    Layout layout = Layout::Quilted;
    double contrast = 1; ///< see ContrastBalance::share; 0 in the source

    int overlapPixels() const { return overlapFor(patch, overlap); }
};

/// Whether the exemplar itself cannot be the guide: it would be mirrored, which shows as a kaleidoscope.
bool laysOut(const Request& request, const Settings& settings) {
    const Size exemplar = request.exemplars.front().image->size();
    return settings.layout == Layout::Quilted && !request.initial() &&
           (request.wrap.x || request.wrap.y || request.size.width > exemplar.width ||
            request.size.height > exemplar.height);
}

QuiltOptions layoutOptions(const Request& request, const Settings& settings) {
    const int side = request.exemplars.front().image->size().shorterSide();
    QuiltOptions options;
    options.size = request.size;
    options.wrap = request.wrap;
    // Never larger than the patch that check() has found room for, unless the exemplar alone decides.
    options.patch = std::max(settings.patch, static_cast<int>(std::lround(kLayoutPatch * side)));
    if (!leavesWholePatch(request, options.patch) || (request.wrap.x && request.size.width < options.patch) ||
        (request.wrap.y && request.size.height < options.patch))
        options.patch = settings.patch;
    options.overlap = overlapFor(options.patch, QuiltOptions::kUsualOverlap);
    options.tolerance = QuiltOptions::kUsualTolerance;
    options.traced = false;
    options.contrast = QuiltOptions::kUsualContrast;
    options.variety = QuiltOptions::kUsualVariety;
    return options;
}

/// Replaces every patch of a guide by a sample of the Gaussian of the exemplar patches most similar to it.
/// The guide is the exemplar itself, mirrored beyond its borders, or the initial image.
class Replacer : public PatchGrower {
public:
    Replacer(const Request& request, const Settings& settings, JobContext& context)
        : PatchGrower(patchSources(request), layoutOf(request, settings), context), m_request(request),
          m_settings(settings),
          m_guide(request.size, request.wrap, request.channels(), settings.patch, settings.overlapPixels()) {
        if (request.initial())
            m_guide.fill(*request.initial(), context);
        else
            layOutExemplar();
    }

private:
    /// Without an initial image, the guide extends beyond the output.
    Footprint compared(const PatchCell& cell) const override {
        return Footprint::filled(m_request.initial() ? canvas().visible(cell) : patchSize());
    }

    /// Mirrored beyond its borders, and in the middle of an axis that wraps, so that the guide has no seam.
    void layOutExemplar() {
        const ImageView exemplar = *m_request.exemplars.front().image;
        Image& guide = m_guide.image();
        const auto from = [](int at, int length, bool wraps, int side) {
            return mirrored(wraps ? std::min(at, length - 1 - at) : at, side);
        };
        for (int c = 0; c < guide.channels(); ++c)
            for (int y = 0; y < guide.height(); ++y)
                for (int x = 0; x < guide.width(); ++x)
                    guide(x, y, c) = exemplar(from(x, guide.width(), m_request.wrap.x, exemplar.width),
                                              from(y, guide.height(), m_request.wrap.y, exemplar.height), c);
    }

    void make(const PatchCell& cell, Workspace& work) override {
        Image guide(patchSize(), m_request.channels());
        m_guide.read(cell, guide);
        compare(cell, guide, work);
        const std::vector<ImageView> patches =
            search().pixels(search().nearest(m_settings.neighbours, work.search));
        drawPatch(patches, context().random(), cell, 0, false, work.fresh);
    }

    void place(const PatchCell& cell, Workspace& work) override {
        Image weight(patchSize(), 1);
        rampWeights(cell.overlap, weight.plane(0));
        canvas().place(cell, work.known, work.fresh, weight.view().plane(0));
    }

    const Request& m_request;
    const Settings& m_settings;
    PatchCanvas m_guide;
};

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    Estimate need =
        growthEstimate(request, settings.patch, settings.overlapPixels(), threads, settings.contrast > 0);
    // The guide is a second canvas.
    need.bytes += PatchCanvas::bytesFor(request.size, request.wrap, request.channels(), settings.patch,
                                        settings.overlapPixels());
    addEstimatedMap(request, need);
    if (laysOut(request, settings)) {
        const QuiltOptions options = layoutOptions(request, settings);
        const Estimate quilt = growthEstimate(request, options.patch, options.overlap, threads, true);
        need.bytes += quilt.bytes + Image::bytesFor(request.size, request.channels());
        need.seconds += quilt.seconds;
    }
    return need;
}

/// The request with a quilt of the exemplar as the image to start from.
Request laidOut(const Request& request, const Settings& settings, JobContext& context) {
    const std::vector<PatchSource> exemplars = patchSources(request);
    const QuiltOptions options = layoutOptions(request, settings);
    Request guided = request;
    guided.inputs.set(kInitialPort, std::make_shared<const Image>(
                                        PatchQuilter(exemplars, options, context).run(kLayoutWeight).image));
    return guided;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    if (!laysOut(request, settings)) {
        Replacer replacer(request, settings, context);
        return grown(replacer, request, TR("Replacing patches"), kMapWeight, context);
    }
    const Request guided = laidOut(request, settings, context);
    Replacer replacer(guided, settings, context);
    replacer.prepare();
    context.stage(1 - kLayoutWeight - kMapWeight, TR("Replacing patches"));
    Synthesis result = withEstimatedMap(replacer.grow(), guided, kMapWeight, context);
    result.figures = {{TR("Patches"), static_cast<double>(replacer.patches())}};
    result.notes.push_back(
        message("{} does not cover the output, so its patches were first laid out by image "
                "quilting; give an initial image for a layout of your own.",
                request.exemplars.front().name));
    return result;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Gaussian patches"),
     .summary = TR("A variant of the exemplar itself, or of an initial image: every patch is replaced by a "
                   "random blend of the exemplar patches most like it. The layout stays."),
     .citation = "Raad, thesis 2016, algorithm 1",
     .category = Category::Patches,
     .suits = {.regular = 2, .grain = 2, .objects = 2, .large = 2},
     .takes = {ports::exemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage()}},
    {patchField(&Settings::patch, 0.12)
         .help(TR("Side of the patches that are replaced: larger changes larger parts at once.")),
     neighboursField(&Settings::neighbours)
         .help(TR("Similar patches that each new one is blended from: more vary more and blur more.")),
     overlapField(&Settings::overlap).help(TR("Share of the patch over which it fades into its neighbours.")),
     field(&Settings::layout, "layout", TR("Layout"))
         .choices({{"quilted", TR("Quilted")}, {"mirrored", TR("Mirrored")}})
         .group(TR("Advanced"))
         .help(
             TR("What an output that is larger than the exemplar, or wraps, is a variant of: a quilt of it, "
                "or its mirror images, which show as a kaleidoscope. An initial image takes their place.")),
     contrastField(&Settings::contrast)},
    run, checkPatch, estimate);

} // namespace texloom::gaussian_patches

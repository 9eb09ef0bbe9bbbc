#include "core/base/text.h"
#include "core/match/gaussian_patches.h"
#include "core/match/patch_grower.h"
#include "core/methods/conditional_gaussian/conditional_patch.h"
#include "core/methods/conditional_gaussian/settings.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

#include <cmath>

namespace texloom::conditional_gaussian {

namespace {

constexpr double kMapWeight = 0.1;
/// Draws of each kind begin here, at every place of the grid.
constexpr std::uint32_t kCoefficients = 2, kNoise = 1U << 16U;

/// The standard deviation over all exemplars and channels, each channel about its own mean.
double standardDeviation(const Request& request) {
    double squares = 0, count = 0;
    for (const Exemplar& exemplar : request.exemplars) {
        const ImageView image = *exemplar.image;
        const std::vector<double> means = channelMeans(image);
        for (int c = 0; c < image.channels; ++c)
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const double difference =
                        static_cast<double>(image(x, y, c)) - means[static_cast<std::size_t>(c)];
                    squares += difference * difference;
                }
        count += static_cast<double>(image.size().area()) * image.channels;
    }
    return std::sqrt(squares / count);
}

/// Every patch is drawn from the Gaussian of the exemplar patches that fit best, given the existing pixels.
class Sampler : public PatchGrower {
public:
    Sampler(const Request& request, const Settings& settings, JobContext& context)
        : PatchGrower(patchSources(request), layoutOf(request, settings), context), m_settings(settings),
          m_deviation(standardDeviation(request)) {}

private:
    void make(const PatchCell& cell, Workspace& work) override {
        const std::vector<ImageView> patches = search().pixels(nearest(cell, m_settings.neighbours, work));
        if (cell.overlap.none())
            drawPatch(patches, context().random(), cell, kCoefficients, m_settings.bounded, work.fresh);
        else
            condition(cell, patches, work);
    }

    void condition(const PatchCell& cell, const std::vector<ImageView>& patches, Workspace& work) const {
        const bool sampled = m_settings.choose == Choose::Sample;
        const auto noise = [&](int x, int y, int c) {
            const int at = (c * m_settings.patch + y) * m_settings.patch + x;
            return context().random().normal(cell.column, cell.row, kNoise + static_cast<std::uint32_t>(at));
        };
        if (sampled && m_settings.model == Model::Relaxed)
            addNoise(work.known, m_settings.theta / 100 * m_deviation, noise,
                     [&](int x, int y) { return cell.overlap.contains(x, y, m_settings.patch); });
        context().check();
        const double sigma = m_settings.sigma / 100 * m_deviation;
        conditionPatch(patches, work.known, cell.overlap,
                       {sigma, m_settings.border, m_settings.contrast, m_settings.bounded},
                       sampled ? normalNumbers(context().random(), cell, patches.size(), kCoefficients)
                               : std::vector<double>{},
                       work.fresh);
        context().check();
        if (sampled)
            addNoise(work.fresh, sigma, noise,
                     [&](int x, int y) { return !cell.overlap.contains(x, y, m_settings.patch); });
    }

    /// Adds white noise of a standard deviation where `where(x, y)` is true.
    template <class Noise, class Where>
    static void addNoise(Image& patch, double deviation, const Noise& noise, const Where& where) {
        for (int c = 0; c < patch.channels(); ++c)
            for (int y = 0; y < patch.height(); ++y)
                for (int x = 0; x < patch.width(); ++x)
                    if (where(x, y))
                        patch(x, y, c) += static_cast<float>(deviation * noise(x, y, c));
    }

    const Settings& m_settings;
    double m_deviation;
};

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const double values = static_cast<double>(settings.patch) * settings.patch * request.channels();
    const double neighbours = settings.neighbours;
    Estimate need =
        growthEstimate(request, settings.patch, settings.overlapPixels(), threads, settings.contrast > 0);
    need.bytes += static_cast<std::uint64_t>(
        threads * (values * (neighbours + 8) + 4 * neighbours * neighbours) * sizeof(double));
    need.seconds +=
        PatchCanvas::countFor(request.size, request.wrap, settings.patch, settings.overlapPixels()) * values *
        (1e-7 + neighbours * (neighbours + 10) * 4e-10);
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
    {.title = TR("Conditional Gaussian"),
     .summary = TR(
         "Continues what is there: every patch is drawn from the Gaussian of similar ones, given the pixels "
         "next to it. Suits grain, gravel and brick; patches are not stitched, so that their borders show on "
         "smooth objects such as scales or roof tiles."),
     .citation = "Raad, Desolneux & Morel, 2014; Raad, thesis 2016, algorithms 3 and 4",
     .category = Category::Patches,
     .suits = {.regular = 1, .grain = 2, .objects = 1, .large = 1},
     .takes = {ports::exemplars(), ports::mask()},
     .gives = {ports::wrappingImage()}},
    {patchField(&Settings::patch, 0.16)
         .help(TR("Side of the patches: larger keeps larger structures whole, smaller finds more that are "
                  "alike.")),
     neighboursField(&Settings::neighbours)
         .range(2, 300)
         .help(TR("Similar patches that a Gaussian is learnt from: more join more smoothly and blur more.")),
     overlapField(&Settings::overlap)
         .help(
             TR("Share of the patch that is given by its neighbours: larger fits better and takes longer.")),
     field(&Settings::border, "border", TR("Given border"))
         .range(0, 128)
         .unit("px")
         .help(TR("How wide a border of what is there a patch is drawn to continue: narrow keeps the "
                  "exemplar's contrast, wide fits more closely and fades; 0 gives all of it, as published.")),
     field(&Settings::model, "model", TR("Overlap values"))
         .choices({{"exact", TR("Kept (CLG)")}, {"relaxed", TR("Relaxed (RCLG)")}})
         .help(TR(
             "Pixels shared with neighbours stay as they are, or vary a little before the rest is drawn.")),
     field(&Settings::theta, "theta", TR("Relaxation"))
         .range(0, 100)
         .unit("%")
         .symbol("θ")
         .when("model", std::string("relaxed"))
         .help(TR("How far shared pixels may vary, in per cent of the exemplar's standard deviation.")),
     field(&Settings::choose, "choose", TR("Patch drawn"))
         .choices({{"sample", TR("A sample")}, {"most-probable", TR("The most probable")}})
         .group(TR("Advanced"))
         .help(TR("The most probable patch joins most smoothly and loses detail; samples differ each time.")),
     field(&Settings::sigma, "sigma", TR("Regularisation"))
         .range(0.01, 100)
         .unit("%")
         .symbol("σ")
         .group(TR("Advanced"))
         .help(
             TR("White noise added to the model, in per cent of the exemplar's standard deviation: more lets "
                "patches fit their neighbours less.")),
     contrastField(&Settings::contrast)
         .help(TR("How far flat patches are kept from winning where nothing fits well, and how far a sample "
                  "gets the contrast of the patches that it is drawn from: 1 holds the exemplar's contrast; "
                  "0 is as published, and outputs fade.")),
     boundedField(&Settings::bounded)},
    run, checkPatch, estimate);

} // namespace texloom::conditional_gaussian

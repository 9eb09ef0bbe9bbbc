#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/match/exemplar_pyramid.h"
#include "core/math/channel_pca.h"
#include "core/methods/method.h"
#include "core/methods/patch_distribution/matcher.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom::patch_distribution {

namespace {

/// The coarsest scale leaves so many patches side by side in the exemplar.
constexpr int kPatchesAcross = 2;
/// How far a pixel moves at most in one iteration, as a share of what its scale adds to the exemplar. It
/// falls to the last one, which takes the chance of the directions off.
constexpr double kPace = 0.5, kLastPace = 0.005;
/// What a scale adds counts as at least this share of the exemplar's whole deviation.
constexpr double kLeastReach = 0.1;
/// The same as kPace for the coarsest scale of an initial image, whose layout is kept.
constexpr double kInitialPace = 0.15;
/// Coarse scales decide on the layout and cost little: each has twice the iterations of the next finer one,
/// and none more than so many times those of the finest.
constexpr int kMostRepeats = 4;
/// Draws of noise lie beyond those of directions, which are 256 at most.
constexpr int kFirstNoise = 1024;

int scalesFor(const Request& request, const Settings& settings) {
    return std::min(settings.scales,
                    ExemplarPyramid::levelsFor(request.exemplarSizes(), kPatchesAcross * settings.patch));
}

int repeatsAt(int scale) {
    return std::min(kMostRepeats, 1 << scale);
}

/// Cost of a scale in terms of the finest one's.
double costOf(int scale) {
    return repeatsAt(scale) * std::pow(0.25, scale);
}

/// The output at a scale, large enough for a patch.
Size sizeAt(Size output, int scale, int patch) {
    const auto side = [&](int length) { return std::max((length + (1 << scale) - 1) >> scale, patch); };
    return {side(output.width), side(output.height)};
}

/// Makes the image in the exemplars' principal colours.
class Synthesizer {
public:
    Synthesizer(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context), m_means(commonMeans()),
          m_colours(commonCovariance()) {}

    Synthesis run() {
        if (m_colours.components() == 0)
            return withMap(constant());
        m_context.stage(0.02, TR("Preparing the exemplar"));
        std::vector<Image> projected;
        std::vector<PatchSource> sources = patchSources(m_request);
        for (PatchSource& source : sources) {
            projected.push_back(components(source.image));
            source.image = projected.back().view();
        }
        for (std::size_t e = 0; e < sources.size(); ++e)
            sources[e].image = projected[e].view();
        const ExemplarPyramid pyramid(sources, scalesFor(m_request, m_settings), m_settings.patch,
                                      [this] { m_context.check(); });
        Image image = start(pyramid.levels() - 1);
        double whole = 0;
        for (int scale = 0; scale < pyramid.levels(); ++scale)
            whole += costOf(scale);
        for (int scale = pyramid.levels() - 1; scale >= 0; --scale) {
            const Size size = sizeAt(m_request.size, scale, m_settings.patch);
            if (image.size() != size)
                image = enlarged(image, size);
            m_context.stage(0.9 * costOf(scale) / whole, TR("Matching patches"));
            match(pyramid, scale, image);
        }
        return withMap(colours(image));
    }

private:
    std::vector<double> commonMeans() const {
        std::vector<double> means(static_cast<std::size_t>(m_request.channels()), 0.0);
        double whole = 0;
        for (const Exemplar& exemplar : m_request.exemplars)
            whole += exemplar.weight;
        for (const Exemplar& exemplar : m_request.exemplars) {
            const std::vector<double> own = channelMeans(*exemplar.image, [this] { m_context.check(); });
            for (std::size_t c = 0; c < means.size(); ++c)
                means[c] += own[c] * exemplar.weight / whole;
        }
        return means;
    }

    Eigen::MatrixXd commonCovariance() const {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(m_request.channels(), m_request.channels());
        for (const Exemplar& exemplar : m_request.exemplars)
            sum += channelCovariance(*exemplar.image, [this] { m_context.check(); }) /
                   static_cast<double>(m_request.exemplars.size());
        return sum;
    }

    Image components(const ImageView& image) const {
        Image to(image.size(), m_colours.components());
        m_context.parallel(0, image.height, [&](int y) { m_colours.project(image, m_means, y, y + 1, to); });
        return to;
    }

    Image colours(const Image& image) const {
        Image to(image.size(), m_request.channels());
        m_context.parallel(0, image.height(),
                           [&](int y) { m_colours.unproject(image, m_means, y, y + 1, to); });
        to.shrink(m_request.size);
        return to;
    }

    Image constant() const {
        Image image(m_request.size, m_request.channels());
        for (int c = 0; c < image.channels(); ++c)
            for (int y = 0; y < image.height(); ++y)
                std::fill_n(image.plane(c).row(y), image.width(),
                            static_cast<float>(m_means[static_cast<std::size_t>(c)]));
        return image;
    }

    /// Noise, or the initial image at the coarsest scale.
    Image start(int scale) const {
        if (m_request.initial()) {
            Image image = components(*m_request.initial());
            for (int n = 0; n < scale; ++n)
                image = halved(image, [this] { m_context.check(); });
            return image;
        }
        Image image(sizeAt(m_request.size, scale, m_settings.patch), m_colours.components());
        for (int c = 0; c < image.channels(); ++c)
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    image(x, y, c) = static_cast<float>(
                        m_context.random().normal(x, -1 - y, static_cast<std::uint32_t>(c)));
        return image;
    }

    Image enlarged(const Image& image, Size size) const {
        Image large(size, image.channels());
        m_context.parallel(0, size.height, [&](int y) {
            for (int c = 0; c < image.channels(); ++c)
                enlargeRow(image.plane(c), size, y, large.plane(c).row(y));
        });
        return large;
    }

    /// The deviation of what a scale shows and the next coarser one does not, for each component: all of it
    /// at the coarsest.
    std::vector<double> detailOf(const ExemplarPyramid& pyramid, int scale) const {
        std::vector<double> squares(static_cast<std::size_t>(m_colours.components()), 0.0);
        double pixels = 0;
        for (std::size_t e = 0; e < pyramid.level(scale).size(); ++e) {
            const ImageView fine = pyramid.level(scale)[e].image;
            const Image coarse = scale + 1 == pyramid.levels()
                                     ? Image(fine.size(), fine.channels)
                                     : enlarged(Image(pyramid.level(scale + 1)[e].image), fine.size());
            pixels += static_cast<double>(fine.size().area());
            for (int y = 0; y < fine.height; ++y) {
                m_context.check();
                for (int c = 0; c < fine.channels; ++c)
                    for (int x = 0; x < fine.width; ++x) {
                        const double detail = static_cast<double>(fine(x, y, c)) - coarse(x, y, c);
                        squares[static_cast<std::size_t>(c)] += detail * detail;
                    }
            }
        }
        for (double& square : squares)
            square = std::sqrt(square / pixels);
        return squares;
    }

    /// How far pixels move. What is far from right, as between unlike exemplars, needs more than the detail.
    std::vector<double> reachOf(const ExemplarPyramid& pyramid, std::vector<double> detail) const {
        const std::vector<double> whole = detailOf(pyramid, pyramid.levels() - 1);
        for (std::size_t c = 0; c < detail.size(); ++c)
            detail[c] = std::max(detail[c], kLeastReach * whole[c]);
        return detail;
    }

    /// What the coarser scale could not hold begins as noise: without it fine grain would keep the blur of
    /// the coarse pixels.
    void addNoise(Image& image, const std::vector<double>& detail, int scale) const {
        m_context.parallel(0, image.height(), [&](int y) {
            for (int c = 0; c < image.channels(); ++c)
                for (int x = 0; x < image.width(); ++x)
                    image(x, y, c) += static_cast<float>(
                        detail[static_cast<std::size_t>(c)] *
                        m_context.random().normal(
                            x, y, static_cast<std::uint32_t>(kFirstNoise + scale * image.channels() + c)));
        });
    }

    void match(const ExemplarPyramid& pyramid, int scale, Image& image) {
        const std::vector<double> detail = detailOf(pyramid, scale);
        const bool coarsest = scale + 1 == pyramid.levels();
        if (!coarsest)
            addNoise(image, detail, scale);
        Matcher matcher(pyramid.level(scale), image.size(), m_request.wrap, m_settings,
                        reachOf(pyramid, detail), m_context);
        const double pace = coarsest && m_request.initial() ? kInitialPace : kPace;
        const int iterations = m_settings.iterations * repeatsAt(scale);
        for (int n = 0; n < iterations; ++n) {
            const double late = static_cast<double>(n) / iterations;
            m_distance = matcher.step(image, m_steps++, pace + late * (kLastPace - pace));
            m_context.curve(TR("Distance of patches"), m_distance);
            m_context.progress(static_cast<double>(n + 1) / iterations);
            if (m_context.previewDue())
                show(image, scale);
        }
    }

    /// Every pixel of a coarse scale stands for several of the output.
    void show(const Image& image, int scale) {
        m_context.preview(m_request.size, [&](Size size, int step) {
            Image picture(size, m_request.channels());
            Image chosen(size, image.channels());
            for (int c = 0; c < image.channels(); ++c)
                for (int y = 0; y < size.height; ++y)
                    for (int x = 0; x < size.width; ++x)
                        chosen(x, y, c) = image(std::min(image.width() - 1, (x * step) >> scale),
                                                std::min(image.height() - 1, (y * step) >> scale), c);
            m_colours.unproject(chosen, m_means, 0, size.height, picture);
            return picture;
        });
    }

    Synthesis withMap(Image image) {
        const double weight = m_colours.components() == 0 ? 1 : 0.08;
        Synthesis result = withEstimatedMap(std::move(image), m_request, weight, m_context);
        result.figures = {{TR("Distance of patches"), m_distance}};
        m_context.progress(1);
        return result;
    }

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    std::vector<double> m_means;
    ChannelPca m_colours;
    double m_distance = 0;
    int m_steps = 0; ///< over all scales
};

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const std::vector<Size> exemplars = request.exemplarSizes();
    const int channels = request.channels();
    const Size size = sizeAt(request.size, 0, settings.patch);
    Estimate need;
    need.bytes = Matcher::bytesFor(exemplars, size, channels, settings, threads) +
                 4 * Image::bytesFor(size, channels) + ExemplarPyramid::bytesFor(exemplars, channels) +
                 (4U << 20);
    double patches = 2 * static_cast<double>(size.area());
    for (const Size& exemplar : exemplars) {
        need.bytes += Image::bytesFor(exemplar, channels);
        patches += static_cast<double>(exemplar.area());
    }
    need.seconds = 2 * settings.iterations * settings.directions * patches *
                   (1.5e-10 * channels * settings.patch * settings.patch + 2e-8);
    addEstimatedMap(request, need);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Synthesizer(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Patch distribution"),
     .summary =
         TR("Changes noise, or an initial image, from coarse to fine until its patches are distributed as "
            "the exemplar's are. New pixels rather than copies; keeps all the exemplar's patches in use, "
            "and mixes several exemplars by their weights."),
     .citation = "Elnekave & Weiss, ECCV 2022; Rabin, Peyré, Delon & Bernot, SSVM 2011",
     .category = Category::Optimisation,
     .suits = {.regular = 2, .grain = 4, .objects = 3, .large = 2},
     .takes = {ports::weighedExemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage()}},
    {field(&Settings::patch, "patch", TR("Patch size"))
         .range(3, 31)
         .unit("px")
         .symbol("p")
         .help(
             TR("Side of the compared patches at each scale: larger keeps larger structures whole and takes "
                "longer.")),
     scalesField(&Settings::scales),
     field(&Settings::iterations, "iterations", TR("Iterations"))
         .range(1, 1000)
         .help(TR("At the finest scale, and up to four times as many at coarser ones: more bring the "
                  "patches closer to the exemplar's.")),
     field(&Settings::directions, "directions", TR("Directions"))
         .range(1, 256)
         .group(TR("Advanced"))
         .help(TR(
             "Random directions along which patches are compared in one iteration: more make each iteration "
             "surer and longer."))},
    run, checkPatch, estimate);

} // namespace texloom::patch_distribution

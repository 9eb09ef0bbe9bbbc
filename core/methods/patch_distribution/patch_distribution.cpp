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
constexpr int kPatchesAcross = 3;
/// At the end of a scale patches are moved less and less far, which takes the chance of the directions off.
constexpr double kPace = 0.8, kLastPace = 0.1, kSlowing = 0.5;

int scalesFor(const Request& request, const Settings& settings) {
    return std::min(settings.scales,
                    ExemplarPyramid::levelsFor(request.exemplarSizes(), kPatchesAcross * settings.patch));
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
        const double whole = 0.9 / (1 - std::pow(0.25, pyramid.levels()));
        for (int scale = pyramid.levels() - 1; scale >= 0; --scale) {
            const Size size = sizeAt(m_request.size, scale, m_settings.patch);
            if (image.size() != size)
                image = enlarged(image, size);
            m_context.stage(0.75 * whole * std::pow(0.25, scale), TR("Matching patches"));
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

    void match(const ExemplarPyramid& pyramid, int scale, Image& image) {
        Matcher matcher(pyramid.level(scale), image.size(), m_request.wrap, m_settings, m_context);
        const int steady = static_cast<int>((1 - kSlowing) * m_settings.iterations);
        for (int n = 0; n < m_settings.iterations; ++n) {
            const double late =
                static_cast<double>(std::max(0, n - steady)) / std::max(1, m_settings.iterations - steady);
            m_distance =
                matcher.step(image, scale * m_settings.iterations + n, kPace + late * (kLastPace - kPace));
            m_context.curve(TR("Distance of patches"), m_distance);
            m_context.progress(static_cast<double>(n + 1) / m_settings.iterations);
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
    need.seconds = 1.34 * settings.iterations * settings.directions * patches *
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
         .help(TR("At each scale: more bring the patches closer to the exemplar's.")),
     field(&Settings::directions, "directions", TR("Directions"))
         .range(1, 256)
         .group(TR("Advanced"))
         .help(TR(
             "Random directions along which patches are compared in one iteration: more make each iteration "
             "surer and longer."))},
    run, checkPatch, estimate);

} // namespace texloom::patch_distribution

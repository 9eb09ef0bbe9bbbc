#include "core/base/text.h"
#include "core/image/mirror.h"
#include "core/math/channel_pca.h"
#include "core/math/periodic_component.h"
#include "core/methods/heeger_bergen/band_stack.h"
#include "core/methods/heeger_bergen/settings.h"
#include "core/methods/method.h"
#include "core/methods/spectrum_fields.h"

#include <algorithm>
#include <cmath>

namespace texloom::heeger_bergen {

namespace {

/// Rows that one thread projects at a time.
constexpr int kRows = 32;

int scalesFor(const Request& request, const Settings& settings) {
    return commonScales(settings.scales, request.exemplars.front().image->size(), request.size,
                        request.wrap.x, request.wrap.y);
}

Size canvasFor(const Request& request, const Settings& settings) {
    return pyramidCanvas(request.size, request.wrap.x, request.wrap.y, scalesFor(request, settings));
}

/// The distributions of one component of the exemplar.
struct Target {
    Histogram pixels;
    std::vector<Histogram> parts;
};

/// Makes one texture (Briand et al., IPOL 2014, algorithm 4): each principal component separately alternates
/// between the pyramid and the pixels and takes on the exemplar's distribution in both.
class Synthesizer {
public:
    Synthesizer(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context),
          m_exemplar(*request.exemplars.front().image),
          m_means(channelMeans(m_exemplar, [&context] { context.check(); })),
          m_pca(channelCovariance(m_exemplar, [&context] { context.check(); })) {}

    Synthesis run();

private:
    void measure();
    void start();
    void iterate();
    double matchPixels(int component);
    Image channels(const Image& components);
    void show();
    template <class Body> void overRows(int height, const Body& body);

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    const Image& m_exemplar;
    std::vector<double> m_means;
    ChannelPca m_pca;
    std::vector<Target> m_targets;
    Image m_image; ///< components of the canvas
};

template <class Body> void Synthesizer::overRows(int height, const Body& body) {
    m_context.parallel(0, (height + kRows - 1) / kRows,
                       [&](int block) { body(block * kRows, std::min(height, (block + 1) * kRows)); });
}

Synthesis Synthesizer::run() {
    m_context.stage(0.05, TR("Measuring the exemplar"));
    Synthesis result;
    if (m_pca.components() == 0) {
        result.image = Image(m_request.size, m_request.channels());
        for (int c = 0; c < m_request.channels(); ++c)
            for (int y = 0; y < m_request.size.height; ++y)
                std::fill_n(result.image.plane(c).row(y), m_request.size.width,
                            static_cast<float>(m_means[static_cast<std::size_t>(c)]));
        m_context.stage(0.95, TR("Matching histograms"));
        m_context.progress(1);
        return result;
    }
    measure();
    m_context.stage(0.05, TR("Starting"));
    start();
    m_context.stage(0.9, TR("Matching histograms"));
    iterate();
    result.image = channels(m_image);
    result.image.shrink(m_request.size);
    result.figures = {{TR("Scales used"), static_cast<double>(scalesFor(m_request, m_settings))}};
    m_context.progress(1);
    return result;
}

void Synthesizer::measure() {
    const auto check = [this] { m_context.check(); };
    Image components(m_exemplar.size(), m_pca.components());
    overRows(m_exemplar.height(),
             [&](int first, int last) { m_pca.project(m_exemplar, m_means, first, last, components); });
    const Image learned = m_settings.periodic ? periodicComponent(components, check) : components;
    const SteerablePyramid pyramid(m_exemplar.size(), scalesFor(m_request, m_settings),
                                   m_settings.orientations, check);
    BandStack bands(pyramid, m_context);
    for (int c = 0; c < components.channels(); ++c) {
        Target& target = m_targets.emplace_back();
        target.pixels = Histogram(components.view().plane(c), check);
        target.parts.resize(static_cast<std::size_t>(bands.parts()));
        bands.analyse(learned.view().plane(c), false, [&](int part, const PlaneSpan& plane) {
            target.parts[static_cast<std::size_t>(part)] = Histogram(plane, check);
        });
        m_context.progress((c + 1.0) / components.channels());
    }
}

void Synthesizer::start() {
    m_image = Image(canvasFor(m_request, m_settings), m_pca.components());
    if (m_request.initial()) {
        // Beyond the output the canvas is filled with its mirror image, which has no jump.
        const Image& initial = *m_request.initial();
        Image padded(m_image.size(), initial.channels());
        overRows(m_image.height(), [&](int first, int last) {
            for (int c = 0; c < initial.channels(); ++c)
                for (int y = first; y < last; ++y)
                    for (int x = 0; x < m_image.width(); ++x)
                        padded(x, y, c) =
                            initial(mirrored(x, initial.width()), mirrored(y, initial.height()), c);
            m_pca.project(padded, m_means, first, last, m_image);
        });
    } else {
        overRows(m_image.height(), [&](int first, int last) {
            for (int c = 0; c < m_image.channels(); ++c)
                for (int y = first; y < last; ++y)
                    for (int x = 0; x < m_image.width(); ++x)
                        m_image(x, y, c) = static_cast<float>(
                            m_context.random().normal(x, y, static_cast<std::uint32_t>(c)));
        });
    }
    for (int c = 0; c < m_image.channels(); ++c) {
        show();
        matchPixels(c);
        m_context.progress((c + 1.0) / m_image.channels());
    }
}

/// @return the mean square of the change.
double Synthesizer::matchPixels(int component) {
    SampleRanks ranks;
    return m_targets[static_cast<std::size_t>(component)].pixels.match(m_image.plane(component), ranks,
                                                                       [this] { m_context.check(); });
}

void Synthesizer::iterate() {
    const auto check = [this] { m_context.check(); };
    const SteerablePyramid pyramid(m_image.size(), scalesFor(m_request, m_settings), m_settings.orientations,
                                   check);
    BandStack bands(pyramid, m_context);
    for (int iteration = 0; iteration < m_settings.iterations; ++iteration) {
        double change = 0;
        for (int c = 0; c < m_image.channels(); ++c) {
            show();
            bands.analyse(m_image.view().plane(c), true, [&](int part, const PlaneSpan& plane) {
                SampleRanks ranks;
                m_targets[static_cast<std::size_t>(c)].parts[static_cast<std::size_t>(part)].match(
                    plane, ranks, check);
            });
            bands.synthesise(m_image.plane(c));
            change += matchPixels(c);
            m_context.progress((iteration + (c + 1.0) / m_image.channels()) / m_settings.iterations);
        }
        m_context.curve(TR("Mismatch of the pixels' histogram"), std::sqrt(change / m_image.channels()));
    }
}

Image Synthesizer::channels(const Image& components) {
    Image image(components.size(), m_request.channels());
    overRows(components.height(),
             [&](int first, int last) { m_pca.unproject(components, m_means, first, last, image); });
    return image;
}

void Synthesizer::show() {
    m_context.preview(m_request.size, [this](Size size, int step) {
        Image sampled(size, m_image.channels());
        for (int c = 0; c < sampled.channels(); ++c)
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    sampled(x, y, c) = m_image(x * step, y * step, c);
        return channels(sampled);
    });
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size canvas = canvasFor(request, settings);
    const Size exemplar = request.exemplars.front().image->size();
    const int scales = scalesFor(request, settings), channels = request.channels();
    const auto needAt = [&](Size size) {
        return SteerablePyramid::bytesFor(size, scales, settings.orientations) +
               BandStack::bytesFor(size, scales, settings.orientations, threads) +
               2 * Image::bytesFor(size, channels);
    };
    const double parts = settings.orientations * 4.0 / 3 + 2;
    const auto pixels = static_cast<double>(canvas.area());
    Estimate need;
    // The exemplar's distributions stay in memory while the canvas is processed.
    const std::uint64_t distributions =
        static_cast<std::uint64_t>(parts + 1) * Image::bytesFor(exemplar, channels);
    need.bytes =
        std::max(needAt(exemplar) + Image::bytesFor(exemplar, channels), needAt(canvas)) + distributions;
    need.seconds = settings.iterations * channels * parts * pixels * (3e-8 + 1.5e-9 * std::log2(pixels));
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Synthesizer(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Heeger–Bergen"),
     .summary =
         TR("Gives noise the exemplar's histogram in every band of a steerable pyramid. Quick and free of "
            "copies; suits grainy and stochastic textures, and loses structure."),
     .citation = "Heeger & Bergen, SIGGRAPH 1995; Briand, Vacher, Galerne & Rabin, IPOL 2014",
     .category = Category::Statistics,
     .suits = {.grain = 2},
     .takes = {ports::exemplar(), ports::initial()},
     .gives = {ports::wrappingImage()}},
    {octavesField(&Settings::scales).symbol("P"), orientationsField(&Settings::orientations).symbol("Q"),
     field(&Settings::iterations, "iterations", TR("Iterations"))
         .range(1, 200)
         .help(TR("Rounds between pyramid and pixels: more bring both closer to the exemplar.")),
     periodicField(&Settings::periodic)},
    run, estimate);

} // namespace texloom::heeger_bergen

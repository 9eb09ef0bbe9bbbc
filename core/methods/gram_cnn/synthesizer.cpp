#include "core/methods/gram_cnn/synthesizer.h"

#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/image/mirror.h"
#include "core/math/byte_state.h"
#include "core/math/histogram.h"
#include "core/methods/gram_cnn/minimiser.h"
#include "core/methods/patch_request.h"
#include "core/network/picture_tensor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom::gram_cnn {

namespace {

/// The exemplars' shortest side at the coarsest scale.
constexpr int kCoarsestSide = 32;
/// Where the output need not wrap, what is optimised is rounded up to this.
constexpr int kCanvasUnit = 16, kLeastCanvas = 32;
/// Between checkpoints, for each byte of one: the larger they are, the fewer.
constexpr double kSecondsAByte = 6e-8;
constexpr Edges kClosed{Padding::Circular, Padding::Circular};

int canvasSide(int length, bool wraps) {
    return wraps ? length : std::max(kLeastCanvas, (length + kCanvasUnit - 1) / kCanvasUnit * kCanvasUnit);
}

Size scaled(Size size, int scale) {
    const auto side = [&](int length) { return (length + (1 << scale) - 1) >> scale; };
    return {side(size.width), side(size.height)};
}

/// The values of all exemplars' planes of one channel, one after another.
std::vector<float> joined(const std::vector<Tensor>& tensors, int c) {
    std::vector<float> all;
    for (const Tensor& tensor : tensors)
        all.insert(all.end(), tensor.channel(c), tensor.channel(c) + tensor.area());
    return all;
}

} // namespace

int scalesFor(const Request& request, const Settings& settings) {
    int least = std::numeric_limits<int>::max();
    for (const Size& size : request.exemplarSizes())
        least = std::min({least, size.width, size.height});
    int scales = 1;
    while (scales < settings.scales && (least >> scales) >= kCoarsestSide)
        ++scales;
    return scales;
}

Size canvasAt(const Request& request, int scale) {
    return scaled(
        {canvasSide(request.size.width, request.wrap.x), canvasSide(request.size.height, request.wrap.y)},
        scale);
}

Synthesizer::Synthesizer(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context), m_colours(request, context),
      m_scales(scalesFor(request, settings)) {}

Synthesis Synthesizer::run() {
    constexpr double kPreparing = 0.05, kMapping = 0.05;
    m_context.stage(kPreparing, TR("Preparing the descriptor"));
    if (m_colours.components() == 0)
        return finish();
    prepare();
    int scale = m_scales - 1, first = 0;
    std::string minimiser;
    const std::string* const earlier = m_context.resumed();
    if (earlier) {
        StateReader from(*earlier);
        scale = std::clamp(from.number<int>(), 0, m_scales - 1);
        first = from.number<int>();
        minimiser = std::string(from.text());
    }
    m_components = start(scale);
    const double whole = (1 - kPreparing - kMapping) * 0.75 / (1 - std::pow(0.25, m_scales));
    for (int s = m_scales - 1; s >= 0; --s) {
        m_context.stage(whole * std::pow(0.25, s), TR("Matching feature maps"));
        if (s > scale)
            continue;
        if (s < scale)
            enlarge(s);
        optimise(s, s == scale ? first : 0, earlier && s == scale ? &minimiser : nullptr);
    }
    return finish();
}

/// The descriptor, and the exemplars at each scale.
void Synthesizer::prepare() {
    m_descriptor = chosenDescriptor(m_request, m_settings.descriptor, m_context);
    m_exemplars.resize(at(m_scales));
    for (const Exemplar& exemplar : m_request.exemplars) {
        m_exemplars.front().push_back(tensorOf(*exemplar.image));
        Image image;
        for (int scale = 1; scale < m_scales; ++scale) {
            m_context.check();
            image = halved(scale == 1 ? exemplar.image->view() : image.view(), [this] { m_context.check(); });
            m_exemplars[at(scale)].push_back(tensorOf(image));
        }
    }
}

/// Noise with the exemplar's colours, or the initial image, which is mirrored beyond its edges.
Tensor Synthesizer::start(int scale) {
    const Size size = canvasAt(m_request, scale);
    if (const Image* const initial = m_request.initial()) {
        const Size canvas = canvasAt(m_request, 0);
        Image image(canvas, m_request.channels());
        for (int c = 0; c < image.channels(); ++c)
            for (int y = 0; y < canvas.height; ++y)
                for (int x = 0; x < canvas.width; ++x)
                    image(x, y, c) =
                        (*initial)(mirrored(x, initial->width()), mirrored(y, initial->height()), c);
        for (int n = 0; n < scale; ++n)
            image = halved(image, [this] { m_context.check(); });
        return m_colours.componentsOf(tensorOf(image), m_context);
    }
    Tensor components(m_colours.components(), size.height, size.width);
    for (int c = 0; c < components.channels(); ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                components.row(c, y)[x] =
                    static_cast<float>(m_context.random().normal(x, y, static_cast<std::uint32_t>(c)));
    return components;
}

/// Brings what is optimised to the size of a scale.
void Synthesizer::enlarge(int scale) {
    const Size size = canvasAt(m_request, scale);
    if (m_components.width() == size.width && m_components.height() == size.height)
        return;
    const Tensor from = std::move(m_components);
    m_components = Tensor(from.channels(), size.height, size.width);
    m_context.parallel(0, size.height, [&](int y) {
        for (int c = 0; c < from.channels(); ++c)
            enlargeRow({from.channel(c), from.width(), from.height(), from.width()}, size, y,
                       m_components.row(c, y));
    });
}

TextureLoss Synthesizer::lossAt(int scale) {
    std::vector<LossExemplar> learned;
    for (std::size_t e = 0; e < m_request.exemplars.size(); ++e)
        learned.push_back({&m_exemplars[at(scale)][e], m_request.exemplars[e].weight});
    return {m_descriptor, m_settings.lossOptions(m_descriptor), learned, m_context};
}

/// The loss of the picture that has these components, and its derivative by them.
double Synthesizer::evaluate(TextureLoss& loss, std::span<const float> x, std::span<float> gradient) {
    std::copy(x.begin(), x.end(), m_components.data());
    m_colours.toValues(m_components, m_picture, m_context);
    const double value = loss.evaluate(m_picture, kClosed, &m_pictureGradient, m_context);
    m_colours.toComponents(m_pictureGradient, m_gradient, m_context);
    std::copy_n(m_gradient.data(), m_gradient.size(), gradient.begin());
    return value;
}

void Synthesizer::optimise(int scale, int first, const std::string* earlier) {
    TextureLoss loss = lossAt(scale);
    Minimiser minimiser(m_settings, {m_components.data(), m_components.data() + m_components.size()});
    if (earlier) {
        minimiser.takeUp(*earlier);
        std::copy(minimiser.x().begin(), minimiser.x().end(), m_components.data());
    }
    const Objective objective = [&](std::span<const float> x, std::span<float> gradient) {
        return evaluate(loss, x, gradient);
    };
    const std::chrono::milliseconds pause(
        static_cast<int>(1000 * kSecondsAByte *
                         static_cast<double>(Lbfgs::bytesFor(m_components.size(), Minimiser::kHistory))));
    for (int n = first; n < m_settings.iterations; ++n) {
        const bool further = minimiser.step(objective);
        std::copy(minimiser.x().begin(), minimiser.x().end(), m_components.data());
        m_brokeDown = m_brokeDown || !std::isfinite(minimiser.value());
        if (!further)
            break;
        m_value = minimiser.value();
        report(loss, scale, n);
        m_context.checkpoint(pause, [&] {
            StateWriter to;
            to.add(scale);
            to.add(n + 1);
            to.add(minimiser.state());
            return to.take();
        });
    }
    m_context.progress(1);
}

void Synthesizer::report(const TextureLoss& loss, int scale, int iteration) {
    m_context.curve(TR("Loss"), m_value);
    for (std::size_t i = 0; i < loss.terms().size(); ++i)
        m_context.curve(Message::verbatim(loss.termNames()[i]), loss.terms()[i]);
    m_context.progress((iteration + 1.0) / m_settings.iterations);
    if (m_context.previewDue())
        show(scale);
}

/// Every pixel of a coarse scale stands for several of the output.
void Synthesizer::show(int scale) {
    m_colours.toValues(m_components, m_picture, m_context);
    m_context.preview(m_request.size, [&](Size size, int step) {
        Image picture(size, m_request.channels());
        for (int c = 0; c < picture.channels(); ++c)
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    picture(x, y, c) = m_picture.row(
                        c,
                        std::min(m_picture.height() - 1,
                                 (y * step) >> scale))[std::min(m_picture.width() - 1, (x * step) >> scale)];
        return picture;
    });
}

/// Gives each component the exemplars' distribution.
void Synthesizer::matchHistograms() {
    std::vector<Tensor> wanted;
    for (const Tensor& exemplar : m_exemplars.front())
        wanted.push_back(m_colours.componentsOf(exemplar, m_context));
    const auto check = [this] { m_context.check(); };
    SampleRanks ranks;
    for (int c = 0; c < m_components.channels(); ++c) {
        const std::vector<float> values = joined(wanted, c);
        const int count = static_cast<int>(values.size());
        Histogram({values.data(), count, 1, count}, check)
            .match(
                {m_components.channel(c), m_components.width(), m_components.height(), m_components.width()},
                ranks, check);
    }
}

/// What the components show, within the exemplars' values.
Image Synthesizer::image() {
    if (m_settings.histogram)
        matchHistograms();
    m_colours.toValues(m_components, m_picture, m_context);
    for (int c = 0; c < m_picture.channels(); ++c) {
        const std::vector<float> values = joined(m_exemplars.front(), c);
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        for (std::size_t i = 0; i < m_picture.area(); ++i)
            m_picture.channel(c)[i] = std::clamp(m_picture.channel(c)[i], *low, *high);
    }
    Image image = imageOf(m_picture);
    image.shrink(m_request.size);
    return image;
}

Image Synthesizer::constant() const {
    Image image(m_request.size, m_request.channels());
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y)
            std::fill_n(image.plane(c).row(y), image.width(), static_cast<float>(m_colours.means()[at(c)]));
    return image;
}

Synthesis Synthesizer::finish() {
    const bool constantColour = m_colours.components() == 0;
    Synthesis result = withEstimatedMap(constantColour ? constant() : image(), m_request,
                                        constantColour ? 0.95 : 0.05, m_context);
    if (!constantColour) {
        result.figures = {{TR("Loss"), m_value}};
        result.notes.push_back(descriptorNote(m_descriptor));
    }
    if (m_brokeDown)
        result.notes.emplace_back(
            TR("A step gave values that are not numbers: the optimisation ended with the last that are."));
    m_context.progress(1);
    return result;
}

} // namespace texloom::gram_cnn

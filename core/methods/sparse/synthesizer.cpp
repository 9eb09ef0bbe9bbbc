#include "core/methods/sparse/synthesizer.h"

#include "core/base/at.h"
#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/image/mirror.h"
#include "core/methods/dictionary_fields.h"
#include "core/methods/patch_request.h"
#include "core/methods/sparse/cost.h"
#include "core/methods/sparse/enlarged_cubic.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

namespace texloom::sparse {

namespace {

/// A scale ends where so many iterations have not brought the energy down by this share. With cuts it may
/// rise in between.
constexpr double kConverged = 1e-3;
constexpr int kPatience = 5;
/// δ of the cuts, as a share of the exemplar's squared range (for each channel).
constexpr float kFlat = 1e-4F;
constexpr double kMapWeight = 0.05, kPreparing = 0.01;
/// Share of a scale's time that learning takes.
constexpr double kLearning = 0.4;
/// Checkpoints are as far apart as what they hold is large.
std::chrono::milliseconds checkpointPause(Size size) {
    return std::chrono::milliseconds(250 + size.area() / 2000);
}

template <class T> void append(std::string& state, const T& value) {
    state.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T> void take(const char*& from, T& value) {
    std::memcpy(&value, from, sizeof value);
    from += sizeof value;
}

} // namespace

struct Synthesizer::Level {
    Level(const Synthesizer& owner, int scale)
        : dictionary(owner.m_dictionaries.scales[at(scale)]),
          columns(owner.m_image.size(), owner.m_request.wrap, owner.m_settings.patch,
                  owner.m_settings.spacing) {
        const Settings& settings = owner.m_settings;
        const int side = (settings.patch + settings.spacing - 1) / settings.spacing;
        overlaps = side * side;
        limits.most = std::min(settings.sparsity, dictionary.length());
        limits.pursuit = settings.pursuit;
        if (settings.frequency) {
            std::vector<double> shares;
            for (const std::int64_t uses : dictionary.uses)
                shares.push_back(static_cast<double>(uses) * columns.count() /
                                 static_cast<double>(dictionary.signals));
            limits.uses = roundedShares(shares);
        }
        const PatchSource& exemplar = owner.m_pyramid->level(scale).front();
        delta = owner.flatness(scale);
        if (settings.histogramWeight() > 0)
            histogram.emplace(exemplar, settings.colours == Axes::Pca, owner.m_context);
        if (settings.lowPassWeight() > 0)
            lowPass.emplace(owner.target(scale), owner.m_request.wrap, settings.patch);
        if (settings.spectrumWeight() > 0) {
            Image learned = owner.m_filled;
            for (int i = 0; i < scale; ++i)
                learned = halved(learned, [&owner] { owner.m_context.check(); });
            spectrum.emplace(learned, owner.m_image.size(), owner.m_context);
        }
    }

    const Dictionary& dictionary;
    PatchColumns columns;
    int overlaps; ///< Z
    PursuitLimits limits;
    float delta;
    std::optional<HistogramTerm> histogram;
    std::optional<LowPassTerm> lowPass;
    std::optional<SpectrumTerm> spectrum;
};

double Synthesizer::stepFor(const Settings& settings, double covering) {
    return 0.5 /
           (covering + settings.histogramWeight() + settings.lowPassWeight() + settings.spectrumWeight());
}

Synthesizer::Synthesizer(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context) {}

Synthesis Synthesizer::run() {
    m_context.stage(kPreparing, TR("Preparing the exemplar"));
    prepare();
    const int scales = m_pyramid->levels();
    const double whole = (1 - std::pow(0.25, scales)) / 0.75;
    for (int j = scales - 1; j >= 0; --j) {
        const double weight = (1 - kMapWeight - kPreparing) / whole * std::pow(0.25, j);
        learn(j, m_given ? 0 : kLearning * weight);
        work(j, m_given ? weight : (1 - kLearning) * weight);
    }
    return finished();
}

void Synthesizer::prepare() {
    const Exemplar& exemplar = m_request.exemplars.front();
    int scales = scalesFor(m_request, m_settings);
    if (const auto model = m_request.inputs.first<Model>(kDictionaryPort)) {
        m_dictionaries = TextureDictionaries::from(*model);
        checkDictionaries(m_dictionaries, m_settings.patch, m_request.channels());
        scales = std::min(scales, static_cast<int>(m_dictionaries.scales.size()));
        m_given = true;
    } else {
        m_dictionaries.patch = m_settings.patch;
        m_dictionaries.origin = dictionaryOrigin(exemplar, m_settings.centred, m_context);
    }
    m_exemplar = shifted(*exemplar.image, m_dictionaries.origin, -1, m_context);
    m_sources = patchSources(m_request);
    m_sources.front().image = m_exemplar.view();
    m_pyramid.emplace(m_sources, scales, m_settings.patch, [this] { m_context.check(); });
    if (!m_given)
        m_dictionaries.scales.resize(at(m_pyramid->levels()));
    m_filled = filled();
    m_scale = m_pyramid->levels() - 1;
    if (const std::string* const earlier = m_context.resumed())
        resume(*earlier);
}

/// The exemplar with its mean where the mask hides it, for what needs every pixel.
Image Synthesizer::filled() const {
    Image image(m_exemplar);
    const Exemplar& exemplar = m_request.exemplars.front();
    if (!exemplar.mask())
        return image;
    const std::vector<float> mean = dictionaryOrigin(exemplar, true, m_context);
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if ((*exemplar.mask())(x, y, 0) == 0)
                    image(x, y, c) = mean[at(c)] - m_dictionaries.origin[at(c)];
    return image;
}

void Synthesizer::learn(int scale, double weight) {
    m_context.stage(weight, message("Learning at scale 1/{}", 1 << scale));
    Dictionary& dictionary = m_dictionaries.scales[at(scale)];
    if (dictionary.count() == 0) {
        const bool drafts = m_image.empty();
        if (drafts && m_context.previewDue())
            m_image = firstDraft(scale);
        show();
        TextureDictionaryOptions options = learningOf(m_settings, scale);
        options.learning.pursuit = m_settings.pursuit;
        dictionary =
            learnTexture(m_pyramid->level(scale).front(), options, m_context,
                         [&](int rounds, double, const Eigen::MatrixXf& atoms) {
                             m_context.progress(static_cast<double>(rounds) / m_settings.learningIterations);
                             if (drafts && m_context.previewDue())
                                 m_image = nextDraft(scale, atoms);
                             show();
                         });
        if (drafts)
            m_image = Image();
    }
    m_context.progress(1);
}

/// What is shown before anything is learnt: the exemplar's colours and spectrum with random phases.
Image Synthesizer::firstDraft(int scale) const {
    Image image = randomPhaseOf(m_filled, canvasFor(m_request, m_settings), m_request.wrap,
                                m_context.random(), m_context);
    for (int i = 0; i < scale; ++i)
        image = halved(image, [this] { m_context.check(); });
    return image;
}

/// What is shown while the first dictionary is learnt: the draft put together from the atoms there are. The
/// result does not depend on it.
Image Synthesizer::nextDraft(int scale, const Eigen::MatrixXf& atoms) const {
    if (m_image.empty())
        return firstDraft(scale);
    const PatchColumns columns(m_image.size(), m_request.wrap, m_settings.patch, m_settings.spacing);
    const int most = std::min(m_settings.sparsity, static_cast<int>(atoms.rows()));
    const SparseCode code = constrainedPursuit(atoms, columns.of(m_image), {most, {}}, m_context);
    Image joined(m_image.size(), m_image.channels());
    columns.cut([&](int number, const Eigen::Ref<Eigen::VectorXf>& to) { code.combine(atoms, number, to); },
                flatness(scale), m_context, joined);
    return joined;
}

/// δ of the cuts.
float Synthesizer::flatness(int scale) const {
    const ImageView& exemplar = m_pyramid->level(scale).front().image;
    const ValueRange range = valueRange(exemplar);
    return kFlat * (range.largest - range.smallest) * (range.largest - range.smallest) *
           static_cast<float>(exemplar.channels);
}

/// The exemplar itself, where it has the output's size and borders, else a random phase version of it.
Image Synthesizer::target(int scale) const {
    const Size canvas = canvasFor(m_request, m_settings);
    const bool same = canvas == m_exemplar.size();
    const bool own =
        same && (m_settings.lowPassTarget == LowPassTarget::Exemplar ||
                 (m_settings.lowPassTarget == LowPassTarget::Auto && !m_request.wrap.x && !m_request.wrap.y));
    Image image = own ? Image(m_filled)
                      : randomPhaseOf(m_filled, canvas, m_request.wrap, m_context.random(), m_context);
    for (int i = 0; i < scale; ++i)
        image = halved(image, [this] { m_context.check(); });
    return image;
}

void Synthesizer::startFromNoise(int scale) {
    const PatchSource& exemplar = m_pyramid->level(scale).front();
    const std::vector<double> means = channelMeans(exemplar.image);
    for (int c = 0; c < m_image.channels(); ++c) {
        double squares = 0;
        for (int y = 0; y < exemplar.image.height; ++y)
            for (int x = 0; x < exemplar.image.width; ++x) {
                const double apart = static_cast<double>(exemplar.image(x, y, c)) - means[at(c)];
                squares += apart * apart;
            }
        const double deviation = std::sqrt(squares / static_cast<double>(exemplar.image.size().area()));
        m_context.parallel(0, m_image.height(), [&](int y) {
            for (int x = 0; x < m_image.width(); ++x)
                m_image(x, y, c) =
                    static_cast<float>(means[at(c)] + deviation * m_context.random().normal(
                                                                      x, y, static_cast<std::uint32_t>(c)));
        });
    }
}

/// The image that a scale starts from.
void Synthesizer::begin(int scale) {
    const Size size = sizeAt(scale, canvasFor(m_request, m_settings));
    if (scale + 1 < m_pyramid->levels()) {
        m_image = enlargedCubic(m_image, size, m_request.wrap, m_context);
        return;
    }
    m_image = Image(size, m_request.channels());
    if (!m_request.initial())
        return startFromNoise(scale);
    // Beyond the output the canvas continues it by its mirror image, which has no jump.
    const Image own = shifted(*m_request.initial(), m_dictionaries.origin, -1, m_context);
    const Size canvas = canvasFor(m_request, m_settings);
    Image whole(canvas, own.channels());
    m_context.parallel(0, canvas.height, [&](int y) {
        for (int c = 0; c < own.channels(); ++c)
            for (int x = 0; x < canvas.width; ++x)
                whole(x, y, c) = own(mirrored(x, own.width()), mirrored(y, own.height()), c);
    });
    for (int i = 0; i < scale; ++i)
        whole = halved(whole, [this] { m_context.check(); });
    m_image = std::move(whole);
}

void Synthesizer::work(int scale, double weight) {
    m_context.stage(weight, message("Scale 1/{}", 1 << scale));
    if (m_resumed && m_scale < scale)
        return m_context.progress(1); // a checkpoint had come further
    if (!m_resumed || m_scale != scale) {
        begin(scale);
        m_iteration = m_waited = 0;
        m_energy = std::numeric_limits<double>::infinity();
    }
    m_resumed = false;
    m_scale = scale;
    show();
    Level level(*this, scale);
    for (int i = m_iteration; i < m_settings.iterations; ++i) {
        const double energy = iterate(level);
        m_context.progress((i + 1.0) / m_settings.iterations);
        const bool better = energy < (1 - kConverged) * m_energy;
        m_energy = better ? energy : m_energy;
        m_waited = better ? 0 : m_waited + 1;
        if (m_waited == kPatience)
            break;
        m_context.checkpoint(checkpointPause(m_image.size()), [&] { return state(i + 1); });
    }
    m_context.progress(1);
}

/// Codes the image's patches, puts them together, and goes down the gradient. @return the energy.
double Synthesizer::iterate(Level& level) {
    const SparseCode code =
        constrainedPursuit(level.dictionary.atoms, level.columns.of(m_image), level.limits, m_context);
    const auto make = [&](int number, const Eigen::Ref<Eigen::VectorXf>& to) {
        code.combine(level.dictionary.atoms, number, to);
    };
    Image joined(m_image.size(), m_image.channels());
    if (m_settings.reconstruction == Reconstruction::Cut)
        level.columns.cut(make, level.delta, m_context, joined);
    else
        level.columns.average(make, m_context, joined);
    return descend(level, code, joined);
}

/// (1/Z) |Π(u) − D W|².
double Synthesizer::codingError(const Level& level, const SparseCode& code) const {
    constexpr int kPatches = 64;
    const SignalSource patches = level.columns.of(m_image);
    const int blocks = (patches.count + kPatches - 1) / kPatches;
    std::vector<double> errors(at(blocks), 0.0);
    m_context.parallel(0, blocks, [&](int block) {
        const int first = block * kPatches, count = std::min(kPatches, patches.count - first);
        Eigen::MatrixXf own(patches.length, count);
        patches.read(first, own);
        Eigen::VectorXf made(patches.length);
        for (int k = 0; k < count; ++k) {
            code.combine(level.dictionary.atoms, first + k, made);
            errors[at(block)] += static_cast<double>((own.col(k) - made).squaredNorm());
        }
    });
    double sum = 0;
    for (const double error : errors)
        sum += error;
    return sum / level.overlaps;
}

/// @return the energy of a pixel before the last step.
double Synthesizer::descend(Level& level, const SparseCode& code, const Image& joined) {
    const bool average = m_settings.reconstruction == Reconstruction::Average;
    const auto covering = [&](int x, int y) {
        return average ? static_cast<double>(level.columns.covering(x, y)) / level.overlaps : 1.0;
    };
    const double most = average ? static_cast<double>(level.columns.mostCovering()) / level.overlaps : 1.0;
    const auto step = static_cast<float>(2 * stepFor(m_settings, most));
    double colours = 0, slow = 0, frequencies = 0;
    Image gradient(m_image.size(), m_image.channels());
    for (int i = 0; i < m_settings.gradientSteps; ++i) {
        m_context.parallel(0, m_image.height(), [&](int y) {
            for (int c = 0; c < m_image.channels(); ++c)
                for (int x = 0; x < m_image.width(); ++x)
                    gradient(x, y, c) =
                        static_cast<float>(covering(x, y)) * (m_image(x, y, c) - joined(x, y, c));
        });
        if (level.histogram)
            colours = level.histogram->add(m_image, m_settings.alpha, m_context, gradient);
        if (level.lowPass)
            slow = level.lowPass->add(m_image, m_settings.beta, m_context, gradient);
        if (level.spectrum)
            frequencies = level.spectrum->add(m_image, m_settings.gamma, m_context, gradient);
        m_context.parallel(0, m_image.height(), [&](int y) {
            for (int c = 0; c < m_image.channels(); ++c)
                for (int x = 0; x < m_image.width(); ++x)
                    m_image(x, y, c) -= step * gradient(x, y, c);
        });
        show();
    }
    const double coding = codingError(level, code);
    const auto pixels = static_cast<double>(m_image.size().area());
    const double energy = coding + m_settings.histogramWeight() * colours +
                          m_settings.lowPassWeight() * slow + m_settings.spectrumWeight() * frequencies;
    m_context.curve(TR("Energy of a pixel"), energy / pixels);
    m_context.curve(TR("Sparse coding"), coding / pixels);
    if (level.histogram)
        m_context.curve(TR("Histogram"), m_settings.alpha * colours / pixels);
    if (level.lowPass)
        m_context.curve(TR("Low frequencies"), m_settings.beta * slow / pixels);
    if (level.spectrum)
        m_context.curve(TR("Spectrum"), m_settings.gamma * frequencies / pixels);
    return energy / pixels;
}

std::string Synthesizer::state(int iteration) const {
    std::string state;
    append(state, m_scale);
    append(state, iteration);
    append(state, m_waited);
    append(state, m_energy);
    append(state, m_image.size());
    for (int c = 0; c < m_image.channels(); ++c)
        for (int y = 0; y < m_image.height(); ++y)
            state.append(reinterpret_cast<const char*>(m_image.plane(c).row(y)),
                         static_cast<std::size_t>(m_image.width()) * sizeof(float));
    if (!m_given) {
        TextureDictionaries learnt = m_dictionaries;
        learnt.scales.erase(learnt.scales.begin(), learnt.scales.begin() + m_scale);
        state += learnt.model()->bytes();
    }
    return state;
}

void Synthesizer::resume(const std::string& state) {
    const char* from = state.data();
    Size size;
    take(from, m_scale);
    take(from, m_iteration);
    take(from, m_waited);
    take(from, m_energy);
    take(from, size);
    m_image = Image(size, m_request.channels());
    for (int c = 0; c < m_image.channels(); ++c)
        for (int y = 0; y < size.height; ++y) {
            std::memcpy(m_image.plane(c).row(y), from, static_cast<std::size_t>(size.width) * sizeof(float));
            from += static_cast<std::size_t>(size.width) * sizeof(float);
        }
    if (!m_given) {
        const std::string_view rest(from, static_cast<std::size_t>(state.data() + state.size() - from));
        TextureDictionaries learnt = TextureDictionaries::from(modelFromBytes(rest, "checkpoint"));
        std::move(learnt.scales.begin(), learnt.scales.end(), m_dictionaries.scales.begin() + m_scale);
    }
    m_resumed = true;
}

/// Every pixel of a coarse scale stands for several of the output.
void Synthesizer::show() const {
    if (m_image.empty())
        return;
    m_context.preview(m_request.size, [&](Size size, int step) {
        Image picture(size, m_request.channels());
        for (int c = 0; c < picture.channels(); ++c)
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    picture(x, y, c) = m_dictionaries.origin[at(c)] +
                                       m_image(std::min(m_image.width() - 1, (x * step) >> m_scale),
                                               std::min(m_image.height() - 1, (y * step) >> m_scale), c);
        return picture;
    });
}

void Synthesizer::addDictionaries(Synthesis& result) const {
    const AtomSheetStyle style = sheetStyle(m_request, m_settings.patch, m_dictionaries.origin, m_context);
    for (int j = 0; j < m_pyramid->levels(); ++j) {
        const Dictionary& scale = m_dictionaries.scales[at(j)];
        result.pictures.push_back({message("Dictionary at scale 1/{}", 1 << j),
                                   atomSheet(scale.atoms, scale.byUse(), style, shownChannels(m_request))});
        if (!m_given && scale.count() < m_settings.atoms)
            result.notes.push_back(message("At scale 1/{} there are {} patches to learn from, so that the "
                                           "dictionary has {} atoms instead of {}.",
                                           1 << j, scale.signals, scale.count(), m_settings.atoms));
    }
}

Synthesis Synthesizer::finished() {
    Image image = shifted(m_image, m_dictionaries.origin, 1, m_context);
    image.shrink(m_request.size);
    Synthesis result = withEstimatedMap(std::move(image), m_request, kMapWeight, m_context);
    result.figures = {{TR("Scales used"), static_cast<double>(m_pyramid->levels())},
                      {TR("Energy of a pixel"), m_energy}};
    addDictionaries(result);
    m_context.progress(1);
    return result;
}

} // namespace texloom::sparse

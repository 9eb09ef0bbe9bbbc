#include "core/base/at.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/exemplar_pyramid.h"
#include "core/methods/dictionary_fields.h"
#include "core/methods/dictionary_model.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom::dictionary {

namespace {

struct Settings {
    int patch = 12;
    int scales = 3;
    int sparsity = 4;
    int atoms = 384;
    DictionaryLearner learner = DictionaryLearner::Ksvd;
    int learningIterations = 20;
    int learnStep = 1;
    bool centred = false;
};

/// An exemplar of the output's size has no say in how many scales there are.
int scalesFor(const Request& request, const Settings& settings) {
    return dictionaryScales(settings.scales, settings.patch, request.exemplars.front().image->size(), {}, {});
}

void check(const Request& request, const Settings& settings) {
    checkDictionaryRequest(request, settings.patch, settings.sparsity);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size exemplar = request.exemplars.front().image->size();
    const int channels = request.channels();
    Estimate need;
    need.bytes = 3 * Image::bytesFor(exemplar, channels) +
                 ExemplarPyramid::bytesFor(request.exemplarSizes(), channels) +
                 3 * Image::bytesFor(request.size, channels) +
                 textureDictionaryBytes(exemplar, channels, learningOf(settings, 0), threads) + (6U << 20U);
    for (int j = 0; j < scalesFor(request, settings); ++j) {
        const Size size{exemplar.width >> j, exemplar.height >> j};
        need.seconds += textureDictionarySeconds(size, channels, learningOf(settings, j));
        need.bytes += 2 * sizeof(float) * at(settings.atoms) * at(channels * settings.patch * settings.patch);
    }
    return need;
}

/// Learns from coarse to fine, so that there is something to see at once.
class Learner {
public:
    Learner(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context) {}

    Synthesis run() {
        m_context.stage(0.01, TR("Preparing the exemplar"));
        const Exemplar& exemplar = m_request.exemplars.front();
        m_learnt.patch = m_settings.patch;
        m_learnt.origin = dictionaryOrigin(exemplar, m_settings.centred, m_context);
        m_style = sheetStyle(m_request, m_settings.patch, m_learnt.origin, m_context);
        const Image image = shifted(*exemplar.image, m_learnt.origin, -1, m_context);
        PatchSource source = patchSources(m_request).front();
        source.image = image.view();
        const ExemplarPyramid pyramid({&source, 1}, scalesFor(m_request, m_settings), m_settings.patch,
                                      [this] { m_context.check(); });
        m_learnt.scales.resize(at(pyramid.levels()));
        const double whole = (1 - std::pow(0.25, pyramid.levels())) / 0.75;
        for (int j = pyramid.levels() - 1; j >= 0; --j) {
            m_context.stage(0.99 / whole * std::pow(0.25, j), message("Learning at scale 1/{}", 1 << j));
            learn(pyramid.level(j).front(), j);
        }
        return result();
    }

private:
    void learn(const PatchSource& source, int scale) {
        const TextureDictionaryOptions options = learningOf(m_settings, scale);
        const double samples = static_cast<double>(learntPatches(source.image.size(), options)) *
                               m_settings.patch * m_settings.patch * m_request.channels();
        m_learnt.scales[at(scale)] = learnTexture(
            source, options, m_context, [&](int rounds, double error, const Eigen::MatrixXf& atoms) {
                m_context.curve(TR("Root mean square error"), std::sqrt(error / samples));
                m_context.progress(static_cast<double>(rounds) / m_settings.learningIterations);
                if (m_context.previewDue())
                    m_context.preview(sheet(atoms, firstOf(atoms.cols())));
            });
        m_context.progress(1);
    }

    static std::vector<int> firstOf(Eigen::Index count) {
        std::vector<int> numbers(static_cast<std::size_t>(count));
        std::iota(numbers.begin(), numbers.end(), 0);
        return numbers;
    }

    /// All channels, at the output's size.
    Image sheet(const Eigen::MatrixXf& atoms, const std::vector<int>& order) const {
        return atomSheet(atoms, order, m_style, m_request.channels(), m_request.size);
    }

    Synthesis result() {
        Synthesis made;
        const Dictionary& finest = m_learnt.scales.front();
        made.image = sheet(finest.atoms, finest.byUse());
        for (std::size_t j = 0; j < m_learnt.scales.size(); ++j) {
            const Dictionary& scale = m_learnt.scales[j];
            made.pictures.push_back(
                {message("Dictionary at scale 1/{}", 1 << j),
                 atomSheet(scale.atoms, scale.byUse(), m_style, shownChannels(m_request))});
            if (scale.count() < m_settings.atoms)
                made.notes.push_back(message("At scale 1/{} there are {} patches to learn from, so that the "
                                             "dictionary has {} atoms instead of {}.",
                                             1 << j, scale.signals, scale.count(), m_settings.atoms));
        }
        const auto used = std::count_if(finest.uses.begin(), finest.uses.end(), [](auto n) { return n > 0; });
        made.figures = {{TR("Scales used"), static_cast<double>(m_learnt.scales.size())},
                        {TR("Atoms in use"), static_cast<double>(used)},
                        {TR("Patches learnt from"), static_cast<double>(finest.signals)}};
        made.outputs.add(kDictionaryPort, m_learnt.model());
        return made;
    }

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    TextureDictionaries m_learnt;
    AtomSheetStyle m_style;
};

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Learner(request, settings, context).run();
}

std::vector<Param> params() {
    std::vector<Param> all = dictionaryPatchFields<Settings>();
    for (Param& param : dictionaryLearningFields<Settings>())
        all.push_back(std::move(param));
    return all;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Dictionary"),
     .summary =
         TR("Learns atoms of which a few make up any patch of the exemplar, and shows them, those used "
            "most first. Sparse synthesis takes the dictionary up, so that it is learnt only once."),
     .citation = "Aharon, Elad & Bruckstein, IEEE TSP 2006; Mairal, Bach, Ponce & Sapiro, JMLR 2010; "
                 "Tartavel, Gousseau & Peyré, SSVM 2013",
     .category = Category::Sparse,
     .takes = {ports::exemplar(), ports::mask()},
     .gives = {ports::wrappingImage(), dictionaryOutput()}},
    params(), run, check, estimate);

} // namespace texloom::dictionary

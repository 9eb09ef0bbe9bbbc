#include "core/session/run/run.h"

#include "core/analysis/derived_maps.h"
#include "core/analysis/lattice_settings.h"
#include "core/analysis/layout_quality.h"
#include "core/analysis/map_pictures.h"
#include "core/analysis/map_usage.h"
#include "core/analysis/seam.h"
#include "core/base/text.h"
#include "core/image/normal_map.h"
#include "core/image/stmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace texloom {

namespace {

void append(std::vector<Figure>& figures, const std::vector<Figure>& more) {
    figures.insert(figures.end(), more.begin(), more.end());
}

void addOccurrences(const std::vector<Image>& occurrences, std::vector<Picture>& pictures) {
    for (std::size_t e = 0; e < occurrences.size(); ++e) {
        const Message name = occurrences.size() > 1 ? message("Occurrence {}", e + 1) : TR("Occurrence");
        pictures.push_back({name, occurrencePicture(occurrences[e])});
    }
}

std::vector<ImageView> exemplarViews(const Request& request) {
    std::vector<ImageView> views;
    for (const Exemplar& exemplar : request.exemplars)
        views.push_back(exemplar.image->view().channelRange(0, request.resultChannels()));
    return views;
}

/// The method's own figures and those of the result alone; with `request`, also how like its exemplars it is.
std::vector<Figure> measure(Synthesis& synthesis, const Request* request, JobContext& context) {
    const auto check = [&context] { context.check(); };
    std::vector<Figure> figures = synthesis.figures;
    const SeamScore seam = seamScore(synthesis.image, check);
    figures.push_back({TR("Seam, left to right"), seam.x});
    figures.push_back({TR("Seam, top to bottom"), seam.y});
    if (!request || request->exemplars.empty())
        return figures;
    const std::vector<ImageView> exemplars = exemplarViews(*request);
    if (synthesis.mapKind != MapKind::None) {
        const std::vector<Image> occurrences = occurrencesOf(synthesis.map, check);
        append(figures, mapFigures(synthesis.map, synthesis.mapKind, occurrences, check));
        append(figures, pieceFigures(synthesis.image, exemplars, synthesis.map, occurrences, check));
        addOccurrences(occurrences, synthesis.pictures);
    }
    append(figures, layoutFigures(synthesis.image, exemplars, request->exemplars.front().image, check));
    append(figures, distanceFigures(textureDistance(synthesis.image, exemplars, context)));
    return figures;
}

/// Makes vectors of a normal map of what a method made of its channels: turned where the method moved pixels.
void mendNormals(Image& normals, const ExemplarFile& companion, const Result& result, const RunPlan& plan,
                 const std::function<void()>& check) {
    const std::string port(kStMapPort);
    const Image* const stmap =
        plan.lastMethod().info().output(port) != nullptr ? result.synthesis.outputs.image(port) : nullptr;
    if (stmap == nullptr)
        return renormalize(normals); // methods blend vectors as they blend colours
    const bool initial = plan.steps.size() > 1 || plan.request.initial() != nullptr;
    const Size from = initial ? plan.request.size : companion.image->size();
    turnNormals(
        normals, *companion.image, companion.role,
        [&](int x, int y) { return stMapJacobian(*stmap, from, x, y); }, check);
}

/// Index of the first companion that holds heights, if one does.
std::optional<std::size_t> heightAmong(const std::vector<ExemplarFile>& companions) {
    for (std::size_t i = 0; i < companions.size(); ++i)
        if (companions[i].role == MapRole::Height)
            return i;
    return {};
}

/// Derives normals anew from the heights that were made with them where they belonged together in the
/// exemplar and no longer do: methods that make new pixels from statistics hold those of each channel, but
/// hardly any of slopes against vectors.
void agreeWithHeight(Result& result, const RunPlan& plan, const std::function<void()>& check) {
    constexpr double kBelongs = 0.5, kLost = 0.8; // of the agreement in the exemplar
    const std::vector<ExemplarFile>& files = plan.companions.front();
    const std::optional<std::size_t> height = heightAmong(files);
    for (std::size_t i = 0; height && i < files.size(); ++i) {
        if (!isNormal(files[i].role) || files[i].image->channels() < 3)
            continue;
        const Relief wanted = reliefOf(*files[*height].image, *files[i].image, files[i].role, {}, check);
        const Image& heights = result.companions[*height];
        Image& normals = result.companions[i];
        const Relief made = reliefOf(heights, normals, files[i].role, plan.request.wrap, check);
        if (wanted.agreement < kBelongs || made.agreement >= kLost * wanted.agreement)
            continue;
        const bool raw = valueRange(files[i].image->view().channelRange(0, 3)).smallest < 0;
        Image derived = normalsFromHeight(heights, wanted.depth, plan.request.wrap, check);
        if (files[i].role == MapRole::NormalDx)
            flipGreen(derived);
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < derived.height(); ++y)
                for (int x = 0; x < derived.width(); ++x)
                    normals(x, y, c) = raw ? 2 * derived(x, y, c) - 1 : derived(x, y, c);
        result.synthesis.notes.push_back(
            message("The vectors of {} no longer agreed with {} (slopes alike by {:.2f}, in the exemplar by "
                    "{:.2f}), so they were derived from the heights.",
                    files[i].name(), files[*height].name(), made.agreement, wanted.agreement));
    }
}

/// Splits the companions' channels off the image, and off pictures of as many channels. Where pixels were
/// copied, the maps follow from where they came from.
void unstack(Result& result, const RunPlan& plan, const std::function<void()>& check) {
    if (plan.request.companionChannels == 0)
        return;
    const Image made = std::move(result.synthesis.image);
    int first = plan.request.resultChannels();
    result.synthesis.image = Image(made.view().channelRange(0, first));
    for (Picture& picture : result.synthesis.pictures)
        if (picture.image.channels() == made.channels())
            picture.image = Image(picture.image.view().channelRange(0, first));
    if (plan.lastMethod().info().copiesPixels())
        return;
    for (const ExemplarFile& companion : plan.companions.front()) {
        result.companions.emplace_back(made.view().channelRange(first, companion.image->channels()));
        if (isNormal(companion.role))
            mendNormals(result.companions.back(), companion, result, plan, check);
        first += companion.image->channels();
    }
    agreeWithHeight(result, plan, check);
}

void forgetWeights(Request& request) {
    for (Exemplar& exemplar : request.exemplars)
        exemplar.weight = 1;
}

/// Gives a method what it takes up of what the one before it made, and checks what was not there to be
/// checked before the run.
void handOver(const MethodInfo& first, Synthesis made, const RunStep& second, Request& request) {
    bool further = made.image.channels() != request.channels();
    for (const PortLink& link : linksBetween(first, second.method->info())) {
        if (link.from == kImagePort)
            request.inputs.set(link.to, std::make_shared<const Image>(std::move(made.image)));
        else if (link.from == kMapPort)
            request.inputs.set(link.to, std::make_shared<const PositionMap>(std::move(made.map)));
        for (const Asset& asset : made.outputs.at(link.from))
            request.inputs.add(link.to, asset);
        further = further || link.to != kInitialPort;
    }
    if (further)
        second.method->check(request, second.settings);
}

/// Adds to `outputs` those of an earlier method that no later one gives in their place: what one learned and
/// the next used is kept.
void keepEarlier(const Assets& earlier, Assets& outputs) {
    for (const auto& [port, assets] : earlier.byPort())
        if (outputs.at(port).empty())
            for (const Asset& asset : assets)
                outputs.add(port, asset);
}

/// How much of a run a step makes up, as far as can be told; where no step says how long it takes, all alike.
double shareOf(const RunStep& step, const RunPlan& plan) {
    return plan.estimate.seconds > 0 ? step.estimate.seconds / plan.estimate.seconds
                                     : 1.0 / static_cast<double>(plan.steps.size());
}

bool weighed(const Request& request) {
    return std::any_of(request.exemplars.begin(), request.exemplars.end(), [&](const Exemplar& exemplar) {
        return exemplar.weight != request.exemplars.front().weight;
    });
}

} // namespace

std::vector<Figure> mapFigures(const PositionMap& map, MapKind kind, const std::vector<Image>& occurrences,
                               const std::function<void()>& check) {
    std::vector<Figure> figures;
    if (kind == MapKind::Exact || kind == MapKind::Dominant) {
        figures.push_back({TR("Innovation"), innovation(map, check)});
        figures.push_back({TR("Largest verbatim region, %"), 100 * largestVerbatimRegion(map, check)});
    } else if (kind == MapKind::Estimated) {
        figures.push_back({TR("Innovation, estimated"), innovation(map, check)});
    }
    figures.push_back({TR("Patch-occurrence entropy"), occurrenceEntropy(occurrences)});
    return figures;
}

std::vector<Figure> distanceFigures(const TextureDistance& distance) {
    return {{TR("Colour histograms apart"), distance.color},
            {TR("Patches apart, first principal axis"), distance.components[0]},
            {TR("Patches apart, second principal axis"), distance.components[1]},
            {TR("Patches apart, sliced Wasserstein"), distance.wasserstein[0]},
            {TR("Patches apart, sliced Wasserstein at half scale"), distance.wasserstein[1]},
            {TR("Patches apart, sliced Wasserstein at quarter scale"), distance.wasserstein[2]}};
}

std::vector<Figure> pieceFigures(const ImageView& result, const std::vector<ImageView>& exemplars,
                                 const PositionMap& map, const std::vector<Image>& occurrences,
                                 const std::function<void()>& check) {
    return {{TR("Jump where pieces meet"), seamJump(result, exemplars, map, check)},
            {TR("From the most used part of the exemplar, %"), 100 * mostUsedShare(occurrences)}};
}

std::vector<Figure> layoutFigures(const ImageView& result, const std::vector<ImageView>& exemplars,
                                  const std::shared_ptr<const Image>& first,
                                  const std::function<void()>& check) {
    std::vector<Figure> figures = {
        {TR("Contrast kept"), contrastKept(result, exemplars, check)},
        {TR("Autocorrelations apart"), correlationApart(result, exemplars, check)}};
    std::vector<Message> notes; // of no use here
    const ImageView part = middlePart(first->view());
    const Lattice lattice = latticeFor(
        {}, {}, part.size() == first->size() ? first : std::make_shared<const Image>(part), notes, check);
    if (!lattice.free() && !lattice.rowsOnly())
        figures.push_back({TR("Lattice kept"), latticeKept(result, exemplars.front(), lattice, check)});
    return figures;
}

bool leaveOutCompanions(Result& result) {
    const bool laidOut = !result.companions.empty() || result.synthesis.mapKind != MapKind::None;
    if (!result.stoppedAt || laidOut || !result.plan.hasCompanions())
        return false;
    for (std::vector<ExemplarFile>& files : result.plan.companions)
        files.clear();
    return true;
}

Image Result::companion(std::size_t index) const {
    if (!companions.empty())
        return companions[index];
    std::vector<ImageView> images;
    for (const std::vector<ExemplarFile>& files : plan.companions)
        images.push_back(*files[index].image);
    return synthesis.map.apply(images);
}

std::string Result::label() const {
    const Size size = plan.request.part().size;
    return fmt::format("{} · seed {} · {} × {}", plan.methodIds(" + "), plan.request.seed, size.width,
                       size.height);
}

std::string Result::fileName() const {
    const Size size = plan.request.part().size;
    const std::string extent = size.width == size.height ? std::to_string(size.width)
                                                         : fmt::format("{}x{}", size.width, size.height);
    const std::optional<Region>& region = plan.request.region;
    const std::string place = region ? fmt::format("_at_{}_{}", region->x, region->y) : "";
    return fmt::format("{}_{}_s{}_{}{}", plan.name(), plan.methodIds("_"), plan.request.seed, extent, place);
}

namespace {

/// Runs all steps; `result` has what the last one begun made, `kept` the outputs of all that have ended.
void runSteps(const RunPlan& plan, JobContext& context, Result& result, Assets& kept) {
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const RunStep& step = plan.steps[i];
        const MethodInfo& info = step.method->info();
        context.step(static_cast<std::uint32_t>(i), shareOf(step, plan));
        Request request = plan.requestFor(i, info, i + 1 == plan.steps.size());
        if (!info.heedsWeights())
            forgetWeights(request);
        if (i > 0)
            handOver(plan.steps[i - 1].method->info(), std::move(result.synthesis), step, request);
        result.synthesis = step.method->run(request, step.settings, context);
        keepEarlier(kept, result.synthesis.outputs);
        kept = result.synthesis.outputs;
        if (weighed(plan.request) && !info.heedsWeights())
            result.synthesis.notes.emplace_back(
                TR("The method treats all exemplars alike, so their weights had no effect."));
    }
}

bool covers(Size whole, Size part) {
    return whole.width >= part.width && whole.height >= part.height;
}

/// Work on a coarse scale at the output's size, each pixel many times.
Image enlarged(const ImageView& image, Size size) {
    Image large(size, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                large(x, y, c) = image(static_cast<int>(std::int64_t{x} * image.width / size.width),
                                       static_cast<int>(std::int64_t{y} * image.height / size.height), c);
    return large;
}

/// Whether the map's pixels of the exemplars are those of the image wherever it has any.
bool copies(const PositionMap& map, const Request& request, const ImageView& image) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; map.at(x, y).valid() && c < image.channels; ++c) {
                const Source& source = map.at(x, y);
                if ((*request.exemplars[source.exemplar].image)(source.x, source.y, c) != image(x, y, c))
                    return false;
            }
    return true;
}

/// What a run that was stopped had made, as a result: pixels of another scale are enlarged, and whether they
/// are copies is found by looking.
Synthesis partialSynthesis(const RunPlan& plan, PartialWork work, const std::vector<Curve>& curves) {
    Synthesis partial;
    partial.curves = curves;
    const Size size = plan.request.part().size;
    if (!covers(work.image.size(), size)) {
        partial.image = enlarged(work.image, size);
        return partial;
    }
    work.image.shrink(size);
    partial.image = std::move(work.image);
    if (!covers(work.map.size(), size))
        return partial;
    work.map.shrink(size);
    partial.map = std::move(work.map);
    partial.mapKind = copies(partial.map, plan.request, partial.image) ? MapKind::Exact : MapKind::Dominant;
    return partial;
}

} // namespace

Result runPlan(const RunPlan& plan, JobContext& context) {
    constexpr double kMostStopped = 0.99; // the last picture may come with all of the progress made
    Result result;
    Assets kept;
    try {
        runSteps(plan, context, result, kept);
        // A method may have ended by itself, with more than a picture.
        if (const std::optional<double> early = context.stoppedAt())
            result.stoppedAt = std::min(*early, kMostStopped);
    } catch (const StoppedEarly&) {
        PartialWork work = context.takePartial();
        result.stoppedAt = std::min(work.progress, kMostStopped);
        result.synthesis = partialSynthesis(plan, std::move(work), context.curves());
        result.synthesis.outputs = kept;
    }
    result.synthesis.notes.insert(result.synthesis.notes.begin(), plan.notes.begin(), plan.notes.end());
    unstack(result, plan, [&context] { context.check(); });
    for (const StageTime& stage : context.stageTimes())
        result.seconds += stage.seconds;
    context.stage(0, TR("Judging the result"));
    result.figures = measure(result.synthesis, plan.judged ? &plan.request : nullptr, context);
    result.plan = plan;
    if (leaveOutCompanions(result))
        result.synthesis.notes.emplace_back(TR("The run was stopped before it knew where its pixels come "
                                               "from, so there are no companion maps."));
    result.stages = context.stageTimes();
    return result;
}

std::unique_ptr<SynthesisJob> startRun(RunPlan plan, bool previews, std::function<void()> onFinished,
                                       Checkpoints checkpoints) {
    const JobOptions options{plan.request.seed, plan.threads, previews, std::move(checkpoints.keep),
                             std::move(checkpoints.resumed)};
    auto shared = std::make_shared<const RunPlan>(std::move(plan));
    return std::make_unique<SynthesisJob>(
        options, [shared](JobContext& context) { return runPlan(*shared, context); }, std::move(onFinished));
}

} // namespace texloom

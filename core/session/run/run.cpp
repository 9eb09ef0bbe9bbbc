#include "core/session/run/run.h"

#include "core/analysis/map_pictures.h"
#include "core/analysis/map_usage.h"
#include "core/analysis/seam.h"
#include "core/base/text.h"
#include "core/image/normal_map.h"

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
        const std::string number = occurrences.size() > 1 ? fmt::format(" {}", e + 1) : "";
        pictures.push_back({TR("Occurrence") + number, occurrencePicture(occurrences[e])});
    }
}

/// The method's own figures and those of the result alone; with `exemplars`, also how like them it is.
std::vector<Figure> measure(Synthesis& synthesis, const std::vector<ImageView>& exemplars,
                            JobContext& context) {
    const auto check = [&context] { context.check(); };
    std::vector<Figure> figures = synthesis.figures;
    const SeamScore seam = seamScore(synthesis.image, check);
    figures.push_back({TR("Seam, left to right"), seam.x});
    figures.push_back({TR("Seam, top to bottom"), seam.y});
    if (exemplars.empty())
        return figures;
    if (synthesis.mapKind != MapKind::None) {
        const std::vector<Image> occurrences = occurrencesOf(synthesis.map, check);
        append(figures, mapFigures(synthesis.map, synthesis.mapKind, occurrences, check));
        addOccurrences(occurrences, synthesis.pictures);
    }
    append(figures, distanceFigures(textureDistance(synthesis.image, exemplars, context)));
    return figures;
}

std::vector<ImageView> exemplarViews(const Request& request) {
    std::vector<ImageView> views;
    for (const Exemplar& exemplar : request.exemplars)
        views.push_back(exemplar.image->view().channelRange(0, request.resultChannels()));
    return views;
}

/// Splits the companions' channels off the image.
void unstack(Result& result, const RunPlan& plan) {
    if (plan.request.companionChannels == 0)
        return;
    const Image made = std::move(result.synthesis.image);
    int first = plan.request.resultChannels();
    result.synthesis.image = Image(made.view().channelRange(0, first));
    for (const ExemplarFile& companion : plan.companions.front()) {
        result.companions.emplace_back(made.view().channelRange(first, companion.image->channels()));
        if (isNormal(companion.role)) // methods blend vectors as they blend colours
            renormalize(result.companions.back());
        first += companion.image->channels();
    }
}

/// What a method that takes all exemplars alike gets to see.
Request withoutWeights(Request request) {
    for (Exemplar& exemplar : request.exemplars)
        exemplar.weight = 1;
    return request;
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
    return fmt::format("{}_{}_s{}_{}{}", plan.request.exemplars.front().name, plan.methodIds("_"),
                       plan.request.seed, extent, place);
}

Result runPlan(const RunPlan& plan, JobContext& context) {
    Result result;
    Request request = plan.request;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const RunStep& step = plan.steps[i];
        context.step(static_cast<std::uint32_t>(i), shareOf(step, plan));
        if (i > 0)
            request.initial = std::make_shared<const Image>(std::move(result.synthesis.image));
        const bool ignores = weighed(request) && !step.method->info().weighsExemplars;
        result.synthesis =
            step.method->run(ignores ? withoutWeights(request) : request, step.settings, context);
        if (ignores)
            result.synthesis.notes.emplace_back(
                TR("The method takes all exemplars alike, so that their weights had no effect."));
    }
    unstack(result, plan);
    for (const StageTime& stage : context.stageTimes())
        result.seconds += stage.seconds;
    context.stage(0, TR("Judging the result"));
    result.figures =
        measure(result.synthesis, plan.judged ? exemplarViews(request) : std::vector<ImageView>(), context);
    result.plan = plan;
    result.stages = context.stageTimes();
    return result;
}

std::unique_ptr<SynthesisJob> startRun(RunPlan plan, bool previews, std::function<void()> onFinished) {
    const JobOptions options{plan.request.seed, plan.threads, previews};
    auto shared = std::make_shared<const RunPlan>(std::move(plan));
    return std::make_unique<SynthesisJob>(
        options, [shared](JobContext& context) { return runPlan(*shared, context); }, std::move(onFinished));
}

} // namespace texloom

#include "core/session/run.h"

#include "core/analysis/map_pictures.h"
#include "core/analysis/seam.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"

#include <cstdlib>
#include <fstream>
#include <string_view>
#include <utility>

namespace texloom {

namespace {

RecipeFile recipeFile(const ExemplarFile& file) {
    return {file.path, file.space, file.hash};
}

Recipe recipeFor(const RunInput& input, const Values& settings) {
    Recipe recipe{kVersion, input.method, settings, {}, {}, input.size, input.wrap, input.seed};
    for (const RunExemplar& exemplar : input.exemplars) {
        RecipeExemplar& entry = recipe.exemplars.emplace_back();
        entry.image = recipeFile(exemplar.image);
        if (exemplar.mask)
            entry.mask = recipeFile(*exemplar.mask);
        for (const ExemplarFile& companion : exemplar.companions)
            entry.companions.push_back(recipeFile(companion));
    }
    if (input.initial)
        recipe.initial = recipeFile(*input.initial);
    return recipe;
}

Request requestFor(const RunInput& input) {
    Request request;
    for (const RunExemplar& exemplar : input.exemplars)
        request.exemplars.push_back(
            {exemplar.image.name(), exemplar.image.image, exemplar.mask ? exemplar.mask->image : nullptr});
    request.initial = input.initial ? input.initial->image : nullptr;
    request.size = input.size;
    request.wrap = input.wrap;
    request.seed = input.seed;
    return request;
}

void checkCompanions(const RunInput& input) {
    const std::size_t count = input.exemplars.front().companions.size();
    for (const RunExemplar& exemplar : input.exemplars) {
        if (exemplar.companions.size() != count)
            failUsage("{} has {} companion maps and {} has {}; every exemplar needs the same ones.",
                      input.exemplars.front().image.name(), count, exemplar.image.name(),
                      exemplar.companions.size());
        for (const ExemplarFile& companion : exemplar.companions)
            if (companion.image->size() != exemplar.image.image->size())
                failUsage("The companion {} is {} × {} px, but {} is {} × {} px; they must be alike.",
                          companion.name(), companion.info.size.width, companion.info.size.height,
                          exemplar.image.name(), exemplar.image.info.size.width,
                          exemplar.image.info.size.height);
    }
}

void checkMemory(const Estimate& estimate, const Request& request, std::uint64_t limit) {
    if (estimate.bytes > limit)
        fail("An output of {} × {} px would need {} of memory, more than the {} that are free; choose a "
             "smaller size.",
             request.size.width, request.size.height, byteText(estimate.bytes), byteText(limit));
}

/// A figure in kB from one of the kernel's lists, in bytes.
std::optional<std::uint64_t> kernelFigure(const char* list, std::string_view name) {
    std::ifstream lines(list);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(name))
            return std::strtoull(line.c_str() + name.size(), nullptr, 10) * 1024;
    return std::nullopt;
}

std::vector<Figure> measure(const Synthesis& synthesis, JobContext& context) {
    const auto check = [&context] { context.check(); };
    std::vector<Figure> figures = synthesis.figures;
    if (synthesis.mapKind == MapKind::Exact || synthesis.mapKind == MapKind::Dominant)
        figures.push_back({TR("Innovation"), innovation(synthesis.map, check)});
    const SeamScore seam = seamScore(synthesis.image, check);
    figures.push_back({TR("Seam, left to right"), seam.x});
    figures.push_back({TR("Seam, top to bottom"), seam.y});
    return figures;
}

Result runPlan(const RunPlan& plan, JobContext& context) {
    Result result;
    result.synthesis = plan.method->run(plan.request, plan.settings, context);
    context.stage(0, TR("Measuring the result"));
    result.figures = measure(result.synthesis, context);
    result.plan = plan;
    result.stages = context.stageTimes();
    for (const StageTime& stage : result.stages)
        result.seconds += stage.seconds;
    return result;
}

ExemplarFile loadNamed(const RecipeFile& file, ExemplarFile loaded,
                       const std::function<void(const std::filesystem::path&)>& changed) {
    if (changed && !file.hash.empty() && file.hash != loaded.hash)
        changed(file.path);
    return loaded;
}

} // namespace

RunPlan planRun(const RunInput& input, std::uint64_t memoryLimit) {
    RunPlan plan;
    plan.method = &findMethod(input.method);
    if (input.exemplars.empty())
        failUsage("There is no exemplar to learn from.");
    plan.threads = threadCount(input.threads);
    plan.memoryBefore = residentMemory();
    plan.request = requestFor(input);
    plan.settings = plan.method->resolved(input.settings, plan.request.exemplars.front().image->size());
    plan.method->check(plan.request, plan.settings);
    checkCompanions(input);
    plan.estimate = plan.method->estimate(plan.request, plan.settings, plan.threads);
    checkMemory(plan.estimate, plan.request, memoryLimit > 0 ? memoryLimit : availableMemory());
    plan.recipe = recipeFor(input, plan.settings);
    for (const RunExemplar& exemplar : input.exemplars)
        plan.companions.push_back(exemplar.companions);
    return plan;
}

RunInput loadRecipe(const Recipe& recipe, const std::function<void(const std::filesystem::path&)>& changed) {
    findMethod(recipe.method).resolved(recipe.parameters, {});
    RunInput input;
    input.method = recipe.method;
    input.settings = recipe.parameters;
    input.size = recipe.size;
    input.wrap = recipe.wrap;
    input.seed = recipe.seed;
    for (const RecipeExemplar& entry : recipe.exemplars) {
        RunExemplar& exemplar = input.exemplars.emplace_back();
        exemplar.image = loadNamed(entry.image, loadExemplar(entry.image.path, entry.image.space), changed);
        if (entry.mask)
            exemplar.mask = loadNamed(*entry.mask, loadMask(entry.mask->path), changed);
        for (const RecipeFile& companion : entry.companions)
            exemplar.companions.push_back(loadNamed(companion, loadData(companion.path), changed));
    }
    if (recipe.initial)
        input.initial =
            loadNamed(*recipe.initial, loadExemplar(recipe.initial->path, recipe.initial->space), changed);
    return input;
}

std::string Result::label() const {
    return fmt::format("{} · seed {} · {} × {}", plan.method->id(), plan.request.seed,
                       plan.request.size.width, plan.request.size.height);
}

std::string Result::fileName() const {
    const Size size = plan.request.size;
    const std::string extent = size.width == size.height ? std::to_string(size.width)
                                                         : fmt::format("{}x{}", size.width, size.height);
    return fmt::format("{}_{}_s{}_{}", plan.request.exemplars.front().name, plan.method->id(),
                       plan.request.seed, extent);
}

std::unique_ptr<SynthesisJob> startRun(RunPlan plan, bool previews, std::function<void()> onFinished) {
    const JobOptions options{plan.request.seed, plan.threads, previews};
    auto shared = std::make_shared<const RunPlan>(std::move(plan));
    return std::make_unique<SynthesisJob>(
        options, [shared](JobContext& context) { return runPlan(*shared, context); }, std::move(onFinished));
}

std::uint64_t residentMemory() {
    return kernelFigure("/proc/self/status", "VmRSS:").value_or(0);
}

std::uint64_t peakMemory() {
    return kernelFigure("/proc/self/status", "VmHWM:").value_or(0);
}

std::uint64_t availableMemory() {
    constexpr std::uint64_t kAssumed = 4ULL << 30;
    return kernelFigure("/proc/meminfo", "MemAvailable:").value_or(kAssumed);
}

} // namespace texloom

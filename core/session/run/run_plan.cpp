#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/job/memory.h"
#include "core/session/run/edited_exemplar.h"
#include "core/session/run/run.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texloom {

namespace {

RecipeFile companionFile(const ExemplarFile& file) {
    RecipeFile companion = recipeFile(file);
    companion.role = mapRoleId(file.role);
    return companion;
}

Recipe recipeFor(const RunInput& input, const std::vector<RunStep>& steps) {
    Recipe recipe;
    recipe.version = kVersion;
    recipe.method = steps.front().method->id();
    recipe.parameters = steps.front().settings;
    for (std::size_t i = 1; i < steps.size(); ++i)
        recipe.then.push_back({steps[i].method->id(), steps[i].settings});
    recipe.size = input.size;
    recipe.wrap = input.wrap;
    recipe.seed = input.seed;
    recipe.region = input.region;
    for (const RunExemplar& exemplar : input.exemplars)
        recipe.exemplars.push_back(recipeExemplar(exemplar));
    if (input.initial)
        recipe.initial = recipeFile(*input.initial);
    return recipe;
}

/// The exemplar with its companions as further channels.
std::shared_ptr<const Image> withCompanions(const RunExemplar& exemplar) {
    std::vector<ImageView> images = {*exemplar.image.image};
    for (const ExemplarFile& companion : exemplar.companions)
        images.push_back(*companion.image);
    return std::make_shared<const Image>(stacked(images));
}

/// An initial image says nothing of companion maps: they start from the means of the first exemplar's.
std::shared_ptr<const Image> withMeans(const Image& initial, const Image& exemplar) {
    if (initial.channels() >= exemplar.channels())
        return std::make_shared<const Image>(initial);
    Image missing(initial.size(), exemplar.channels() - initial.channels());
    const std::vector<double> means =
        channelMeans(exemplar.view().channelRange(initial.channels(), missing.channels()));
    for (int c = 0; c < missing.channels(); ++c)
        for (int y = 0; y < missing.height(); ++y)
            std::fill_n(missing.plane(c).row(y), missing.width(),
                        static_cast<float>(means[static_cast<std::size_t>(c)]));
    const std::array<ImageView, 2> parts = {initial, missing};
    return std::make_shared<const Image>(stacked(parts));
}

Request requestFor(const RunInput& input, bool stacks) {
    Request request;
    for (const RunExemplar& exemplar : input.exemplars) {
        request.exemplars.push_back({exemplar.image.name(),
                                     stacks ? withCompanions(exemplar) : exemplar.image.image,
                                     exemplar.mask ? exemplar.mask->image : nullptr, exemplar.weight});
    }
    if (stacks)
        request.companionChannels = request.channels() - input.exemplars.front().image.image->channels();
    if (input.initial)
        request.initial = stacks ? withMeans(*input.initial->image, *request.exemplars.front().image)
                                 : input.initial->image;
    request.size = input.size;
    request.wrap = input.wrap;
    request.seed = input.seed;
    request.region = input.region;
    return request;
}

void checkCompanions(const RunInput& input) {
    const std::size_t count = input.exemplars.front().companions.size();
    for (const RunExemplar& exemplar : input.exemplars) {
        if (exemplar.companions.size() != count)
            failUsage("{} and {} have different numbers of companion maps, {} and {}; every exemplar needs "
                      "the same ones.",
                      input.exemplars.front().image.name(), exemplar.image.name(), count,
                      exemplar.companions.size());
        for (const ExemplarFile& companion : exemplar.companions)
            checkSizeLike(exemplar.image, companion, TR("companion"));
    }
}

void checkMemory(const Estimate& estimate, const Request& request, std::uint64_t limit) {
    if (estimate.bytes > limit)
        fail("An output of {} × {} px would need {} of memory, more than the {} that are free; choose a "
             "smaller size.",
             request.part().size.width, request.part().size.height, byteText(estimate.bytes),
             byteText(limit));
}

/// What the only step of a plan needs for `rows` rows of the part asked for.
Estimate estimateForRows(const RunPlan& plan, int rows) {
    const RunStep& step = plan.steps.front();
    const Region part = plan.request.part();
    Request request = plan.request;
    request.region = Region{part.x, part.y, {part.size.width, std::min(part.size.height, rows)}};
    return step.method->estimate(request, step.settings, plan.threads);
}

/// Where a lone method makes regions: plans strips of the most rows that fit in `limit` bytes with room to
/// spare, unless hardly any do.
void planStrips(RunPlan& plan, std::uint64_t limit) {
    constexpr int kFewest = 64, kStep = 64;
    if (plan.steps.size() > 1 || !plan.lastMethod().info().makesRegions)
        return;
    int fitting = 0;
    // Doubling, then halving the steps: estimates only grow with the rows.
    for (int step = 1 << 14; step >= kStep; step /= 2)
        if (estimateForRows(plan, fitting + step).bytes <= limit / 4 * 3)
            fitting = std::min(plan.request.part().size.height, fitting + step);
    if (fitting < kFewest)
        return;
    plan.stripRows = fitting;
    plan.estimate = estimateForRows(plan, fitting);
}

/// Every method of the input, in order, with what was set.
std::vector<RecipeStep> stepsOf(const RunInput& input) {
    std::vector<RecipeStep> steps = {{input.method, input.settings}};
    steps.insert(steps.end(), input.then.begin(), input.then.end());
    return steps;
}

/// Checks each step and adds it with its estimate. A later step finds the image of the one before it in
/// memory, too.
void planSteps(RunPlan& plan, const std::vector<RecipeStep>& steps) {
    const Size exemplar = plan.request.exemplars.front().image->size();
    const std::uint64_t between = Image::bytesFor(plan.request.size, plan.request.channels());
    Request request = plan.request;
    for (const RecipeStep& step : steps) {
        RunStep planned{&findMethod(step.method), {}, {}};
        if (!plan.steps.empty() && !planned.method->info().startsFromImage)
            failUsage("{} cannot start from an image, so it cannot follow {}.",
                      Message(planned.method->info().title), Message(plan.lastMethod().info().title));
        planned.settings = planned.method->resolved(step.parameters, exemplar);
        planned.method->check(request, planned.settings);
        planned.estimate = planned.method->estimate(request, planned.settings, plan.threads);
        plan.estimate.bytes =
            std::max(plan.estimate.bytes, planned.estimate.bytes + (plan.steps.empty() ? 0 : between));
        plan.estimate.seconds += planned.estimate.seconds;
        plan.steps.push_back(std::move(planned));
        request.initial = nullptr; // what the first step starts from is not there for the next
    }
}

ExemplarFile loadNamed(const RecipeFile& file, ExemplarFile loaded,
                       const std::function<void(const std::filesystem::path&)>& changed) {
    if (changed && !file.hash.empty() && file.hash != loaded.hash)
        changed(file.path);
    return loaded;
}

} // namespace

RunPlan planRun(const RunInput& input, std::uint64_t memoryLimit, bool strips) {
    RunPlan plan;
    if (input.exemplars.empty())
        failUsage("There is no exemplar to learn from.");
    checkCompanions(input);
    plan.threads = threadCount(input.threads);
    plan.judged = input.judged;
    plan.memoryBefore = residentMemory();
    const std::vector<RecipeStep> steps = stepsOf(input);
    const bool stacks =
        !input.exemplars.front().companions.empty() && !findMethod(steps.back().method).info().copiesPixels;
    plan.request = requestFor(input, stacks);
    planSteps(plan, steps);
    const std::uint64_t limit = memoryLimit > 0 ? memoryLimit : availableMemory();
    if (strips && plan.estimate.bytes > limit)
        planStrips(plan, limit);
    checkMemory(plan.estimate, plan.request, limit);
    plan.recipe = recipeFor(input, plan.steps);
    for (const RunExemplar& exemplar : input.exemplars)
        plan.companions.push_back(exemplar.companions);
    return plan;
}

void checkMemory(const RunPlan& plan) {
    checkMemory(plan.estimate, plan.request, availableMemory());
}

RunPlan RunPlan::strip(int y) const {
    const Region part = request.part();
    RunPlan one = *this;
    one.request.region = Region{part.x, y, {part.size.width, std::min(stripRows, part.bottom() - y)}};
    one.stripRows = 0;
    one.judged = false;
    return one;
}

RecipeFile recipeFile(const ExemplarFile& file) {
    return {file.path, file.space, file.hash};
}

RecipeExemplar recipeExemplar(const RunExemplar& exemplar) {
    RecipeExemplar entry;
    entry.image = recipeFile(exemplar.image);
    if (exemplar.mask)
        entry.mask = recipeFile(*exemplar.mask);
    for (const ExemplarFile& companion : exemplar.companions)
        entry.companions.push_back(companionFile(companion));
    entry.edits = exemplar.edits;
    entry.weight = exemplar.weight;
    return entry;
}

RunExemplar loadFiles(const RecipeExemplar& entry,
                      const std::function<void(const std::filesystem::path&)>& changed) {
    RunExemplar exemplar;
    exemplar.weight = entry.weight;
    exemplar.image = loadNamed(entry.image, loadExemplar(entry.image.path, entry.image.space), changed);
    if (entry.mask)
        exemplar.mask = loadNamed(*entry.mask, loadMask(entry.mask->path), changed);
    for (const RecipeFile& companion : entry.companions) {
        exemplar.companions.push_back(loadNamed(companion, loadData(companion.path), changed));
        if (!companion.role.empty())
            exemplar.companions.back().role = mapRoleFrom(companion.role);
    }
    return exemplar;
}

RunInput loadRecipe(const Recipe& recipe, const std::function<void(const std::filesystem::path&)>& changed) {
    RunInput input;
    input.method = recipe.method;
    input.settings = recipe.parameters;
    input.then = recipe.then;
    for (const RecipeStep& step : stepsOf(input))
        findMethod(step.method).resolved(step.parameters, {});
    input.size = recipe.size;
    input.wrap = recipe.wrap;
    input.seed = recipe.seed;
    input.region = recipe.region;
    for (const RecipeExemplar& entry : recipe.exemplars)
        input.exemplars.push_back(edited(loadFiles(entry, changed), entry.edits));
    if (recipe.initial)
        input.initial =
            loadNamed(*recipe.initial, loadExemplar(recipe.initial->path, recipe.initial->space), changed);
    return input;
}

std::string RunPlan::methodIds(const std::string& separator) const {
    std::string ids = steps.front().method->id();
    for (std::size_t i = 1; i < steps.size(); ++i)
        ids += separator + steps[i].method->id();
    return ids;
}

} // namespace texloom

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/image/channel_text.h"
#include "core/job/memory.h"
#include "core/session/run/companion_stack.h"
#include "core/session/run/edited_exemplar.h"
#include "core/session/run/exemplar_use.h"
#include "core/session/run/older_recipes.h"
#include "core/session/run/run.h"

#include <algorithm>
#include <utility>

namespace texloom {

namespace {

RecipeFile companionFile(const ExemplarFile& file) {
    RecipeFile companion = recipeFile(file);
    companion.role = mapRoleId(file.role);
    companion.channel = file.channel;
    return companion;
}

Recipe recipeFor(const RunInput& input, const std::vector<RunStep>& steps) {
    Recipe recipe;
    recipe.version = kVersion;
    recipe.steps.clear();
    for (const RunStep& step : steps)
        recipe.steps.push_back({step.method->id(), step.settings});
    recipe.size = input.size;
    recipe.wrap = input.wrap;
    recipe.seed = input.seed;
    recipe.region = input.region;
    for (const RunExemplar& exemplar : input.exemplars)
        recipe.exemplars.push_back(recipeExemplar(exemplar));
    recipe.inputs = recipeInputs(input.inputs);
    return recipe;
}

bool hasColor(const Image& image) {
    return image.channels() >= 3;
}

bool hasAlpha(const Image& image) {
    return image.channels() == 2 || image.channels() == 4;
}

/// A picture with three channels for its one where `color` says, and an alpha of 1 where `alpha` says.
Image promoted(const Image& image, bool color, bool alpha) {
    std::vector<ImageView> planes;
    const int shades = image.channels() - (hasAlpha(image) ? 1 : 0);
    for (int c = 0; c < (color ? 3 : 1); ++c)
        planes.push_back(image.view().channelRange(std::min(c, shades - 1), 1));
    Image opaque;
    if (alpha && hasAlpha(image)) {
        planes.push_back(image.view().channelRange(image.channels() - 1, 1));
    } else if (alpha) {
        opaque = Image(image.size(), 1);
        for (int y = 0; y < opaque.height(); ++y)
            std::fill_n(opaque.plane(0).row(y), opaque.width(), 1.0F);
        planes.push_back(opaque);
    }
    return stacked(planes);
}

/// Exemplars of which some are grey and others coloured, or only some have alpha, made alike: grey ones get
/// three equal channels, those without alpha one that is 1 everywhere.
RunInput withAlikeChannels(const RunInput& asked, std::vector<Message>& notes) {
    RunInput input = asked;
    const auto has = [&](bool (*what)(const Image&)) {
        return std::any_of(input.exemplars.begin(), input.exemplars.end(),
                           [what](const RunExemplar& exemplar) { return what(*exemplar.image.image); });
    };
    const bool color = has(hasColor), alpha = has(hasAlpha);
    const int channels = (color ? 3 : 1) + (alpha ? 1 : 0);
    for (const RunExemplar& exemplar : input.exemplars)
        if (exemplar.image.image->channels() > 4)
            return input;
    for (RunExemplar& exemplar : input.exemplars) {
        const std::shared_ptr<const Image> image = exemplar.image.image;
        if (image->channels() == channels)
            continue;
        if (color && !hasColor(*image))
            notes.push_back(
                message("{} is grey and is taken as coloured, as the others are.", exemplar.image.name()));
        exemplar.image.image = std::make_shared<const Image>(promoted(*image, color, alpha));
    }
    return input;
}

Assets assetsOf(const InputFiles& inputs) {
    Assets assets;
    for (const auto& [port, files] : inputs)
        for (const InputFile& file : files)
            assets.add(port, file.asset);
    return assets;
}

Request requestFor(const RunInput& input, const CompanionUse& companions) {
    Request request;
    const bool stacks = companions.stacked;
    std::vector<std::shared_ptr<const Image>> images;
    if (stacks)
        images = stackedExemplars(input.exemplars, companions);
    for (std::size_t i = 0; i < input.exemplars.size(); ++i) {
        const RunExemplar& exemplar = input.exemplars[i];
        Exemplar given{exemplar.image.name(), stacks ? images[i] : exemplar.image.image,
                       assetsOf(exemplar.inputs), exemplar.weight};
        if (exemplar.mask)
            given.inputs.set(kMaskPort, exemplar.mask->image);
        request.exemplars.push_back(std::move(given));
    }
    if (stacks)
        request.companionChannels = request.channels() - input.exemplars.front().image.image->channels();
    request.inputs = assetsOf(input.inputs);
    if (const Image* initial = request.initial(); initial && stacks)
        request.inputs.set(kInitialPort, withMeans(*initial, *request.exemplars.front().image));
    request.size = input.size;
    request.wrap = input.wrap;
    request.seed = input.seed;
    request.region = input.region;
    return request;
}

void checkCompanions(const RunInput& input) {
    if (input.exemplars.empty())
        return;
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
    if (const Method& last = findMethod(input.steps.back().method);
        count > 0 && !useOf(input.steps).companions)
        failUsage("{} learns from no exemplar, so that it makes no companion maps; leave them out.",
                  Message(last.info().title));
}

/// @param room what `limit` is, in words: see availableMemoryText().
void checkMemory(const Estimate& estimate, const Request& request, std::uint64_t limit, const Message& room) {
    if (estimate.bytes > limit)
        fail("An output of {} × {} px would need {} of memory, more than {}; choose a smaller size.",
             request.part().size.width, request.part().size.height, byteText(estimate.bytes), room);
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
    if (plan.steps.size() > 1 || !plan.lastMethod().info().makesParts())
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

/// Stands for something that is not there yet.
Asset nothingYet(AssetKind kind) {
    switch (kind) {
    case AssetKind::Image:
    case AssetKind::Mask:
        break;
    case AssetKind::Map:
        return std::shared_ptr<const PositionMap>();
    case AssetKind::Model:
        return std::shared_ptr<const Model>();
    case AssetKind::Volume:
        return std::shared_ptr<const VolumeSource>();
    case AssetKind::Mesh:
        return std::shared_ptr<const Mesh>();
    }
    return std::shared_ptr<const Image>();
}

/// A method that goes on from the image of the one before it makes one of as many channels.
void checkTakenUp(int made, int wanted) {
    if (made != wanted)
        failUsage("The image to start from has {}, the output {}; they need the same number.",
                  channelText(made), wanted);
}

/// Puts in a request what the method before will have made: null, since it is not there yet. What it makes
/// must not be given as a file, too, but for a method that comes earlier still.
void expectWhatIsMade(const RunPlan& plan, const MethodInfo& info, Request& request) {
    const MethodInfo& before = plan.lastMethod().info();
    for (const PortLink& link : linksBetween(before, info)) {
        if (link.to == kInitialPort) {
            checkTakenUp(plan.steps.back().channels, request.channels());
            continue;
        }
        const bool forEarlier =
            std::any_of(plan.steps.begin(), plan.steps.end(), [&link](const RunStep& step) {
                return step.method->info().input(link.to) != nullptr;
            });
        if (!forEarlier && !plan.request.inputs.at(link.to).empty())
            failUsage("The input {} of {} was given, and {} makes it, too; leave one of them out.", link.to,
                      Message(info.title), Message(before.title));
        request.inputs.set(link.to, nothingYet(info.input(link.to)->kind));
    }
}

/// Checks each step and adds it with its estimate. A later step finds the image of the one before it in
/// memory, too.
void planSteps(RunPlan& plan, const std::vector<RecipeStep>& steps) {
    const Size exemplar =
        plan.request.exemplars.empty() ? Size{} : plan.request.exemplars.front().image->size();
    for (const RecipeStep& step : steps) {
        RunStep planned;
        planned.method = &findMethod(step.method);
        const MethodInfo& info = planned.method->info();
        if (!plan.steps.empty() && linksBetween(plan.lastMethod().info(), info).empty())
            failUsage("{} uses nothing that {} makes, so it cannot follow it.", Message(info.title),
                      Message(plan.lastMethod().info().title));
        Request request = plan.requestFor(plan.steps.size(), info, plan.steps.size() + 1 == steps.size());
        if (!plan.steps.empty())
            expectWhatIsMade(plan, info, request);
        planned.settings = planned.method->resolved(step.parameters, exemplar);
        planned.method->check(request, planned.settings);
        planned.estimate = planned.method->estimate(request, planned.settings, plan.threads);
        planned.channels = planned.method->channels(request, planned.settings);
        const std::uint64_t between =
            plan.steps.empty() ? 0 : Image::bytesFor(plan.request.size, plan.steps.back().channels);
        plan.estimate.bytes = std::max(plan.estimate.bytes, planned.estimate.bytes + between);
        plan.estimate.seconds += planned.estimate.seconds;
        plan.steps.push_back(std::move(planned));
    }
}

void addNotes(const ExemplarFile& file, std::vector<Message>& notes) {
    for (const Message& note : file.info.notes)
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) // several maps may be of one file
            notes.push_back(note);
}

/// What someone should know of how the files were read.
std::vector<Message> notesOf(const RunInput& input) {
    std::vector<Message> notes;
    for (const RunExemplar& exemplar : input.exemplars) {
        addNotes(exemplar.image, notes);
        if (exemplar.mask)
            addNotes(*exemplar.mask, notes);
        for (const ExemplarFile& companion : exemplar.companions)
            addNotes(companion, notes);
        for (const auto& [port, files] : exemplar.inputs)
            for (const InputFile& file : files)
                addNotes(file.file, notes);
    }
    for (const auto& [port, files] : input.inputs)
        for (const InputFile& file : files)
            addNotes(file.file, notes);
    return notes;
}

ExemplarFile loadNamed(const RecipeFile& file, ExemplarFile loaded,
                       const std::function<void(const std::filesystem::path&)>& changed) {
    if (changed && !file.hash.empty() && file.hash != loaded.hash)
        changed(file.path);
    return loaded;
}

/// The same for what goes into a port. @param exemplars as of loadInput()
InputFile loadChecked(const Port& port, const RecipeFile& file, const std::vector<Size>& exemplars,
                      const std::function<void(const std::filesystem::path&)>& changed) {
    InputFile loaded = loadInput(port, file, exemplars);
    if (changed && !file.hash.empty() && file.hash != loaded.file.hash)
        changed(file.path);
    return loaded;
}

/// The port for what belongs to an exemplar, of this id; a picture's if none of the methods has it.
Port ownPort(const std::vector<RecipeStep>& steps, const std::string& id) {
    for (const RecipeStep& step : steps)
        if (const Port* port = findMethod(step.method).info().input(id))
            return *port;
    return {.id = id, .title = {}, .help = {}, .extent = Extent::Exemplar};
}

} // namespace

RunPlan planRun(const RunInput& asked, std::uint64_t memoryLimit, bool strips) {
    RunPlan plan;
    const RunInput input = withAlikeChannels(asked, plan.notes);
    checkExemplarCount(input.steps, input.exemplars.size());
    checkCompanions(input);
    plan.threads = threadCount(input.threads);
    plan.judged = input.judged;
    plan.memoryBefore = residentMemory();
    for (const auto& [port, files] : input.inputs)
        portOf(input.steps, port);
    for (const RunExemplar& exemplar : input.exemplars)
        for (const auto& [port, files] : exemplar.inputs)
            portOf(input.steps, port);
    const CompanionUse companions = companionUse(input);
    plan.request = requestFor(input, companions);
    if (companions.inVain)
        plan.notes.emplace_back(TR("What the run starts from has no companion maps, so their weight had no "
                                   "effect."));
    planSteps(plan, input.steps);
    const std::uint64_t limit = memoryLimit > 0 ? memoryLimit : availableMemory();
    if (strips && plan.estimate.bytes > limit)
        planStrips(plan, limit);
    checkMemory(plan.estimate, plan.request, limit,
                memoryLimit > 0 ? message("the {} that it may take", byteText(limit))
                                : availableMemoryText());
    plan.recipe = recipeFor(input, plan.steps);
    if (!input.exemplars.empty())
        plan.exemplarInfo = input.exemplars.front().image.info;
    for (Message& note : notesOf(input))
        plan.notes.push_back(std::move(note));
    for (const RunExemplar& exemplar : input.exemplars)
        plan.companions.push_back(exemplar.companions);
    return plan;
}

const Port& portOf(const std::vector<RecipeStep>& steps, std::string_view id) {
    const MethodInfo& first = findMethod(steps.front().method).info();
    if (const Port* port = first.input(id))
        return *port;
    if (id == kInitialPort) // methods that follow start from what the one before them made
        failUsage("{} cannot start from an image.", Message(first.title));
    for (const RecipeStep& step : steps)
        if (const Port* port = findMethod(step.method).info().input(id))
            return *port;
    failUsage("{} has no input {}.", Message(first.title), id);
}

void checkMemory(const RunPlan& plan) {
    checkMemory(plan.estimate, plan.request, availableMemory(), availableMemoryText());
}

Request RunPlan::requestFor(std::size_t step, const MethodInfo& info, bool last) const {
    Request own = request;
    if (step > 0) {
        own.inputs.clear(kInitialPort); // what the first starts from is not there for the next
        for (const PortLink& link : linksBetween(steps[step - 1].method->info(), info))
            own.inputs.clear(link.to); // the method before makes it
    }
    for (const auto& [port, given] : request.inputs.byPort())
        if (!info.input(port))
            own.inputs.clear(port);
    for (std::size_t i = 0; i < own.exemplars.size(); ++i)
        for (const auto& [port, given] : request.exemplars[i].inputs.byPort())
            if (port != kMaskPort && !info.input(port))
                own.exemplars[i].inputs.clear(port);
    if (!info.takesExemplars()) {
        own.exemplars.clear();
        own.companionChannels = 0;
    }
    if (step > 0)
        own.freeChannels = steps[step - 1].channels;
    if (!last && !info.canWrap())
        own.wrap = {};
    return own;
}

Assets learnedBy(const MethodInfo& info, const Assets& made) {
    Assets learned;
    for (const PortLink& link : linksBetween(info, info))
        if (const auto model = made.first<Model>(link.from))
            learned.set(link.to, model);
    return learned;
}

RunPlan RunPlan::strip(int y, const Assets* learned) const {
    const Region part = request.part();
    RunPlan one = *this;
    one.request.region = Region{part.x, y, {part.size.width, std::min(stripRows, part.bottom() - y)}};
    one.request.continues = learned != nullptr;
    if (learned != nullptr)
        for (const auto& [port, models] : learned->byPort())
            one.request.inputs.set(port, models.front());
    one.stripRows = 0;
    one.judged = false;
    return one;
}

RecipeInputs recipeInputs(const InputFiles& inputs) {
    RecipeInputs entries;
    for (const auto& [port, files] : inputs)
        for (const InputFile& file : files)
            entries[port].push_back(recipeFile(file.file));
    return entries;
}

RecipeFile recipeFile(const ExemplarFile& file) {
    return {file.path, file.space, file.hash, {}, file.layer};
}

RecipeExemplar recipeExemplar(const RunExemplar& exemplar) {
    RecipeExemplar entry;
    entry.image = recipeFile(exemplar.image);
    if (exemplar.mask)
        entry.mask = recipeFile(*exemplar.mask);
    for (const ExemplarFile& companion : exemplar.companions)
        entry.companions.push_back(companionFile(companion));
    entry.inputs = recipeInputs(exemplar.inputs);
    entry.edits = exemplar.edits;
    entry.weight = exemplar.weight;
    return entry;
}

RunExemplar loadFiles(const RecipeExemplar& entry, const std::vector<RecipeStep>& steps,
                      const std::function<void(const std::filesystem::path&)>& changed) {
    RunExemplar exemplar;
    exemplar.weight = entry.weight;
    exemplar.image =
        loadNamed(entry.image, loadExemplar(entry.image.path, entry.image.space, entry.image.layer), changed);
    if (entry.mask)
        exemplar.mask = loadNamed(*entry.mask, loadMask(entry.mask->path, entry.mask->layer), changed);
    for (const RecipeFile& companion : entry.companions) {
        exemplar.companions.push_back(
            loadNamed(companion, loadData(companion.path, companion.layer, companion.channel), changed));
        if (!companion.role.empty())
            exemplar.companions.back().role = mapRoleFrom(companion.role);
    }
    for (const auto& [id, files] : entry.inputs)
        for (const RecipeFile& file : files)
            exemplar.inputs[id].push_back(loadChecked(ownPort(steps, id), file, {}, changed));
    return exemplar;
}

RunInput loadRecipe(const Recipe& recipe, const std::function<void(const std::filesystem::path&)>& changed) {
    RunInput input;
    input.steps = recipe.steps;
    if (!recipe.version.empty()) // those written by hand leave out what is to have its default
        completeOlder(input.steps);
    for (const RecipeStep& step : input.steps)
        findMethod(step.method).resolved(step.parameters, {});
    input.size = recipe.size;
    input.wrap = recipe.wrap;
    input.seed = recipe.seed;
    input.region = recipe.region;
    for (const RecipeExemplar& entry : recipe.exemplars)
        input.exemplars.push_back(edited(loadFiles(entry, input.steps, changed), entry.edits));
    input.inputs = loadInputs(recipe.inputs, input.steps, input.exemplars, changed);
    return input;
}

InputFiles loadInputs(const RecipeInputs& wanted, const std::vector<RecipeStep>& steps,
                      const std::vector<RunExemplar>& exemplars,
                      const std::function<void(const std::filesystem::path&)>& changed) {
    std::vector<Size> sizes;
    for (const RunExemplar& exemplar : exemplars)
        sizes.push_back(exemplar.image.image->size());
    InputFiles inputs;
    for (const auto& [id, files] : wanted) {
        const Port& port = portOf(steps, id);
        for (const RecipeFile& file : files)
            inputs[id].push_back(loadChecked(port, file, sizes, changed));
    }
    return inputs;
}

std::string RunPlan::methodIds(const std::string& separator) const {
    std::string ids = steps.front().method->id();
    for (std::size_t i = 1; i < steps.size(); ++i)
        ids += separator + steps[i].method->id();
    return ids;
}

std::string RunPlan::name() const {
    return request.exemplars.empty() ? recipe.name() : request.exemplars.front().name;
}

} // namespace texloom

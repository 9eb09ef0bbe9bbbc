#include "app/cli/commands.h"

#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/color/color_pipeline.h"
#include "core/io/json_field.h"
#include "core/io/map_file.h"
#include "core/session/export/export.h"
#include "core/session/export/output_files.h"
#include "core/session/preset.h"
#include "core/session/run/checkpoint_file.h"
#include "core/session/run/edited_exemplar.h"
#include "core/session/run/exemplar_use.h"
#include "core/session/run/run.h"
#include "core/session/session.h"
#include "core/tools/edits.h"

#include <algorithm>
#include <array>
#include <iostream>

namespace texloom::cli {

namespace fs = std::filesystem;

namespace {

/// The step that a setting is for: the one that it names as METHOD.name, or the first.
RecipeStep& stepFor(std::string& name, std::vector<RecipeStep>& steps) {
    const std::size_t stop = name.find('.');
    if (stop == std::string::npos)
        return steps.front();
    const std::string method = name.substr(0, stop);
    const auto found = std::find_if(steps.begin(), steps.end(),
                                    [&](const RecipeStep& step) { return step.method == method; });
    if (found == steps.end())
        failUsage("--set {}: {} is not one of the methods of this run.", name, method);
    name = name.substr(stop + 1);
    return *found;
}

/// What `--preset` of a method stands for. @throws UsageError that lists the method's presets.
const Preset& presetOf(const std::string& method, const std::string& name) {
    const std::string prefix = findMethod(method).id() + "-";
    if (const Preset* preset = findPreset(prefix + name))
        return *preset;
    std::vector<std::string> known;
    for (const Preset& preset : presets())
        if (preset.id.rfind(prefix, 0) == 0)
            known.push_back(preset.id.substr(prefix.size()));
    if (known.empty())
        failUsage("--preset {}: {} has no presets.", name, method);
    failUsage("--preset {}: {} has no such preset; choose one of {}.", name, method, listOf(known));
}

/// The methods of a run in order, from the command's METHOD or preset, --then and --set.
std::vector<RecipeStep> stepsOf(const SynthOptions& options) {
    std::vector<RecipeStep> steps;
    if (!options.preset.empty())
        steps = presetOf(options.method, options.preset).steps;
    else if (const Preset* preset = findPreset(options.method))
        steps = preset->steps;
    else
        steps.push_back({findMethod(options.method).id(), {}});
    for (const std::string& method : options.then)
        steps.push_back({findMethod(method).id(), {}});
    for (const std::string& setting : options.settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos)
            failUsage("--set {}: write it as name=value.", setting);
        std::string name = setting.substr(0, equals);
        RecipeStep& step = stepFor(name, steps);
        step.parameters[name] = findMethod(step.method).param(name).parse(setting.substr(equals + 1));
    }
    return steps;
}

/// Refuses what belongs to exemplars where there are none.
void checkNothingOfExemplars(const SynthOptions& options) {
    const std::pair<bool, const char*> all[] = {
        {!options.companions.empty(), "--companion"},
        {!options.masks.empty(), "--mask"},
        {!options.weights.empty(), "--weight"},
        {!options.edits.empty(), "--edit"},
        {!options.exemplarSpace.empty(), "--space"},
        {LayerChoice(options.layers).names(LayerChoice::kPictures), "--layer"}};
    for (const auto& [given, option] : all)
        if (given)
            failUsage("{} belongs to an exemplar, and there is none.", option);
}

/// Shares files that belong to the exemplars out to them, in order.
void attach(RunInput& input, const SynthOptions& options, LayerChoice& layers) {
    const std::size_t count = input.exemplars.size();
    if (count == 0)
        return checkNothingOfExemplars(options);
    if (!options.weights.empty() && options.weights.size() != count)
        failUsage("{} weights were given for {} exemplars; every one needs its own, or none has any.",
                  options.weights.size(), count);
    for (std::size_t i = 0; i < options.weights.size(); ++i)
        input.exemplars[i].weight = options.weights[i];
    if (options.companions.size() % count != 0)
        failUsage("{} companion maps were given for {} exemplars; every exemplar needs the same number.",
                  options.companions.size(), count);
    const std::size_t each = options.companions.size() / count;
    for (std::size_t i = 0; i < options.companions.size(); ++i)
        for (ExemplarFile& map :
             loadCompanions(options.companions[i], layers.of(kCompanionPort, i, options.companions.size())))
            input.exemplars[i / each].companions.push_back(std::move(map));
}

/// One `--input NAME=FILE`.
struct GivenInput {
    std::string name;
    fs::path file;
    std::string layer = {};
};

/// Loads one `--input NAME=FILE`: a port of the run's, or one of the exemplars' own, which are shared out in
/// order. Those of the other kind are left to another call.
void addInput(RunInput& input, const GivenInput& given, bool ofExemplars) {
    const std::string& name = given.name;
    const Port& port = portOf(input.steps, name);
    if ((port.extent == Extent::Exemplar) != ofExemplars)
        return;
    if (port.id == kExemplarPort || port.id == kCompanionPort)
        failUsage("--input {}: exemplars are named on their own, companion maps with --companion.", name);
    std::vector<Size> sizes;
    for (const RunExemplar& exemplar : input.exemplars)
        sizes.push_back(exemplar.image.image->size());
    if (ofExemplars && input.exemplars.empty())
        failUsage("--input {} belongs to an exemplar, and there is none.", name);
    InputFile loaded = loadInput(port, {given.file, "", "", {}, given.layer}, sizes);
    if (port.extent != Extent::Exemplar) {
        input.inputs[port.id].push_back(std::move(loaded));
        return;
    }
    for (RunExemplar& exemplar : input.exemplars) {
        if (port.id == kMaskPort ? exemplar.mask.has_value() : exemplar.inputs.contains(port.id))
            continue;
        if (port.id == kMaskPort)
            exemplar.mask = std::move(loaded.file);
        else
            exemplar.inputs[port.id].push_back(std::move(loaded));
        return;
    }
    failUsage("--input {}={}: every exemplar has one already.", name, given.file.string());
}

/// The two parts of NAME=FILE.
std::pair<std::string, fs::path> nameAndFile(const char* option, const std::string& given) {
    const std::size_t equals = given.find('=');
    if (equals == std::string::npos || equals + 1 == given.size())
        failUsage("{} {}: write it as NAME=FILE.", option, given);
    return {given.substr(0, equals), given.substr(equals + 1)};
}

/// --input and its short names, each with its layer.
std::vector<GivenInput> inputsOf(const SynthOptions& options, LayerChoice& layers) {
    std::vector<GivenInput> all;
    for (const fs::path& mask : options.masks)
        all.push_back({std::string(kMaskPort), mask});
    if (options.initial)
        all.push_back({std::string(kInitialPort), *options.initial});
    for (const std::string& given : options.inputs) {
        const auto [name, file] = nameAndFile("--input", given);
        all.push_back({name, file});
    }
    std::map<std::string, std::size_t> counts, taken;
    for (const GivenInput& one : all)
        ++counts[one.name];
    for (GivenInput& one : all)
        one.layer = layers.of(one.name, taken[one.name]++, counts[one.name]);
    return all;
}

/// What belongs to an exemplar is edited with it; the rest may depend on the
/// edited exemplars' sizes.
void addInputs(RunInput& input, const std::vector<GivenInput>& given, bool ofExemplars) {
    for (const GivenInput& one : given)
        addInput(input, one, ofExemplars);
}

/// The size of the first picture that must have the output's, if there is one.
std::optional<Size> sizeOfInputs(const RunInput& input) {
    for (const auto& [id, files] : input.inputs)
        if (portOf(input.steps, id).extent == Extent::Output && files.front().image())
            return files.front().image()->size();
    return std::nullopt;
}

/// Of the output, where nobody says: twice the exemplar.
Size usualSize(const RunInput& input) {
    constexpr int kWithoutExemplar = 512;
    if (input.exemplars.empty())
        return {kWithoutExemplar, kWithoutExemplar};
    const Size exemplar = input.exemplars.front().image.image->size();
    return {2 * exemplar.width, 2 * exemplar.height};
}

/// Edits the exemplars as --edit says. An edit is for every exemplar, or for the one whose number stands
/// before it.
void edit(RunInput& input, const std::vector<std::string>& edits) {
    const std::size_t count = input.exemplars.size();
    std::vector<ExemplarEdits> each(count);
    for (const std::string& text : edits) {
        const std::size_t colon = text.find(':');
        long long number = 0;
        const bool numbered = colon != std::string::npos && parseInteger(text.substr(0, colon), number);
        if (numbered && (number < 1 || number > static_cast<long long>(count)))
            failUsage("--edit {}: there is no exemplar {}; they are numbered from 1 to {}.", text, number,
                      count);
        const ExemplarEdit made = parseEdit(numbered ? text.substr(colon + 1) : text);
        for (std::size_t i = 0; i < count; ++i)
            if (!numbered || static_cast<long long>(i) + 1 == number)
                each[i].push_back(made);
    }
    for (std::size_t i = 0; i < count; ++i)
        input.exemplars[i] = edited(input.exemplars[i], each[i], checkInterrupt);
}

Depth parseDepth(const std::string& text, const ImageFileInfo& exemplar, const fs::path& path) {
    if (text.empty())
        return depthLike(exemplar, path);
    for (const Depth depth : {Depth::Bits8, Depth::Bits16, Depth::Half, Depth::Float})
        if (depthName(depth) == text || depthName(depth) == text + "-bit")
            return depth;
    failUsage("--depth {}: it is one of 8, 16, half and float.", text);
}

/// Where --save wants the run's further outputs; refuses what cannot be written there.
std::map<std::string, fs::path> savesOf(const RunPlan& plan, const OutputOptions& out) {
    std::map<std::string, fs::path> files;
    for (const std::string& given : out.saves) {
        const auto [name, file] = nameAndFile("--save", given);
        checkOutput(plan, name, file);
        if (!files.emplace(name, file).second)
            failUsage("--save {}: {} was named before; each output is written once.", given, name);
    }
    return files;
}

/// Refuses before the work what would fail after it, or write over what it was made from.
void checkOutputs(const RunPlan& plan, const ExportOptions& options, const OutputOptions& out) {
    checkWritable(options.image, plan.resultChannels(), options.depth);
    if (options.space == color::kFileSpace)
        failUsage("--out-space {}: an output is in one of the spaces that have a name, or raw.",
                  options.space);
    if (!options.space.empty())
        color::findSpace(options.space);
    for (const fs::path& map : options.maps) {
        mapConvention(map);
        checkWritable(map, 3, depthsFor(map).back());
    }
    OutputGuard guard(out.around);
    announce(plan, options, guard);
    if (!out.report.empty()) {
        checkFolder(out.report);
        guard.writes(out.report, "report");
    }
    guard.check(out.overwrite);
}

/// Runs a plan that leaves checkpoints beside the output, if its methods do, and goes on from the last one if
/// that is wanted.
Result runWithCheckpoints(RunPlan plan, const OutputOptions& out) {
    const fs::path file = checkpointFor(out.output);
    Checkpoints checkpoints;
    if (fs::exists(file)) {
        const CheckpointFile earlier = readCheckpoint(file); // also refuses to write over something else
        if (out.resume)
            checkpoints.resumed = resumable(earlier, plan);
        else
            fmt::print(messages(),
                       "texloom-cli: {} is of an earlier run, at {:.0f} %, and is replaced as this one goes "
                       "on; --resume takes it up.\n",
                       file.string(), 100 * earlier.checkpoint.progress);
    } else if (out.resume) {
        fmt::print(messages(),
                   "texloom-cli: There is no checkpoint {}, so the run begins at the beginning.\n",
                   file.string());
    }
    checkpoints.keep = [file, recipe = plan.recipe](const Checkpoint& checkpoint) {
        writeCheckpoint(file, recipe, checkpoint);
    };
    return followed(*startRun(std::move(plan), false, {}, std::move(checkpoints)), out.quiet);
}

/// Runs a planned synthesis to the end and writes what was asked for. @return the method's figures; those of
/// an output that is made in strips are the last strip's, and none is returned.
std::vector<Figure> execute(RunPlan plan, const OutputOptions& out) {
    ExportOptions options;
    options.image = out.output;
    options.depth = parseDepth(out.depth, plan.exemplarInfo, out.output);
    options.space = out.space;
    options.maps = out.maps;
    options.outputs = savesOf(plan, out);
    options.sidecar = !out.noSidecar;
    if (!out.exportPreset.empty()) {
        options.preset = exportPresetFrom(out.exportPreset);
        options.pattern = options.preset.pattern;
    }
    options.check = checkInterrupt;
    checkOutputs(plan, options, out);

    const auto make = [&out](RunPlan run) { return runToEnd(std::move(run), out.quiet); };
    const Result result =
        plan.stripRows > 0 ? exportStrips(plan, options, make) : runWithCheckpoints(std::move(plan), out);
    if (result.plan.stripRows == 0) {
        exportResult(result, options);
        fs::remove(checkpointFor(out.output));
    }
    for (const Message& note : result.synthesis.notes)
        if (!out.quiet)
            fmt::print("{}\n", note);
    for (const OutputFile& output : outputFiles(result, options.outputs))
        if (!out.quiet)
            fmt::print("{}: {}\n", output.path.string(), output.content());
    if (!out.report.empty())
        writeText(out.report, reportJson(result, out.report.parent_path()));
    if (!out.quiet)
        fmt::print("{}: {} × {} px in {}\n", out.output.string(), result.plan.request.part().size.width,
                   result.plan.request.part().size.height, durationText(result.seconds));
    return result.plan.stripRows > 0 ? std::vector<Figure>() : result.synthesis.figures;
}

} // namespace

RunInput inputFor(const SynthOptions& options) {
    RunInput input;
    input.steps = stepsOf(options);
    input.wrap = options.wrap;
    input.seed = options.seed;
    input.region = options.region;
    checkExemplarCount(input.steps, options.exemplars.size());
    LayerChoice layers(options.layers);
    const std::vector<GivenInput> given = inputsOf(options, layers);
    for (const fs::path& path : options.exemplars)
        input.exemplars.push_back({loadExemplar(path, options.exemplarSpace,
                                                layers.of(LayerChoice::kPictures, input.exemplars.size(),
                                                          options.exemplars.size())),
                                   {},
                                   {}});
    attach(input, options, layers);
    layers.checkUsed();
    addInputs(input, given, true);
    edit(input, options.edits);
    addInputs(input, given, false);
    input.size = options.size ? *options.size : sizeOfInputs(input).value_or(usualSize(input));
    return input;
}

Result runToEnd(RunPlan plan, bool quiet) {
    return followed(*startRun(std::move(plan), false), quiet);
}

void checkOnlyOutput(const std::vector<fs::path>& sources, const fs::path& output, bool overwrite) {
    OutputGuard guard;
    guard.reads(sources, "a source of the result");
    guard.writes(output, "result");
    guard.check(overwrite);
}

RunInput loadAndWarn(const Recipe& recipe) {
    static std::string told; // once for a batch of them
    if (!recipe.version.empty() && recipe.version != kVersion && recipe.version != told) {
        fmt::print(messages(),
                   "texloom-cli: The recipe was made by Texloom {}; this is {}, so the result may differ.\n",
                   recipe.version, kVersion);
        told = recipe.version;
    }
    return loadRecipe(recipe, [](const fs::path& file) {
        fmt::print(messages(),
                   "texloom-cli: {} is not the file that the recipe was made with; the result will differ.\n",
                   file.string());
    });
}

std::vector<Figure> runInput(RunInput input, const OutputOptions& out) {
    input.threads = out.threads;
    input.judged = !out.report.empty();
    return execute(planRun(input, 0, true), out);
}

void synth(const SynthOptions& options) {
    runInput(inputFor(options), options.out);
}

void runRecipe(const RunOptions& options) {
    RunInput input = loadAndWarn(readRun(options.recipe));
    OutputOptions out = options.out;
    OutputGuard around;
    around.reads(options.recipe, "the recipe of this run");
    out.around = &around;
    if (out.output.empty()) {
        input.threads = out.threads;
        Result unnamed;
        unnamed.plan = planRun(input, 0, true);
        out.output = unnamed.fileName() + ".png";
        if (fs::exists(out.output))
            fail("{} already exists; name the output with -o.", out.output.string());
    }
    runInput(std::move(input), out);
}

} // namespace texloom::cli

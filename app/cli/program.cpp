#include "app/cli/program.h"

#include "app/cli/analyze_character.h"
#include "app/cli/analyze_maps.h"
#include "app/cli/analyze_quality.h"
#include "app/cli/analyze_statistics.h"
#include "app/cli/batch_command.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/descriptor_commands.h"
#include "app/cli/join_commands.h"
#include "app/cli/layer_choice.h"
#include "app/cli/method_pages.h"
#include "app/cli/option_forms.h"
#include "app/cli/sample_command.h"
#include "core/base/error.h"
#include "core/base/version.h"

#include <CLI/CLI.hpp>

namespace texloom::cli {

namespace {

enum Exit { Done = 0, Failed = 1, Usage = 2, CancelledByUser = 130 };

void addOutputOptions(CLI::App& command, OutputOptions& out, bool outputRequired) {
    auto* output = command.add_option("-o,--output", out.output, "File to write: .png .jpg .tif .exr .hdr");
    if (outputRequired)
        output->required();
    command.add_option("--map", out.maps,
                       "Position map to write: .exr (STMap) or .png (16-bit); may be repeated");
    command
        .add_option("--save", out.saves,
                    "What else the method gives, such as a model or a volume, as NAME=FILE; see `methods`; "
                    "may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    command.add_option("--depth", out.depth,
                       "Depth of the output: 8, 16, half or float; the exemplar's if not given");
    command.add_option("--out-space", out.space, "Colour space of the output: srgb, linear, acescg or raw");
    command.add_option(
        "--export-preset", out.exportPreset,
        "How companion maps are named and packed, and where green points in normal maps: generic, "
        "blender, unity, unreal, godot, gltf, or the .json file of one of your own");
    command
        .add_option("--threads", out.threads,
                    "Number of threads; one per core if not given. The result is the same")
        ->check(CLI::Range(1, 1024));
    addMemory(command);
    addReproducible(command, false);
    command.add_option("--report", out.report,
                       "JSON file for recipe, timings, peak memory, figures and curves");
    command.add_flag("--resume", out.resume,
                     "Go on from the checkpoint that a run which was broken off left beside the output");
    addOverwrite(command, out.overwrite);
    command.add_flag("--no-sidecar", out.noSidecar, "Do not write the recipe beside the output");
    command.add_flag("--quiet", out.quiet, "Print nothing but errors");
}

void addMethods(CLI::App& app) {
    static std::string id;
    static bool json = false;
    static std::filesystem::path pages;
    static bool overwrite = false;
    CLI::App* command = app.add_subcommand("methods", "List every method with its parameters");
    command->add_option("method", id, "Only this one");
    command->add_flag("--json", json, "As JSON");
    command->add_option("--markdown", pages, "Write a page for every method to this folder instead")
        ->excludes("--json");
    addOverwrite(*command, overwrite);
    command->callback([] {
        if (pages.empty())
            listMethods(id, json);
        else
            writeMethodPages(pages, overwrite);
    });
}

void addTools(CLI::App& app) {
    static std::string id;
    static bool json = false;
    CLI::App* command = app.add_subcommand("tools", "List every tool with its parameters");
    command->add_option("tool", id, "Only this one");
    command->add_flag("--json", json, "As JSON");
    command->callback([] { listTools(id, json); });
}

void addSynthOptions(CLI::App& command, SynthOptions& options) {
    command.add_option("method", options.method, "Id of the method or preset; see `methods`")->required();
    command.add_option("exemplar", options.exemplars,
                       "Images to learn from, where the method learns from any");
    command.add_option("--preset", options.preset,
                       "Preset of the method: published for the settings of its source");
    addSize(command, options.size,
            "Size of the output, as 512x256 or 512; twice the exemplar if not given, 512 without one");
    addSeed(command, options.seed, "Whole number from 0; another seed gives another texture");
    command
        .add_option("--then", options.then,
                    "Method that follows, starting from the image made so far; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option("--set", options.settings,
                    "Parameter of the method, as name=value, or METHOD.name=value for one that follows; may "
                    "be repeated")
        ->take_all()
        ->allow_extra_args(false);
    addWrap(command, options.wrap, "Axes on which the output tiles: x, y or xy");
    addRegion(command, options.region,
              "Part of the output to make, as x,y,width,height; it equals that part of the whole");
    command
        .add_option(
            "--edit", options.edits,
            "Change of the exemplars, their masks and companions, as TOOL=value, with further settings "
            "after a blank; see `tools`. 2:TOOL=value is for the second exemplar alone; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option("--companion", options.companions,
                    "Map of the exemplar's size that gets the same layout; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    command.add_option("--init", options.initial,
                       "Image of the output's size to start from; short for --input initial=FILE");
    command
        .add_option("--input", options.inputs,
                    "What goes into an input of the method, as NAME=FILE; see `methods`; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option("--mask", options.masks,
                    "Image of the exemplar's size; where it is black nothing is copied")
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option(
            "--weight", options.weights,
            "How much each exemplar counts beside the others, 0.01 to 100, in their order; 2 counts as "
            "though it were given twice")
        ->take_all()
        ->allow_extra_args(false);
    command.add_option("--space", options.exemplarSpace,
                       "Colour space of the exemplars; what the file says if not given");
    addLayers(command, options.layers, "companion, mask, initial or another input");
}

void addSynth(CLI::App& app) {
    static SynthOptions options;
    CLI::App* command = app.add_subcommand("synth", "Make a texture from one or more exemplars");
    addSynthOptions(*command, options);
    addOutputOptions(*command, options.out, true);
    command->callback([] { synth(options); });
}

void addStress(CLI::App& app) {
    static StressOptions options;
    CLI::App* command = app.add_subcommand(
        "stress", "Make a texture from the previous one, again and again, and measure each");
    addSynthOptions(*command, options.synth);
    command->add_option("--rounds", options.rounds, "Number of rounds; 5 if not given")
        ->check(CLI::Range(1, 1000));
    command
        ->add_option("-o,--output", options.synth.out.output,
                     "Prefix of the files to write: PREFIX_1.png and so on")
        ->required();
    command
        ->add_option("--threads", options.synth.out.threads, "Number of threads; one per core if not given")
        ->check(CLI::Range(1, 1024));
    command->add_option("--report", options.synth.out.report, "JSON file for the figures of all rounds");
    addMemory(*command);
    addReproducible(*command, false);
    addOverwrite(*command, options.synth.out.overwrite);
    command->add_flag("--quiet", options.synth.out.quiet, "Print nothing but errors");
    command->callback([] { stress(options); });
}

void addRun(CLI::App& app) {
    static RunOptions options;
    CLI::App* command = app.add_subcommand("run", "Repeat the run that a recipe describes");
    command->add_option("recipe", options.recipe, "A .json recipe, an image that Texloom wrote, or a session")
        ->required();
    addOutputOptions(*command, options.out, false);
    command->callback([] { runRecipe(options); });
}

void addApply(CLI::App& app) {
    static ApplyOptions options;
    CLI::App* command = app.add_subcommand("apply", "Apply a position map to another image");
    command->add_option("map", options.map, "Position map: .exr (STMap) or .png (16-bit)")->required();
    command
        ->add_option("exemplar", options.exemplars,
                     "One image for each exemplar of the map, of the same size")
        ->required();
    command->add_option("-o,--output", options.output, "File to write")->required();
    addLayers(*command, options.layers, "the map");
    addMemory(*command);
    addReproducible(*command, false);
    addOverwrite(*command, options.overwrite);
    command->add_flag("--quiet", options.quiet, "Print nothing but errors");
    command->callback([] { applyMap(options); });
}

void addAnalyze(CLI::App& app) {
    static LatticeOptions options;
    CLI::App* command = app.add_subcommand("analyze", "Measure an image");
    command->require_subcommand(1);
    CLI::App* lattice =
        command->add_subcommand("lattice", "Find the vectors by which a texture repeats itself");
    lattice->add_option("exemplar", options.exemplar, "Image to look at")->required();
    lattice->add_option("--space", options.exemplarSpace,
                        "Colour space of the image; what the file says if not given");
    addLayers(*lattice, options.layers);
    lattice->add_option(
        "--picture", options.picture,
        "File for the autocorrelation, zero displacement in the middle; .exr keeps values below 0");
    lattice
        ->add_option("--alpha", options.criteria.alpha,
                     "How much small tiles that repeat often are preferred to large ones that fit better: 1 "
                     "not at all")
        ->check(CLI::Range(1.0, 2.0))
        ->capture_default_str();
    lattice
        ->add_option("--significance", options.criteria.significance,
                     "Share of a tile by which the image must overlap itself for a repetition to count")
        ->check(CLI::Range(0.5, 1.0))
        ->capture_default_str();
    addMemory(*lattice);
    addReproducible(*lattice, false);
    addOverwrite(*lattice, options.overwrite);
    lattice->add_flag("--json", options.json, "As JSON");
    lattice->callback([] { printLattice(options); });
    addAnalyzeStatistics(*command);
    addAnalyzeMaps(*command);
    addAnalyzeQuality(*command);
    addAnalyzeCharacter(*command);
}

int complain(const std::string& sentence, Exit code) {
    fmt::print(messages(), "texloom-cli: {}\n", sentence);
    return code;
}

int run(int argc, char** argv) {
    CLI::App app("Texloom makes more of a texture.", "texloom-cli");
    app.set_version_flag("--version", std::string("texloom-cli ") + kVersion);
    app.require_subcommand(0, 1);
    addMethods(app);
    addTools(app);
    addSynth(app);
    addRun(app);
    addBatch(app);
    addApply(app);
    addJoins(app);
    addDescriptorCommands(app);
    addSample(app);
    addAnalyze(app);
    addStress(app);
    needPlainNumbers(app);
    silenceLibraries();
    watchInterrupts();
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty())
            return complain("Name a command: methods, tools, synth, run, batch, apply, blend, sample, "
                            "analyze or stress. See "
                            "texloom-cli --help.",
                            Usage);
        return Done;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0)
            return app.exit(error);
        return complain(std::string(error.what()) + ". See texloom-cli --help.", Usage);
    }
}

} // namespace

int runProgram(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const Cancelled&) {
        return complain("Cancelled.", CancelledByUser);
    } catch (const UsageError& error) {
        return complain(error.what(), Usage);
    } catch (const std::exception& error) {
        return complain(messageOf(error).text(), Failed);
    }
}

} // namespace texloom::cli

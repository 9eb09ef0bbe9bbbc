#include "app/cli/join_commands.h"

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "core/session/export/export.h"
#include "core/session/run/exemplar_file.h"
#include "core/tools/tool.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace texloom::cli {

namespace {

namespace fs = std::filesystem;

struct JoinCommand {
    const Tool* tool = nullptr;
    fs::path first, second, mask, output;
    std::vector<std::string> layers;             ///< as LayerChoice takes them
    std::map<std::string, std::string> settings; ///< as written, by parameter
    bool overwrite = false;
    bool quiet = false;
};

Values settingsOf(const JoinCommand& command) {
    Values values;
    for (const auto& [name, text] : command.settings)
        values[name] = command.tool->param(name).parse(text);
    return command.tool->resolved(values);
}

void run(const JoinCommand& command) {
    JoinInput input{command.tool, {}, {}, {}, settingsOf(command)};
    LayerChoice layers(command.layers);
    input.first = loadExemplar(command.first, {}, layers.of(LayerChoice::kPictures, 0, 2));
    checkInterrupt();
    input.second = loadExemplar(command.second, {}, layers.of(LayerChoice::kPictures, 1, 2));
    checkInterrupt();
    if (!command.mask.empty())
        input.region = loadMask(command.mask, layers.of(kMaskPort)).image;
    layers.checkUsed();
    input.tool->checkJoin(input.pictures(), input.settings);
    std::vector<fs::path> read = {command.first, command.second};
    if (!command.mask.empty())
        read.push_back(command.mask);
    checkOnlyOutput(read, command.output, command.overwrite);
    writeJoin(input, command.output, 0, command.quiet);
}

/// A command for one tool, with an option for each of its parameters.
void addJoin(CLI::App& app, const Tool& tool) {
    const auto options = std::make_shared<JoinCommand>();
    options->tool = &tool;
    CLI::App* command = app.add_subcommand(tool.id(), tool.info().summary);
    command->add_option("first", options->first, "First image")->required();
    command->add_option("second", options->second, "Second image")->required();
    command->add_option("-o,--output", options->output, "File to write: .png .jpg .tif .exr .hdr")
        ->required();
    if (const auto& region = tool.info().region)
        command->add_option("--mask", options->mask, region->help);
    addLayers(*command, options->layers, tool.info().region ? "the mask" : "");
    for (const Param& param : tool.params())
        command->add_option_function<std::string>(
            "--" + param.name(),
            [options, name = param.name()](const std::string& text) { options->settings[name] = text; },
            param.help() + " " + param.limits().text());
    addMemory(*command);
    addReproducible(*command, false);
    addOverwrite(*command, options->overwrite);
    command->add_flag("--quiet", options->quiet, "Print nothing but errors");
    command->callback([options] { run(*options); });
}

} // namespace

void writeJoin(const JoinInput& input, const fs::path& output, int threads, bool quiet) {
    const ExemplarFile& first = input.first;
    checkWritable(output, first.image->channels(), depthLike(first.info, output));
    Job<Image> job({0, threads, false}, [&](JobContext& context) {
        return input.tool->joined(input.pictures(), input.settings, context);
    });
    const Image made = followed(job, quiet);
    exportPicture(output, made, first, checkInterrupt);
    if (quiet)
        return;
    if (const auto note = input.cropNote())
        fmt::print("{}\n", *note);
    fmt::print("{}: {} × {} px\n", output.string(), made.width(), made.height());
}

void addJoins(CLI::App& app) {
    for (const Tool& tool : tools())
        if (tool.joins())
            addJoin(app, tool);
}

} // namespace texloom::cli

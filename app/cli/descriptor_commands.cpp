#include "app/cli/descriptor_commands.h"

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "app/cli/option_forms.h"
#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/io/json_field.h"
#include "core/network/descriptor_learning.h"
#include "core/network/weights_file.h"
#include "core/session/run/exemplar_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

namespace texloom::cli {

namespace {

namespace fs = std::filesystem;

struct LearnOptions {
    std::vector<fs::path> pictures;
    fs::path output;
    std::string name = "learned", licence = "unknown", credit = "Learned with texloom-cli learn-descriptor";
    std::vector<std::string> fileLayers; ///< as LayerChoice takes them
    std::vector<std::string> layers;
    std::vector<int> sides = {256, 110};
    int patches = 20000, rounds = 8, threads = 0;
    std::uint64_t seed = 0;
    bool overwrite = false, quiet = false;
};

struct ImportOptions {
    fs::path json, output;
    std::string pooling = "average";
    WeightsImport how;
    bool overwrite = false, quiet = false;
};

struct ShowOptions {
    fs::path file;
    bool json = false;
};

/// Layers written as 48x5: outputs and side.
std::vector<LearningOptions::Layer> layersFrom(const std::vector<std::string>& words) {
    std::vector<LearningOptions::Layer> layers;
    for (const std::string& word : words) {
        const std::size_t cross = word.find('x');
        long long outputs = 0, side = 0;
        if (cross == std::string::npos || !parseInteger(word.substr(0, cross), outputs) ||
            !parseInteger(word.substr(cross + 1), side) || outputs < 1 || outputs > 1024 || side < 1 ||
            side > 15 || side % 2 == 0)
            failUsage(
                "--layers {}: write each layer as OUTPUTSxSIDE, up to 1024 outputs and an odd side up to 15.",
                word);
        layers.push_back({static_cast<int>(outputs), static_cast<int>(side)});
    }
    return layers;
}

/// The middle of the picture, `side` px or as large as it is, and three channels with values from 0 to 1.
Tensor pictureFor(const Image& image, int side) {
    const Size size{std::min(side, image.width()), std::min(side, image.height())};
    const int left = (image.width() - size.width) / 2, top = (image.height() - size.height) / 2;
    Tensor to(3, size.height, size.width);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                to.row(c, y)[x] =
                    std::clamp(image(left + x, top + y, std::min(c, image.channels() - 1)), 0.0F, 1.0F);
    return to;
}

/// The picture at each size: halved until its shorter side is no more than twice that.
std::vector<Tensor> picturesOf(const LearnOptions& options) {
    std::vector<Tensor> pictures;
    LayerChoice layers(options.fileLayers);
    std::size_t done = 0;
    for (const fs::path& path : options.pictures) {
        checkInterrupt();
        Image image =
            *loadExemplar(path, {}, layers.of(LayerChoice::kPictures, done++, options.pictures.size())).image;
        for (const int side : options.sides) {
            while (image.size().shorterSide() >= 2 * side)
                image = halved(image);
            pictures.push_back(pictureFor(image, side));
        }
    }
    return pictures;
}

void write(const fs::path& output, const Descriptor& descriptor, bool quiet) {
    const Model model = descriptor.model();
    writeModel(output, model);
    if (!quiet)
        fmt::print("{}: {} weights, taps {}, SHA-1 {}\n", output.string(), grouped(descriptor.parameters()),
                   listOf(descriptor.taps()).text(), model.hash());
}

void checkOutput(const std::vector<fs::path>& read, const fs::path& output, bool overwrite) {
    if (output.extension() != ".safetensors")
        failUsage("--output {}: a descriptor is a file that ends in .safetensors.", output.string());
    checkOnlyOutput(read, output, overwrite);
}

void learn(const LearnOptions& options) {
    checkOutput(options.pictures, options.output, options.overwrite);
    LearningOptions how;
    how.patches = options.patches;
    how.rounds = options.rounds;
    if (!options.layers.empty())
        how.layers = layersFrom(options.layers);
    const std::vector<Tensor> pictures = picturesOf(options);
    Job<Descriptor> job({options.seed, options.threads, false}, [&](JobContext& context) {
        context.stage(1, TR("Learning the descriptor"));
        return learnDescriptor(pictures, how, context);
    });
    Descriptor descriptor = followed(job, options.quiet);
    descriptor.name = options.name;
    descriptor.licence = options.licence;
    descriptor.credit = options.credit;
    write(options.output, descriptor, options.quiet);
}

void importFile(const ImportOptions& options) {
    checkOutput({options.json}, options.output, options.overwrite);
    WeightsImport how = options.how;
    how.pooling = options.pooling == "average" ? Pooling::Average : Pooling::Maximum;
    write(options.output, importWeights(options.json, how), options.quiet);
}

void show(const ShowOptions& options) {
    const Model model = options.file.empty() ? ownDescriptor() : readModel(options.file);
    const Descriptor descriptor = Descriptor::from(model);
    if (options.json) {
        const JsonField::Json json = {
            {"name", descriptor.name},         {"licence", descriptor.licence},
            {"credit", descriptor.credit},     {"sha1", model.hash()},
            {"channels", descriptor.channels}, {"pooling", model.notes.at("pooling")},
            {"levels", descriptor.levels},     {"parameters", descriptor.parameters()},
            {"taps", descriptor.taps()},       {"network", model.notes.at("network")}};
        fmt::print("{}\n", json.dump(2));
        return;
    }
    fmt::print("{}: {} weights, {} channels\n  {}\n  Licence: {}\n  SHA-1: {}\n  Taps: {}\n  {}\n",
               descriptor.name, grouped(descriptor.parameters()), descriptor.channels, descriptor.credit,
               descriptor.licence, model.hash(), listOf(descriptor.taps()).text(), model.notes.at("network"));
}

void addLearn(CLI::App& app) {
    static LearnOptions options;
    CLI::App* command =
        app.add_subcommand("learn-descriptor", "Learn a network that describes textures from pictures");
    command->add_option("picture", options.pictures, "Pictures to learn from")->required();
    addLayers(*command, options.fileLayers);
    command->add_option("-o,--output", options.output, "File to write: .safetensors")->required();
    command->add_option("--name", options.name, "What it is called");
    command->add_option("--licence", options.licence,
                        "Licence of the weights, which follow from the pictures'");
    command->add_option("--credit", options.credit, "Whose pictures it was learned from");
    command->add_option("--layers", options.layers, "Layers as OUTPUTSxSIDE; 48x5,96x3,128x3 if not given")
        ->delimiter(',');
    command
        ->add_option("--sides", options.sides,
                     "Sizes at which each picture is looked at, larger first, in pixels")
        ->delimiter(',')
        ->check(CLI::Range(16, 4096));
    command->add_option("--patches", options.patches, "Patches that each layer is learned from")
        ->check(CLI::Range(100, 1000000));
    command->add_option("--rounds", options.rounds, "Rounds of k-means")->check(CLI::Range(1, 1000));
    command
        ->add_option("--threads", options.threads,
                     "Number of threads; one per core if not given. The result is the same")
        ->check(CLI::Range(1, 1024));
    addSeed(*command, options.seed, "Another seed looks at other patches");
    addMemory(*command);
    addOverwrite(*command, options.overwrite);
    command->add_flag("--quiet", options.quiet, "Print nothing but errors");
    command->callback([] { learn(options); });
}

void addImport(CLI::App& app) {
    static ImportOptions options;
    CLI::App* command = app.add_subcommand(
        "import-descriptor",
        "Make a descriptor of the weights of a network of VGG's kind (docs/descriptors.md)");
    command->add_option("weights", options.json, "The .json that says what is where in the .bin beside it")
        ->required();
    command->add_option("-o,--output", options.output, "File to write: .safetensors")->required();
    command->add_option("--name", options.how.name, "What it is called; the file's name if not given");
    command->add_option("--licence", options.how.licence, "Licence of the weights")->required();
    command->add_option("--credit", options.how.credit, "Who made the network")->required();
    command
        ->add_option("--taps", options.how.taps,
                     "Layers to compare, as relu1_1,relu2_1; the first of each group if not given")
        ->delimiter(',');
    command->add_option("--pooling", options.pooling, "How feature maps are halved")
        ->check(CLI::IsMember({"average", "maximum"}));
    addMemory(*command);
    addOverwrite(*command, options.overwrite);
    command->add_flag("--quiet", options.quiet, "Print nothing but errors");
    command->callback([] { importFile(options); });
}

void addShow(CLI::App& app) {
    static ShowOptions options;
    CLI::App* command =
        app.add_subcommand("descriptor", "Tell of a descriptor: its network, licence and hash");
    command->add_option("file", options.file, "File of the descriptor; Texloom's own if not given");
    command->add_flag("--json", options.json, "As JSON");
    command->callback([] { show(options); });
}

} // namespace

void addDescriptorCommands(CLI::App& app) {
    addShow(app);
    addLearn(app);
    addImport(app);
}

} // namespace texloom::cli

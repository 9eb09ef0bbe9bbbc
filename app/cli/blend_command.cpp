#include "app/cli/blend_command.h"

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/base/error.h"
#include "core/match/blend.h"
#include "core/session/export/export.h"
#include "core/session/run/exemplar_file.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <map>

namespace texloom::cli {

namespace {

namespace fs = std::filesystem;

struct BlendCommand {
    fs::path first, second, output;
    BlendCurve::Shape curve = BlendCurve::Shape::Horizontal;
    double position = 0.5;
    BlendOptions blend;
    bool overwrite = false;
    bool quiet = false;
};

Image blended(const ExemplarFile& first, const ExemplarFile& second, const BlendCommand& command) {
    Job<Image> job({}, [&](JobContext& context) {
        const BlendCurve curve = BlendCurve::at(command.curve, command.position, first.image->size());
        return blend(*first.image, *second.image, curve, command.blend, context);
    });
    return followed(job, command.quiet);
}

void run(const BlendCommand& command) {
    const ExemplarFile first = loadExemplar(command.first);
    checkInterrupt();
    const ExemplarFile second = loadExemplar(command.second);
    checkInterrupt();
    const Size size = first.image->size();
    if (2 * command.blend.band > size.shorterSide())
        failUsage("--band {}: it goes up to half the images' shorter side, {} px.", command.blend.band,
                  size.shorterSide() / 2);
    checkWritable(command.output, first.image->channels(), depthLike(first, command.output));
    checkOnlyOutput({command.first, command.second}, command.output, command.overwrite);
    exportPicture(command.output, blended(first, second, command), first, checkInterrupt);
    if (!command.quiet)
        fmt::print("{}: {} × {} px\n", command.output.string(), size.width, size.height);
}

/// An option whose words stand for the values of an enumeration.
template <class Enum>
void addChoice(CLI::App& command, const std::string& name, Enum& value,
               const std::map<std::string, Enum>& words, const std::string& help) {
    std::vector<std::string> known;
    for (const auto& [word, meaning] : words)
        known.push_back(word);
    command
        .add_option_function<std::string>(
            name, [&value, words](const std::string& word) { value = words.at(word); }, help)
        ->check(CLI::IsMember(known));
}

} // namespace

void addBlend(CLI::App& app) {
    static BlendCommand options;
    CLI::App* command = app.add_subcommand("blend", "Join two images along a curve");
    command->add_option("first", options.first, "Image above, left of or outside the curve")->required();
    command->add_option("second", options.second, "Image of the same size on the other side")->required();
    command->add_option("-o,--output", options.output, "File to write: .png .jpg .tif .exr .hdr")->required();
    addChoice<BlendCurve::Shape>(*command, "--curve", options.curve,
                                 {{"horizontal", BlendCurve::Shape::Horizontal},
                                  {"vertical", BlendCurve::Shape::Vertical},
                                  {"circular", BlendCurve::Shape::Circular}},
                                 "horizontal, vertical or circular, around the bottom right");
    command->add_option("--position", options.position, "Where the curve lies, from 0 (top, left) to 1")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--band", options.blend.band, "Pixels to either side of the curve that may change")
        ->check(CLI::Range(2, 4096));
    addChoice<BlendMethod>(*command, "--method", options.blend.method,
                           {{"cut", BlendMethod::Cut},
                            {"poisson", BlendMethod::Poisson},
                            {"midway", BlendMethod::Midway},
                            {"edge", BlendMethod::Edge}},
                           "cut, poisson, midway or edge, which blends nothing; midway if not given");
    addChoice<Propagation>(*command, "--propagation", options.blend.midway.propagation,
                           {{"linear", Propagation::Linear}, {"progressive", Propagation::Progressive}},
                           "How midway fades out: linear or progressive");
    addChoice<BlendColor>(*command, "--color", options.blend.midway.color,
                          {{"rgb", BlendColor::Rgb}, {"dct", BlendColor::Dct}, {"pca", BlendColor::Pca}},
                          "Colour axes of midway: rgb, dct or pca");
    addMemory(*command);
    addReproducible(*command, false);
    addOverwrite(*command, options.overwrite);
    command->add_flag("--quiet", options.quiet, "Print nothing but errors");
    command->callback([] { run(options); });
}

} // namespace texloom::cli

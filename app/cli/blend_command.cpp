#include "app/cli/blend_command.h"

#include "app/cli/console.h"
#include "core/base/error.h"
#include "core/color/color_pipeline.h"
#include "core/match/blend.h"
#include "core/session/exemplar_file.h"
#include "core/session/export.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace texloom::cli {

namespace {

namespace fs = std::filesystem;

struct BlendCommand {
    fs::path first, second, output;
    std::string curve = "horizontal";
    double position = 0.5;
    BlendOptions blend;
    bool quiet = false;
};

BlendCurve curveFor(const BlendCommand& command, Size size) {
    const auto middle = [&](int length) {
        return std::clamp(static_cast<int>(std::lround(command.position * length)), 0, length - 1);
    };
    if (command.curve == "vertical")
        return BlendCurve::vertical(size, middle(size.width));
    if (command.curve == "circular")
        return BlendCurve::circular(size, std::max(1.0, (1 - command.position) * size.shorterSide()));
    return BlendCurve::horizontal(size, middle(size.height));
}

void run(const BlendCommand& command) {
    const ExemplarFile first = loadExemplar(command.first), second = loadExemplar(command.second);
    const Size size = first.image->size();
    if (2 * command.blend.band > size.shorterSide())
        failUsage("--band {}: it goes up to half the images' shorter side, {} px.", command.blend.band,
                  size.shorterSide() / 2);
    WriteOptions write;
    write.depth = depthLike(first, command.output);
    const bool floating = write.depth == Depth::Half || write.depth == Depth::Float;
    write.space = first.space == "raw" ? "raw" : floating ? "linear" : "srgb";
    write.check = checkInterrupt;
    checkWritable(command.output, first.image->channels(), write.depth);
    for (const fs::path& source : {command.first, command.second}) {
        std::error_code error;
        if (fs::weakly_canonical(source, error) == fs::weakly_canonical(command.output, error))
            failUsage("-o {}: it is one of the images, which would be lost; name another file.",
                      command.output.string());
    }
    Image result = blend(*first.image, *second.image, curveFor(command, size), command.blend);
    checkInterrupt();
    if (write.space == "linear")
        color::fromWorking(result, write.space);
    writeImage(command.output, result, write);
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
    command->add_option("--curve", options.curve, "horizontal, vertical or circular, around the bottom right")
        ->check(CLI::IsMember({"horizontal", "vertical", "circular"}));
    command->add_option("--position", options.position, "Where the curve lies, from 0 (top, left) to 1")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--band", options.blend.band, "Pixels to either side of the curve that may change")
        ->check(CLI::Range(2, 4096));
    addChoice<BlendMethod>(
        *command, "--method", options.blend.method,
        {{"cut", BlendMethod::Cut}, {"poisson", BlendMethod::Poisson}, {"midway", BlendMethod::Midway}},
        "cut, poisson or midway; midway if not given");
    addChoice<Propagation>(*command, "--propagation", options.blend.midway.propagation,
                           {{"linear", Propagation::Linear}, {"progressive", Propagation::Progressive}},
                           "How midway fades out: linear or progressive");
    addChoice<BlendColor>(*command, "--color", options.blend.midway.color,
                          {{"rgb", BlendColor::Rgb}, {"dct", BlendColor::Dct}, {"pca", BlendColor::Pca}},
                          "Colour axes of midway: rgb, dct or pca");
    command->add_flag("--quiet", options.quiet, "Print nothing but errors");
    command->callback([] { run(options); });
}

} // namespace texloom::cli

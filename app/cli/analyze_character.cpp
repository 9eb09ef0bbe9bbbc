#include "app/cli/analyze_character.h"

#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/advice.h"
#include "core/session/run/exemplar_file.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace texloom::cli {

namespace {

constexpr std::size_t kShown = 6;

struct CharacterOptions {
    std::filesystem::path image;
    std::vector<std::string> layers; ///< as LayerChoice takes them
    bool json = false;
};

void print(const ExemplarFile& file, const TextureCharacter& character, const MethodAdvice& advice) {
    fmt::print("{}: {}\n", file.name(), advice.reason);
    fmt::print("  regularity {:.0f} %, like a Gaussian field {:.0f} %, alike up to {:.0f} to {:.0f} px\n",
               100 * character.regularity, 100 * character.grain, character.shortest, character.longest);
    for (std::size_t i = 0; i < std::min(kShown, advice.methods.size()); ++i)
        fmt::print("{}. {}: {}\n", i + 1, advice.methods[i]->id(), advice.methods[i]->info().summary);
}

void printJson(const ExemplarFile& file, const TextureCharacter& character, const MethodAdvice& advice) {
    const auto rounded = [](double value) { return std::round(1000 * value) / 1000; };
    const KindShares kinds = kindsOf(character);
    nlohmann::ordered_json json = {{"exemplar", file.name()},
                                   {"size", {character.size.width, character.size.height}},
                                   {"regularity", rounded(character.regularity)},
                                   {"rowsOnly", character.rowsOnly},
                                   {"period", rounded(character.period)},
                                   {"alikeFrom", rounded(character.shortest)},
                                   {"alikeTo", rounded(character.longest)},
                                   {"grain", rounded(character.grain)},
                                   {"kinds",
                                    {{"regular", rounded(kinds.regular)},
                                     {"grain", rounded(kinds.grain)},
                                     {"objects", rounded(kinds.objects)},
                                     {"large", rounded(kinds.large)}}},
                                   {"reason", advice.reason.text()},
                                   {"methods", nlohmann::ordered_json::array()}};
    for (const Method* method : advice.methods)
        json["methods"].push_back(method->id());
    fmt::print("{}\n", json.dump(2));
}

void run(const CharacterOptions& options) {
    LayerChoice layers(options.layers);
    const ExemplarFile file = loadExemplar(options.image, {}, layers.of(LayerChoice::kPictures));
    layers.checkUsed();
    checkEnoughMemory(file.name(), file.image->size(),
                      characterBytesFor(file.image->size(), file.image->channels()));
    const TextureCharacter character = characterOf(*file.image, checkInterrupt);
    const MethodAdvice advice = adviceFor(character);
    if (options.json)
        printJson(file, character, advice);
    else
        print(file, character, advice);
}

} // namespace

void addAnalyzeCharacter(CLI::App& analyze) {
    static CharacterOptions options;
    CLI::App* command =
        analyze.add_subcommand("methods", "What a texture is like, and which methods to try first");
    command->add_option("image", options.image, "Image to look at")->required();
    addLayers(*command, options.layers);
    addMemory(*command);
    command->add_flag("--json", options.json, "As JSON");
    command->callback([] { run(options); });
}

} // namespace texloom::cli

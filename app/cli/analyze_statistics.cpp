#include "app/cli/analyze_statistics.h"

#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "app/cli/option_forms.h"
#include "core/analysis/patch_variance.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/session/run/exemplar_file.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace texloom::cli {

namespace {

struct StatisticsOptions {
    std::filesystem::path image;
    std::vector<std::string> layers; ///< as LayerChoice takes them
    std::vector<int> sizes = {10, 20, 40, 80};
    std::vector<int> neighbours = {5, 10, 30, 50, 500, 1000};
    int patches = 16;
    std::uint64_t seed = 0;
    bool json = false;
};

void print(const PatchVariance& variance) {
    fmt::print("Mean standard deviation of the m patches most like one, by patch size n\n{:>8}", "n \\ m");
    for (const int m : variance.neighbours)
        fmt::print("{:>10}", m);
    for (std::size_t i = 0; i < variance.sizes.size(); ++i) {
        fmt::print("\n{:>8}", variance.sizes[i]);
        for (const double deviation : variance.deviations[i])
            fmt::print("{:>10}", deviation < 0 ? "–" : fmt::format("{:.4f}", deviation));
    }
    fmt::print("\n");
}

void printJson(const PatchVariance& variance) {
    nlohmann::ordered_json json = {{"patchSizes", variance.sizes}, {"neighbours", variance.neighbours}};
    for (const std::vector<double>& row : variance.deviations) {
        auto& values = json["meanDeviation"].emplace_back(nlohmann::ordered_json::array());
        for (const double deviation : row)
            values.push_back(deviation < 0 ? nlohmann::ordered_json(nullptr)
                                           : nlohmann::ordered_json(deviation));
    }
    fmt::print("{}\n", json.dump(2));
}

void run(const StatisticsOptions& options) {
    LayerChoice layers(options.layers);
    const ExemplarFile file = loadExemplar(options.image, {}, layers.of(LayerChoice::kPictures));
    layers.checkUsed();
    const int smallest = *std::min_element(options.sizes.begin(), options.sizes.end());
    if (smallest > file.image->size().shorterSide())
        failUsage("--patch {}: {} is {} × {} px; choose a patch of at most {} px.", smallest, file.name(),
                  file.image->width(), file.image->height(), file.image->size().shorterSide());
    checkEnoughMemory(file.name(), file.image->size(),
                      patchVarianceBytesFor(file.image->size(), file.image->channels(), options.sizes));
    Job<PatchVariance> job({options.seed, 0, false}, [&](JobContext& context) {
        context.stage(1, TR("Comparing patches"));
        return patchVariance(*file.image, options.sizes, options.neighbours, options.patches, context);
    });
    follow(job, options.json);
    Outcome<PatchVariance> outcome = job.take();
    if (std::holds_alternative<Cancelled>(outcome))
        throw Cancelled{};
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    if (options.json)
        printJson(std::get<PatchVariance>(outcome));
    else
        print(std::get<PatchVariance>(outcome));
}

} // namespace

void addAnalyzeStatistics(CLI::App& analyze) {
    static StatisticsOptions options;
    CLI::App* command =
        analyze.add_subcommand("statistics", "How much similar patches vary, by their size and number");
    command->add_option("image", options.image, "Image to look at")->required();
    addLayers(*command, options.layers);
    command->add_option("--patch", options.sizes, "Patch sizes in pixels, as 10,20,40")
        ->delimiter(',')
        ->check(CLI::Range(2, 512));
    command->add_option("--neighbours", options.neighbours, "Numbers of similar patches, as 5,10,30")
        ->delimiter(',')
        ->check(CLI::Range(2, 100000));
    command->add_option("--patches", options.patches, "Patches to look at")->check(CLI::Range(1, 10000));
    addSeed(*command, options.seed, "Another seed looks at other patches");
    addMemory(*command);
    command->add_flag("--json", options.json, "As JSON");
    command->callback([] { run(options); });
}

} // namespace texloom::cli

#include "app/cli/analyze_quality.h"

#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "core/analysis/estimated_map.h"
#include "core/analysis/map_pictures.h"
#include "core/analysis/map_usage.h"
#include "core/analysis/seam.h"
#include "core/base/error.h"
#include "core/io/json_field.h"
#include "core/io/map_file.h"
#include "core/session/run/run.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texloom::cli {

namespace {

struct QualityOptions {
    std::filesystem::path result;
    std::vector<std::string> layers; ///< as LayerChoice takes them
    std::vector<std::filesystem::path> exemplars;
    std::filesystem::path map; ///< or empty
    bool json = false;
};

void append(std::vector<Figure>& figures, const std::vector<Figure>& more) {
    figures.insert(figures.end(), more.begin(), more.end());
}

/// Distances, and the innovation by an estimated map, which is made alike for every texture: those of methods
/// that copy and of those that do not can be compared by it. @param map that was given, or null.
std::vector<Figure> compared(const ImageView& result, const std::vector<ExemplarFile>& exemplars,
                             const PositionMap* map, JobContext& context) {
    std::vector<ImageView> images;
    std::vector<PatchSource> sources;
    for (const ExemplarFile& exemplar : exemplars) {
        images.push_back(*exemplar.image);
        sources.push_back({*exemplar.image, {}});
    }
    const auto check = [&context] { context.check(); };
    std::vector<Figure> figures = distanceFigures(textureDistance(result, images, context));
    append(figures, layoutFigures(result, images, exemplars.front().image, check));
    const PositionMap estimated = estimatedMap(result, sources, {}, context);
    figures.push_back({"Innovation, estimated", innovation(estimated, check)});
    append(figures, pieceFigures(result, images, map ? *map : estimated,
                                 occurrencesOf(map ? *map : estimated, check), check));
    return figures;
}

std::vector<Figure> measured(const ExemplarFile& result, const std::vector<ExemplarFile>& exemplars,
                             const PositionMap* map) {
    Job<std::vector<Figure>> job(
        {}, [&](JobContext& context) { return compared(*result.image, exemplars, map, context); });
    follow(job, true);
    Outcome<std::vector<Figure>> outcome = job.take();
    if (std::holds_alternative<Cancelled>(outcome))
        throw Cancelled{};
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    std::vector<Figure> figures = std::get<std::vector<Figure>>(std::move(outcome));
    const SeamScore seam = seamScore(*result.image, checkInterrupt);
    figures.push_back({"Seam, left to right", seam.x});
    figures.push_back({"Seam, top to bottom", seam.y});
    return figures;
}

/// The map that was given, if one was. @throws UsageError if it is not the result's.
std::optional<PositionMap> givenMap(const QualityOptions& options, const ExemplarFile& result,
                                    const std::vector<ExemplarFile>& exemplars,
                                    const std::string& layerOfMap) {
    if (options.map.empty())
        return {};
    std::vector<Size> sizes;
    for (const ExemplarFile& exemplar : exemplars)
        sizes.push_back(exemplar.image->size());
    PositionMap map = readPositionMap(options.map, sizes, layerOfMap);
    checkMapOf(map, result);
    return map;
}

void analyzeQuality(const QualityOptions& options) {
    LayerChoice layers(options.layers);
    const ExemplarFile result = loadExemplar(options.result, {}, layers.of("result"));
    const std::string layerOfMap = options.map.empty() ? std::string() : layers.of("map");
    std::vector<ExemplarFile> exemplars;
    for (const std::filesystem::path& path : options.exemplars)
        checkSameChannels(
            result,
            exemplars.emplace_back(loadExemplar(
                path, {}, layers.of(LayerChoice::kPictures, exemplars.size(), options.exemplars.size()))));
    layers.checkUsed();
    checkMemoryForMaps(result, exemplars);
    const std::optional<PositionMap> map = givenMap(options, result, exemplars, layerOfMap);
    std::vector<Figure> figures = measured(result, exemplars, map ? &*map : nullptr);
    if (map)
        append(figures,
               mapFigures(*map, MapKind::Exact, occurrencesOf(*map, checkInterrupt), checkInterrupt));
    printFigures(figures, options.json);
}

} // namespace

void checkMemoryForMaps(const ExemplarFile& result, const std::vector<ExemplarFile>& exemplars) {
    std::vector<Size> sizes;
    std::uint64_t occurrences = 0;
    for (const ExemplarFile& exemplar : exemplars) {
        sizes.push_back(exemplar.image->size());
        occurrences += Image::bytesFor(sizes.back(), 1);
    }
    const Size size = result.image->size();
    checkEnoughMemory(result.name(), size,
                      occurrences + PositionMap::bytesFor(size) +
                          estimatedMapBytes(size, sizes, result.image->channels()));
}

void printFigures(const std::vector<Figure>& figures, bool asJson) {
    if (asJson) {
        JsonField::Json json;
        for (const Figure& figure : figures)
            json[figure.name.text()] = figure.value;
        fmt::print("{}\n", json.dump(2));
        return;
    }
    for (const Figure& figure : figures)
        fmt::print("{:50} {:8.4f}\n", figure.name.text(), figure.value);
}

void checkSameChannels(const ExemplarFile& result, const ExemplarFile& exemplar) {
    if (exemplar.image->channels() != result.image->channels())
        failUsage("{} has {} channels and {} has {}; compare images with the same number.", result.name(),
                  result.image->channels(), exemplar.name(), exemplar.image->channels());
}

void checkMapOf(const PositionMap& map, const ExemplarFile& result) {
    if (map.size() != result.image->size())
        failUsage("The map is {} × {} px and {} {} × {} px; give the map that belongs to it.", map.width(),
                  map.height(), result.name(), result.image->width(), result.image->height());
}

void addAnalyzeQuality(CLI::App& analyze) {
    static QualityOptions options;
    CLI::App* command = analyze.add_subcommand("quality", "How closely a texture resembles its exemplars");
    command->add_option("result", options.result, "The texture")->required();
    command->add_option("exemplar", options.exemplars, "Images that it was made from")->required();
    addLayers(*command, options.layers, "the result and the map");
    command->add_option("--map", options.map, "Its position map, for figures on what was copied");
    addMemory(*command);
    command->add_flag("--json", options.json, "As JSON");
    command->callback([] { analyzeQuality(options); });
}

} // namespace texloom::cli

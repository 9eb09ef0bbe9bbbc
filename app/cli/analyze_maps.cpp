#include "app/cli/analyze_maps.h"

#include "app/cli/analyze_quality.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "core/analysis/estimated_map.h"
#include "core/analysis/map_pictures.h"
#include "core/analysis/map_usage.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "core/session/run/run.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace texloom::cli {

namespace {

struct MapsOptions {
    std::filesystem::path result;
    std::vector<std::string> layers; ///< as LayerChoice takes them
    std::vector<std::filesystem::path> exemplars;
    std::filesystem::path map;    ///< or empty, to estimate one
    std::filesystem::path folder; ///< for pictures, or empty
    int neighbourhood = kEstimatedMapPatch;
    bool overwrite = false, json = false;
};

/// A picture of the maps, and the file that it is written to.
using MapPicture = std::pair<std::filesystem::path, Image>;

std::filesystem::path pictureFile(const MapsOptions& options, const std::filesystem::path& of,
                                  std::size_t number, const char* what) {
    const std::string place = number > 0 ? fmt::format("{}_", number) : "";
    return options.folder / fmt::format("{}_{}{}.png", of.stem().string(), place, what);
}

std::vector<std::filesystem::path> pictureFiles(const MapsOptions& options) {
    std::vector<std::filesystem::path> files = {pictureFile(options, options.result, 0, "synthesis"),
                                                pictureFile(options, options.result, 0, "copied")};
    for (std::size_t e = 0; e < options.exemplars.size(); ++e)
        files.push_back(pictureFile(options, options.exemplars[e], options.exemplars.size() > 1 ? e + 1 : 0,
                                    "positions"));
    return files;
}

void checkPictures(const MapsOptions& options) {
    std::vector<std::filesystem::path> read = options.exemplars;
    read.push_back(options.result);
    if (!options.map.empty())
        read.push_back(options.map);
    for (const std::filesystem::path& file : pictureFiles(options)) {
        checkWritable(file, 3, Depth::Bits8);
        checkOnlyOutput(read, file, options.overwrite);
    }
}

/// Raad & Galerne, IPOL 2017, figure 5: where each pixel comes from, what was copied in one piece, and the
/// colours that places of the exemplars have in the former.
void writePictures(const MapsOptions& options, const PositionMap& map) {
    std::vector<Image> pictures = {synthesisPicture(map), copiedRegionsPicture(map)};
    const std::vector<Size>& sizes = map.exemplarSizes();
    for (std::size_t e = 0; e < sizes.size(); ++e)
        pictures.push_back(positionPicture(sizes[e], static_cast<int>(e), static_cast<int>(sizes.size())));
    const std::vector<std::filesystem::path> files = pictureFiles(options);
    for (std::size_t i = 0; i < files.size(); ++i)
        writeImage(files[i], pictures[i], {});
}

PositionMap mapOf(const MapsOptions& options, const ExemplarFile& result,
                  const std::vector<ExemplarFile>& exemplars, const std::string& layerOfMap) {
    std::vector<Size> sizes;
    std::vector<PatchSource> sources;
    for (const ExemplarFile& exemplar : exemplars) {
        sizes.push_back(exemplar.image->size());
        sources.push_back({*exemplar.image, {}});
    }
    if (!options.map.empty())
        return readPositionMap(options.map, sizes, layerOfMap);
    Job<PositionMap> job({}, [&](JobContext& context) {
        context.stage(1, TR("Estimating the synthesis map"));
        return estimatedMap(*result.image, sources, {}, context, options.neighbourhood);
    });
    return followed(job, options.json);
}

void analyzeMaps(const MapsOptions& options) {
    if (!options.folder.empty()) {
        std::filesystem::create_directories(options.folder);
        checkPictures(options);
    }
    LayerChoice layers(options.layers);
    const ExemplarFile result = loadExemplar(options.result, {}, layers.of("result"));
    const std::string layerOfMap = options.map.empty() ? std::string() : layers.of("map");
    std::vector<ExemplarFile> exemplars;
    std::vector<ImageView> views;
    for (const std::filesystem::path& path : options.exemplars) {
        views.push_back(
            *exemplars
                 .emplace_back(loadExemplar(
                     path, {}, layers.of(LayerChoice::kPictures, exemplars.size(), options.exemplars.size())))
                 .image);
        checkSameChannels(result, exemplars.back());
    }
    layers.checkUsed();
    checkMemoryForMaps(result, exemplars);
    const PositionMap map = mapOf(options, result, exemplars, layerOfMap);
    checkMapOf(map, result);
    const std::vector<Image> occurrences = occurrencesOf(map, checkInterrupt);
    const MapKind kind = options.map.empty() ? MapKind::Estimated : MapKind::Exact;
    std::vector<Figure> figures = mapFigures(map, kind, occurrences, checkInterrupt);
    const std::vector<Figure> pieces = pieceFigures(*result.image, views, map, occurrences, checkInterrupt);
    figures.insert(figures.end(), pieces.begin(), pieces.end());
    if (!options.folder.empty())
        writePictures(options, map);
    printFigures(figures, options.json);
}

} // namespace

void addAnalyzeMaps(CLI::App& analyze) {
    static MapsOptions options;
    constexpr int kSmallest = 4, kLargest = 7;
    CLI::App* command = analyze.add_subcommand(
        "maps", "Where a texture's pixels come from; another texture may take the exemplar's place");
    command->add_option("result", options.result, "The texture")->required();
    command->add_option("exemplar", options.exemplars, "Images, or another result, to look for it in")
        ->required();
    addLayers(*command, options.layers, "the result and the map");
    command->add_option("--map", options.map, "Its position map; estimated if not given");
    command
        ->add_option("--neighbourhood", options.neighbourhood,
                     "Side in pixels of what is compared to estimate the map")
        ->check(CLI::Range(kSmallest, kLargest));
    command->add_option(
        "--picture", options.folder,
        "Folder for three pictures: where pixels come from, what was copied in one piece, and "
        "the exemplar's places in the same colours");
    addMemory(*command);
    addReproducible(*command, false);
    addOverwrite(*command, options.overwrite);
    command->add_flag("--json", options.json, "As JSON");
    command->callback([] { analyzeMaps(options); });
}

} // namespace texloom::cli

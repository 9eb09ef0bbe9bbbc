#include "core/session/export/output_files.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/stmap.h"
#include "core/io/model_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// Of a volume without end: a cube of the longest side that is kept.
constexpr std::int64_t kMostVoxels = 1 << 27;

fs::path numbered(const fs::path& path, std::size_t index) {
    if (index == 0)
        return path;
    return path.parent_path() /
           fmt::format("{}-{}{}", path.stem().string(), index + 1, path.extension().string());
}

/// The first of a result's outputs of one id that can go into a port.
std::optional<Asset> outputFor(const Result& result, const std::string& id, const Port& port) {
    const Port* const output = outputPort(result.plan, id);
    if (output == nullptr || output->kind != port.kind)
        return std::nullopt;
    for (const Asset& asset : result.synthesis.outputs.at(id)) {
        const auto* model = std::get_if<std::shared_ptr<const Model>>(&asset);
        if (!model || (*model)->kind == port.id)
            return asset;
    }
    return std::nullopt;
}

} // namespace

Message OutputFile::content() const {
    return message("{}, {}", Message(port->title), sizeText(*asset));
}

const Port* outputPort(const RunPlan& plan, std::string_view id) {
    for (auto step = plan.steps.rbegin(); step != plan.steps.rend(); ++step)
        if (const Port* port = step->method->info().output(id))
            return port;
    return nullptr;
}

std::string usualExtension(const Port& port) {
    return port.id == kStMapPort ? ".exr" : usualExtension(port.kind);
}

void checkOutput(const RunPlan& plan, const std::string& id, const fs::path& file) {
    const Port* const port = outputPort(plan, id);
    std::vector<std::string> ids;
    for (const RunStep& step : plan.steps)
        for (const Port& given : step.method->info().gives)
            if (given.id != kImagePort && given.id != kMapPort)
                ids.push_back(given.id);
    if (port == nullptr || std::find(ids.begin(), ids.end(), id) == ids.end())
        throw UsageError(ids.empty() ? message("{} gives no output {}; it gives nothing beside its picture "
                                               "and map.",
                                               Message(plan.lastMethod().info().title), id)
                                     : message("{} gives no output {}; there are {}.",
                                               Message(plan.lastMethod().info().title), id, listOf(ids)));
    checkAssetFile(port->kind, file);
    if (id == kStMapPort && file.extension() != ".exr")
        failUsage("{} cannot hold an STMap, which needs 32-bit floats; its name ends in .exr.",
                  file.string());
}

std::vector<OutputFile> outputFiles(const Result& result, const std::map<std::string, fs::path>& wanted) {
    std::vector<OutputFile> outputs;
    for (const auto& [id, path] : wanted) {
        const std::vector<Asset>& assets = result.synthesis.outputs.at(id);
        const Port* const port = outputPort(result.plan, id);
        if (port == nullptr || assets.empty())
            failUsage("The result has no output {}.", id);
        for (std::size_t i = 0; i < assets.size(); ++i)
            outputs.push_back({port, &assets[i], numbered(path, i)});
    }
    return outputs;
}

std::optional<Asset> assetFor(const std::shared_ptr<const Result>& result, const Port& port) {
    const Synthesis& made = result->synthesis;
    if (port.kind == AssetKind::Image && !made.image.empty())
        return std::shared_ptr<const Image>(result, &made.image);
    if (port.kind == AssetKind::Map && made.mapKind != MapKind::None && !made.map.size().empty())
        return std::shared_ptr<const PositionMap>(result, &made.map);
    if (std::optional<Asset> own = outputFor(*result, port.id, port))
        return own;
    for (const auto& [id, assets] : made.outputs.byPort())
        if (std::optional<Asset> other = outputFor(*result, id, port))
            return other;
    return std::nullopt;
}

AssetWriteOptions outputOptions(const Result& result, const OutputFile& output, Depth depth) {
    AssetWriteOptions write;
    const std::vector<RecipeExemplar>& exemplars = result.plan.recipe.exemplars;
    const bool stmap = output.port->id == kStMapPort;
    const bool data = output.port->kind == AssetKind::Mask || stmap || result.plan.recipe.space() == "raw";
    write.space = data ? "raw" : "srgb";
    write.depth = stmap ? Depth::Float : depth;
    write.size = result.synthesis.image.size();
    write.mostVoxels = kMostVoxels;
    write.recipe = result.plan.recipe.toJson(output.path.has_parent_path() ? output.path.parent_path() : ".");
    for (const RecipeExemplar& exemplar : exemplars)
        write.exemplarHashes.push_back(exemplar.image.hash);
    return write;
}

std::string outputsReport(const Result& result) {
    Json json = Json::array();
    for (const auto& [id, assets] : result.synthesis.outputs.byPort())
        for (const Asset& asset : assets) {
            Json output = {{"output", id}, {"kind", kindId(kindOf(asset))}, {"size", sizeText(asset).text()}};
            if (const auto* model = std::get_if<std::shared_ptr<const Model>>(&asset))
                output["sha1"] = (*model)->hash();
            json.push_back(std::move(output));
        }
    return json.dump();
}

} // namespace texloom

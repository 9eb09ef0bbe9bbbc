#include "core/session/run/input_file.h"

#include "core/base/error.h"
#include "core/io/map_file.h"
#include "core/io/model_file.h"
#include "core/session/run/asset_file.h"

namespace texloom {

namespace {

/// What a port takes is one kind of model, and its id says which.
void checkModel(const Port& port, const std::filesystem::path& path, const Model& model) {
    if (model.kind != port.id)
        failUsage("{} is a model of the kind {}; the input {} takes one of its own kind.", path.string(),
                  model.kind, port.id);
}

Asset loadedAsset(const Port& port, const RecipeFile& file, const std::vector<Size>& exemplars) {
    const std::filesystem::path& path = file.path;
    if (port.kind == AssetKind::Map)
        return std::make_shared<const PositionMap>(readPositionMap(path, exemplars, file.layer));
    if (!file.layer.empty())
        failUsage("{} goes into {}, which takes no picture, so it has no layer {}.", path.filename().string(),
                  Message(port.title), file.layer);
    Asset asset = readAsset(port.kind, path);
    if (const auto* model = std::get_if<std::shared_ptr<const Model>>(&asset))
        checkModel(port, path, **model);
    return asset;
}

} // namespace

InputFile loadInput(const Port& port, const RecipeFile& file, const std::vector<Size>& exemplars) {
    switch (port.kind) {
    case AssetKind::Image:
        return file.space == "raw" ? loadData(file.path, file.layer)
                                   : loadExemplar(file.path, file.space, file.layer);
    case AssetKind::Mask:
        return loadMask(file.path, file.layer);
    case AssetKind::Map:
    case AssetKind::Model:
    case AssetKind::Volume:
    case AssetKind::Mesh:
        break;
    }
    InputFile input;
    input.file.path = file.path;
    input.file.layer = file.layer;
    input.asset = loadedAsset(port, file, exemplars);
    input.file.hash = assetHash(port.kind, file.path);
    return input;
}

const ExemplarFile* pictureOf(const InputFiles& inputs, std::string_view port) {
    const auto found = inputs.find(port);
    return found == inputs.end() || found->second.empty() || !found->second.front().image()
               ? nullptr
               : &found->second.front().file;
}

} // namespace texloom

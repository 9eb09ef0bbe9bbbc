#include "core/session/run/input_file.h"

#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/io/map_file.h"

namespace texloom {

namespace {

InputFile loadedMap(const RecipeFile& file, const std::vector<Size>& exemplars) {
    InputFile input;
    input.file.path = file.path;
    input.file.hash = fileHash(file.path);
    input.asset = std::make_shared<const PositionMap>(readPositionMap(file.path, exemplars));
    return input;
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
        return loadedMap(file, exemplars);
    case AssetKind::Model:
    case AssetKind::Volume:
    case AssetKind::Mesh:
        break;
    }
    failUsage("The input {} takes {}; no file of that kind can be read yet.", port.id, kindText(port.kind));
}

const ExemplarFile* pictureOf(const InputFiles& inputs, std::string_view port) {
    const auto found = inputs.find(port);
    return found == inputs.end() || found->second.empty() || !found->second.front().image()
               ? nullptr
               : &found->second.front().file;
}

} // namespace texloom

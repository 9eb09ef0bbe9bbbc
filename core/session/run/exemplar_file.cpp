#include "core/session/run/exemplar_file.h"

#include "core/color/color_pipeline.h"
#include "core/image/hidden_colour.h"
#include "core/io/channel_names.h"

#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// A file without its pixels, which are given apart, to be worked on.
std::pair<ExemplarFile, Image> load(const fs::path& path, const std::string& space,
                                    const std::string& layer) {
    LoadedImage loaded = readImage(path, {kLargestFilePixels, layer, space == "raw"});
    const bool asTheFileSays = space.empty() || space == color::kFileSpace;
    ExemplarFile file{path, asTheFileSays ? loaded.info.space : space, fileHash(path), loaded.info, nullptr};
    file.role = mapNameFrom(file.name()).role;
    file.layer = layer;
    if (file.space != "raw")
        for (const AlphaGroup& group : alphaGroups(loaded.info.channelNames))
            fillHidden(loaded.image, group.alpha, group.colours);
    return {std::move(file), std::move(loaded.image)};
}

ExemplarFile whole(std::pair<ExemplarFile, Image> loaded) {
    loaded.first.image = std::make_shared<const Image>(std::move(loaded.second));
    return std::move(loaded.first);
}

} // namespace

ExemplarFile loadExemplar(const fs::path& path, const std::string& space, const std::string& layer) {
    std::pair<ExemplarFile, Image> loaded = load(path, space, layer);
    if (loaded.first.space == color::kFileSpace)
        color::toWorking(loaded.second, *loaded.first.info.color);
    else
        color::toWorking(loaded.second, loaded.first.space);
    return whole(std::move(loaded));
}

ExemplarFile loadData(const fs::path& path, const std::string& layer) {
    return whole(load(path, "raw", layer));
}

ExemplarFile loadUnconverted(const fs::path& path) {
    const MapRole role = mapNameFrom(path.stem().string()).role;
    if (role != MapRole::Other && role != MapRole::Color)
        return loadData(path);
    std::pair<ExemplarFile, Image> loaded = load(path, {}, {});
    if (loaded.first.space == color::kFileSpace) { // whose tags are not written
        color::toWorking(loaded.second, *loaded.first.info.color);
        loaded.first.space = "srgb"; // the working space
    }
    return whole(std::move(loaded));
}

ExemplarFile loadMask(const fs::path& path, const std::string& layer) {
    ExemplarFile file = loadData(path, layer);
    if (file.image->channels() > 1) {
        ImageView first = *file.image;
        first.channels = 1;
        file.image = std::make_shared<const Image>(first);
    }
    return file;
}

} // namespace texloom

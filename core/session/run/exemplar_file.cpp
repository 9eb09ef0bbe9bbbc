#include "core/session/run/exemplar_file.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/image/channel_text.h"
#include "core/image/hidden_colour.h"
#include "core/io/channel_names.h"
#include "core/io/decoder_process.h"

#include <algorithm>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// What a picture hardly shows, data do: edges ring, and blocks and bands come into what is smooth.
void noteLoss(ImageFileInfo& info) {
    const auto begins = [&](const char* name) { return info.compression.starts_with(name); };
    const bool half = info.depth == "half";
    const bool lossy = info.format == "jpeg" || begins("jpeg") || begins("dwa") || (half && begins("b44")) ||
                       (!half && begins("pxr24"));
    if (lossy)
        info.notes.push_back(
            message("{} holds data, but is compressed with loss ({}), which changes them; save "
                    "such maps as PNG, or as EXR or TIFF with zip.",
                    info.name, Message::verbatim(info.format == "jpeg" ? "JPEG" : info.compression)));
}

/// A file without its pixels, which are given apart, to be worked on.
std::pair<ExemplarFile, Image> load(const fs::path& path, const std::string& space,
                                    const std::string& layer) {
    LoadedImage loaded = readImage(path, {kLargestFilePixels, layer, space == "raw"});
    const bool asTheFileSays = space.empty() || space == color::kFileSpace;
    ExemplarFile file{path, asTheFileSays ? loaded.info.space : space, fileHash(path), loaded.info, nullptr};
    file.role = mapNameFrom(file.name()).role;
    file.layer = layer;
    if (space == "raw")
        noteLoss(file.info);
    if (file.space != "raw")
        for (const AlphaGroup& group : alphaGroups(loaded.info.channelNames))
            fillHidden(loaded.image, group.alpha, group.colours, DecoderProcess::check);
    return {std::move(file), std::move(loaded.image)};
}

ExemplarFile whole(std::pair<ExemplarFile, Image> loaded) {
    loaded.first.image = std::make_shared<const Image>(std::move(loaded.second));
    return std::move(loaded.first);
}

/// One channel of an image as a map of its own.
Image channelAlone(const Image& image, const MapChannel& channel) {
    Image alone(image.size(), 1);
    for (int y = 0; y < alone.height(); ++y) {
        DecoderProcess::check();
        const float* from = image.plane(channel.index).row(y);
        std::transform(from, from + alone.width(), alone.plane(0).row(y),
                       [&](float value) { return channel.inverted ? 1 - value : value; });
    }
    return alone;
}

} // namespace

ExemplarFile loadExemplar(const fs::path& path, const std::string& space, const std::string& layer) {
    std::pair<ExemplarFile, Image> loaded = load(path, space, layer);
    if (loaded.first.space == color::kFileSpace)
        color::toWorking(loaded.second, *loaded.first.info.color, DecoderProcess::check);
    else
        color::toWorking(loaded.second, loaded.first.space, DecoderProcess::check);
    return whole(std::move(loaded));
}

ExemplarFile loadData(const fs::path& path, const std::string& layer, const MapChannel& channel) {
    std::pair<ExemplarFile, Image> loaded = load(path, "raw", layer);
    if (channel.whole())
        return whole(std::move(loaded));
    if (channel.index >= loaded.second.channels())
        failUsage("{} has {}; there is no channel {}.", path.filename().string(),
                  channelText(loaded.second.channels()), channel.index + 1);
    loaded.first.channel = channel;
    loaded.second = channelAlone(loaded.second, channel);
    return whole(std::move(loaded));
}

MapName companionName(const fs::path& path, const std::string& layer) {
    const MapName ofLayer = mapNameFrom(layer, true);
    return ofLayer.isCompanion() ? ofLayer : mapNameFrom(path.stem().string(), true);
}

std::vector<ExemplarFile> loadCompanions(const fs::path& path, const std::string& layer) {
    const MapName name = companionName(path, layer);
    std::pair<ExemplarFile, Image> loaded = load(path, "raw", layer);
    loaded.first.role = name.role;
    std::vector<ExemplarFile> maps;
    for (int i = 0; i < loaded.second.channels() && i < static_cast<int>(name.packing.size()); ++i) {
        const PackedChannel& packed = name.packing[static_cast<std::size_t>(i)];
        if (packed.role == MapRole::Other)
            continue;
        ExemplarFile map = loaded.first;
        map.role = packed.role;
        map.channel = {i, packed.inverted};
        map.image = std::make_shared<const Image>(channelAlone(loaded.second, map.channel));
        maps.push_back(std::move(map));
    }
    if (maps.empty())
        maps.push_back(whole(std::move(loaded)));
    return maps;
}

ExemplarFile loadUnconverted(const fs::path& path, const std::string& layer) {
    const MapRole role = mapNameFrom(path.stem().string()).role;
    if (role != MapRole::Other && role != MapRole::Color)
        return loadData(path, layer);
    std::pair<ExemplarFile, Image> loaded = load(path, {}, layer);
    if (loaded.first.space == color::kFileSpace) { // whose tags are not written
        color::toWorking(loaded.second, *loaded.first.info.color, DecoderProcess::check);
        loaded.first.space = "srgb"; // the working space
    }
    return whole(std::move(loaded));
}

ExemplarFile loadMask(const fs::path& path, const std::string& layer) {
    ExemplarFile file = loadData(path, layer);
    if (file.image->channels() > 1)
        file.image = std::make_shared<const Image>(channelAlone(*file.image, {0, false}));
    return file;
}

} // namespace texloom

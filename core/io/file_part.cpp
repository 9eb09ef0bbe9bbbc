#include "core/io/file_part.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/channel_names.h"

#include <algorithm>

namespace texloom {

namespace {

/// More pages are not looked at.
constexpr int kMostParts = 256;

std::string partName(const OIIO::ImageSpec& spec, int index) {
    const std::string name =
        spec.get_string_attribute("oiio:subimagename", spec.get_string_attribute("name"));
    return name.empty() ? std::to_string(index + 1) : name;
}

/// The runs of channels with the same layer.
std::vector<FilePart> layersOf(const OIIO::ImageSpec& spec, int index) {
    std::vector<FilePart> layers;
    for (int c = 0; c < spec.nchannels; ++c) {
        const std::string layer = layerOf(spec.channelnames[static_cast<std::size_t>(c)]);
        if (layers.empty() || layers.back().name != layer)
            layers.push_back({layer, index, c, 0});
        ++layers.back().channels;
    }
    return layers;
}

std::vector<std::string> namesOf(const std::vector<FilePart>& parts) {
    std::vector<std::string> names;
    for (const FilePart& part : parts)
        if (!part.name.empty())
            names.push_back(part.name);
    return names;
}

} // namespace

std::vector<FilePart> partsOf(OIIO::ImageInput& input) {
    std::vector<FilePart> parts;
    const bool several = input.seek_subimage(1, 0);
    for (int index = 0; index < kMostParts && input.seek_subimage(index, 0); ++index) {
        const OIIO::ImageSpec& spec = input.spec();
        parts.push_back({several ? partName(spec, index) : "", index, 0, spec.nchannels});
        const std::vector<FilePart> layers = layersOf(spec, index);
        parts.back().only = layers.size() == 1 ? layers.front().name : "";
        if (layers.size() > 1)
            std::copy_if(layers.begin(), layers.end(), std::back_inserter(parts),
                         [](const FilePart& layer) { return !layer.name.empty(); });
        if (!several)
            break;
    }
    input.geterror(); // seeking behind the last part is no fault of the file
    return parts;
}

FilePart chosenPart(const std::filesystem::path& path, const std::vector<FilePart>& parts,
                    const std::string& name) {
    if (name.empty())
        return parts.front();
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const FilePart& part) {
        return part.name == name || part.only == name;
    });
    if (found != parts.end())
        return *found;
    const std::vector<std::string> names = namesOf(parts);
    if (names.empty())
        failUsage("{} has no layer {}; all that it holds is one picture.", path.string(), name);
    failUsage("{} has no layer {}; there is {}.", path.string(), name, listOf(names));
}

void takePart(ImageFileInfo& info, const FilePart& part, const std::vector<FilePart>& parts,
              const std::string& asked) {
    const auto first = info.channelNames.begin() + part.firstChannel;
    info.channelNames = {first, first + part.channels};
    info.channels = part.channels;
    info.layer = asked;
    info.layers = namesOf(parts);
    if (!asked.empty() || info.layers.empty())
        return;
    if (part.name.empty())
        info.notes.push_back(message("{} has the layers {}; all its channels are used. One layer can be "
                                     "chosen instead.",
                                     info.name, listOf(info.layers)));
    else
        info.notes.push_back(message("{} has several parts: {}. Only {} is used; another can be chosen "
                                     "instead.",
                                     info.name, listOf(info.layers), part.name));
}

} // namespace texloom

#include "core/io/channel_names.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace texloom {

namespace {

/// A channel's name within its layer.
std::string innerName(const std::string& channel) {
    const std::string layer = layerOf(channel);
    return layer.empty() ? channel : channel.substr(layer.size() + 1);
}

bool isOneOf(std::string name, std::initializer_list<const char*> known) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return std::find(known.begin(), known.end(), name) != known.end();
}

} // namespace

std::string layerOf(const std::string& channel) {
    const std::size_t stop = channel.rfind('.');
    return stop == std::string::npos ? std::string() : channel.substr(0, stop);
}

std::vector<std::string> defaultChannelNames(int count) {
    std::vector<std::string> names = {"R", "G", "B", "A"};
    if (count <= 2)
        names = {"Y", "A"};
    for (int channel = static_cast<int>(names.size()); channel < count; ++channel)
        names.push_back("channel" + std::to_string(channel));
    names.resize(static_cast<std::size_t>(count));
    return names;
}

std::vector<AlphaGroup> alphaGroups(const std::vector<std::string>& channels) {
    std::vector<AlphaGroup> groups;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (!isOneOf(innerName(channels[i]), {"a", "alpha"}))
            continue;
        AlphaGroup group{static_cast<int>(i), {}};
        for (std::size_t other = 0; other < channels.size(); ++other)
            if (layerOf(channels[other]) == layerOf(channels[i]) &&
                isOneOf(innerName(channels[other]), {"r", "g", "b", "y", "red", "green", "blue"}))
                group.colours.push_back(static_cast<int>(other));
        if (!group.colours.empty())
            groups.push_back(std::move(group));
    }
    return groups;
}

} // namespace texloom

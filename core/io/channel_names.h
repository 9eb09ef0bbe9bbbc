#pragma once

#include <string>
#include <vector>

namespace texloom {

/// The layer that a channel's name puts it into: "diffuse" of "diffuse.R", empty of "R".
std::string layerOf(const std::string& channel);

/// The names of a file's channels where nobody gave any: Y, YA, RGB, RGBA, then channel4 and so on.
std::vector<std::string> defaultChannelNames(int count);

/// One alpha channel and the channels whose colours it belongs to.
struct AlphaGroup {
    int alpha = 0;
    std::vector<int> colours;
};

/// The alpha channels among these, by their names: "A" for R, G, B or Y of the same layer. Channels of other
/// names (depth, normals, masks) belong to none.
std::vector<AlphaGroup> alphaGroups(const std::vector<std::string>& channels);

} // namespace texloom

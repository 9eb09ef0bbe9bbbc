#pragma once

#include "core/image/map_role.h"

#include <string>
#include <vector>

namespace texloom {

/// What one channel of a packed file holds.
struct PackedChannel {
    MapRole role;          ///< Other: nothing that a material uses
    float otherwise;       ///< where there is no such map
    bool inverted = false; ///< 1 − the map: smoothness from roughness
    bool operator==(const PackedChannel&) const = default;
};

/// The map that one channel of a file holds: all of its channels are one map where `index` is below 0.
struct MapChannel {
    int index = -1;
    bool inverted = false; ///< 1 − the channel is the map

    bool whole() const { return index < 0; }
    bool operator==(const MapChannel&) const = default;
};

/// Occlusion, roughness, metallic in red, green, blue, as Unreal, Godot, glTF and Poly Haven (ARM) pack them.
const std::vector<PackedChannel>& packingOrm();
/// Unity's mask map: metallic, occlusion, detail, smoothness.
const std::vector<PackedChannel>& packingMaskMap();

/// A file's name (without its extension) split as Poly Haven, ambientCG, Quixel, Substance, Unreal and Unity
/// name the maps of a material, in any case: "T_Bark_NORMAL-dx", "Bark_2K-JPG_NormalDX" and
/// "bark_nor_dx_2k" are "Bark" or "bark" with a normal map of DirectX.
struct MapName {
    std::string base; ///< the material, without "T_" and resolution; the whole name where nothing was
                      ///< recognised
    MapRole role = MapRole::Other; ///< of a file with one map
    /// By channel, of a file that packs several maps, or one in another sense, as gloss; else empty.
    std::vector<PackedChannel> packing = {};
    std::string resolution = {}; ///< "2k" in lower case; empty if the name says none

    /// Whether the name says that the file holds anything but colours.
    bool isCompanion() const {
        return !packing.empty() || (role != MapRole::Other && role != MapRole::Color);
    }
};

/// @param alone whether a name that is nothing but a kind of map counts, as "normal" in a material's folder.
MapName mapNameFrom(const std::string& stem, bool alone = false);

/// Whether two files of one folder belong to one material by their names: the same base in any case, and not
/// of two resolutions.
bool sameMaterial(const std::string& stem, const std::string& other);

} // namespace texloom

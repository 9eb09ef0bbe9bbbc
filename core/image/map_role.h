#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// What a picture of a material holds.
enum class MapRole {
    Other,
    Color,
    NormalGl, ///< a normal map whose green points up, as OpenGL, Blender and Unity use it
    NormalDx, ///< one whose green points down, as DirectX and Unreal use it
    Roughness,
    Metallic,
    Occlusion,
    Opacity,
    Height,
};

inline bool isNormal(MapRole role) {
    return role == MapRole::NormalGl || role == MapRole::NormalDx;
}

struct MapRoleInfo {
    MapRole role;
    std::string id;    ///< kebab-case, as recipes write it
    std::string title; ///< as the window shows it
};

/// All of them, in the order of the enumeration.
const std::vector<MapRoleInfo>& mapRoles();
std::string_view mapRoleId(MapRole role);
const std::string& mapRoleTitle(MapRole role);
/// @throws UsageError that lists the known ids.
MapRole mapRoleFrom(std::string_view id);

} // namespace texloom

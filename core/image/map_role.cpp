#include "core/image/map_role.h"

#include "core/base/error.h"
#include "core/base/text.h"

namespace texloom {

const std::vector<MapRoleInfo>& mapRoles() {
    static const std::vector<MapRoleInfo> roles = {
        {MapRole::Other, "other", TR("Other data")},
        {MapRole::Color, "color", TR("Colour")},
        {MapRole::NormalGl, "normal-gl", TR("Normal, green up (OpenGL)")},
        {MapRole::NormalDx, "normal-dx", TR("Normal, green down (DirectX)")},
        {MapRole::Roughness, "roughness", TR("Roughness")},
        {MapRole::Metallic, "metallic", TR("Metallic")},
        {MapRole::Occlusion, "occlusion", TR("Ambient occlusion")},
        {MapRole::Opacity, "opacity", TR("Opacity")},
        {MapRole::Height, "height", TR("Height")},
    };
    return roles;
}

std::string_view mapRoleId(MapRole role) {
    return mapRoles()[static_cast<std::size_t>(role)].id;
}

const std::string& mapRoleTitle(MapRole role) {
    return mapRoles()[static_cast<std::size_t>(role)].title;
}

MapRole mapRoleFrom(std::string_view id) {
    std::vector<std::string> known;
    for (const MapRoleInfo& info : mapRoles()) {
        if (info.id == id)
            return info.role;
        known.push_back(info.id);
    }
    failUsage("There is no kind of map {}; the kinds are {}.", id, listOf(known));
}

} // namespace texloom

#include "core/image/map_role.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace texloom {

namespace {

struct Suffix {
    std::string_view word;
    MapRole role;
};

constexpr Suffix kSuffixes[] = {
    {"color", MapRole::Color},
    {"colour", MapRole::Color},
    {"col", MapRole::Color},
    {"basecolor", MapRole::Color},
    {"albedo", MapRole::Color},
    {"diff", MapRole::Color},
    {"diffuse", MapRole::Color},
    {"normal", MapRole::NormalGl},
    {"nor", MapRole::NormalGl},
    {"nrm", MapRole::NormalGl},
    {"norm", MapRole::NormalGl},
    {"normalgl", MapRole::NormalGl},
    {"normaldx", MapRole::NormalDx},
    {"nordx", MapRole::NormalDx},
    {"norgl", MapRole::NormalGl},
    {"roughness", MapRole::Roughness},
    {"rough", MapRole::Roughness},
    {"metallic", MapRole::Metallic},
    {"metalness", MapRole::Metallic},
    {"metal", MapRole::Metallic},
    {"ao", MapRole::Occlusion},
    {"occlusion", MapRole::Occlusion},
    {"ambientocclusion", MapRole::Occlusion},
    {"opacity", MapRole::Opacity},
    {"displacement", MapRole::Height},
    {"disp", MapRole::Height},
    {"height", MapRole::Height},
};

bool parts(char letter) {
    return letter == '_' || letter == '-' || letter == ' ' || letter == '.';
}

std::string lowered(std::string_view text) {
    std::string lower;
    for (const char letter : text)
        lower += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return lower;
}

/// The last word of a name and what precedes it.
struct Ending {
    std::string base, word;
};

Ending lastWord(const std::string& name) {
    std::size_t at = name.size();
    while (at > 0 && !parts(name[at - 1]))
        --at;
    return at == 0 ? Ending{name, ""} : Ending{name.substr(0, at - 1), lowered(name.substr(at))};
}

MapRole roleOf(std::string_view word) {
    const auto found = std::find_if(std::begin(kSuffixes), std::end(kSuffixes),
                                    [&](const Suffix& s) { return s.word == word; });
    return found == std::end(kSuffixes) ? MapRole::Other : found->role;
}

} // namespace

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

MapName mapNameFrom(const std::string& stem) {
    const Ending last = lastWord(stem);
    const Ending before = lastWord(last.base);
    if (const MapRole role = roleOf(last.word); role != MapRole::Other)
        return {last.base, role};
    const bool direction =
        last.word == "gl" || last.word == "dx" || last.word == "opengl" || last.word == "directx";
    if (direction && isNormal(roleOf(before.word)))
        return {before.base, last.word.ends_with('x') ? MapRole::NormalDx : MapRole::NormalGl};
    if (const MapRole role = roleOf(before.word); role != MapRole::Other && !last.word.empty() &&
                                                  std::isdigit(static_cast<unsigned char>(last.word[0])) != 0)
        return {before.base, role}; // bark_normal_2k
    return {stem, MapRole::Other};
}

} // namespace texloom

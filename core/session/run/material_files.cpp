#include "core/session/run/material_files.h"

#include "core/image/map_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <set>
#include <string>
#include <system_error>

namespace texloom {

namespace fs = std::filesystem;

namespace {

std::string stemOf(const fs::path& file) {
    return file.stem().string();
}

MapName nameIn(const fs::path& file) {
    return mapNameFrom(stemOf(file), true);
}

bool areTogether(const fs::path& one, const fs::path& other) {
    return one.parent_path() == other.parent_path() && sameMaterial(stemOf(one), stemOf(other));
}

/// The kinds of maps in a file.
std::set<MapRole> rolesOf(const MapName& name) {
    std::set<MapRole> roles;
    const auto add = [&roles](MapRole role) {
        if (role != MapRole::Other)
            roles.insert(role == MapRole::NormalDx ? MapRole::NormalGl : role);
    };
    add(name.role);
    for (const PackedChannel& channel : name.packing)
        add(channel.role);
    return roles;
}

/// What is taken first: single maps before packed ones, normals of OpenGL before those of DirectX.
int rankOf(const fs::path& file) {
    const MapName name = nameIn(file);
    return name.packing.size() > 1 ? 2 : !name.packing.empty() || name.role == MapRole::NormalDx ? 1 : 0;
}

/// The maps without those that only repeat others.
std::vector<fs::path> withoutRepeats(std::vector<fs::path> maps, std::set<MapRole> had) {
    std::stable_sort(maps.begin(), maps.end(),
                     [](const fs::path& a, const fs::path& b) { return rankOf(a) < rankOf(b); });
    std::vector<fs::path> kept;
    for (const fs::path& map : maps) {
        const std::set<MapRole> roles = rolesOf(nameIn(map));
        const bool adds =
            std::any_of(roles.begin(), roles.end(), [&had](MapRole role) { return !had.contains(role); });
        if (!adds)
            continue;
        had.insert(roles.begin(), roles.end());
        kept.push_back(map);
    }
    return kept;
}

/// Which of a material's files is its picture: its colours, else one whose name says nothing, else the first.
fs::path pictureOf(const std::vector<fs::path>& files) {
    const auto withRole = [&files](MapRole role) {
        return std::find_if(files.begin(), files.end(), [role](const fs::path& file) {
            const MapName name = nameIn(file);
            return name.role == role && name.packing.empty();
        });
    };
    if (const auto colours = withRole(MapRole::Color); colours != files.end())
        return *colours;
    const auto other = withRole(MapRole::Other);
    return other != files.end() ? *other : files.front();
}

} // namespace

bool isPictureName(const fs::path& file) {
    constexpr std::array<std::string_view, 7> endings = {".png",  ".jpg", ".jpeg", ".tif",
                                                         ".tiff", ".exr", ".hdr"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::vector<MaterialFiles> materialsOf(const std::vector<fs::path>& files) {
    std::vector<MaterialFiles> materials;
    std::vector<bool> taken(files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (taken[i])
            continue;
        std::vector<fs::path> together = {files[i]};
        for (std::size_t j = i + 1; j < files.size(); ++j)
            if (!taken[j] && areTogether(files[i], files[j])) {
                taken[j] = true;
                together.push_back(files[j]);
            }
        MaterialFiles material{pictureOf(together), {}};
        std::copy_if(together.begin(), together.end(), std::back_inserter(material.maps),
                     [](const fs::path& file) { return nameIn(file).isCompanion(); });
        std::erase(material.maps, material.image);
        material.maps = withoutRepeats(std::move(material.maps), rolesOf(nameIn(material.image)));
        materials.push_back(std::move(material));
    }
    return materials;
}

std::vector<fs::path> neighboursOf(const fs::path& image, const std::vector<fs::path>& known) {
    std::vector<fs::path> maps;
    std::set<MapRole> had = rolesOf(nameIn(image));
    for (const fs::path& file : known)
        had.merge(rolesOf(nameIn(file)));
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(image.parent_path(), error)) {
        const fs::path& file = entry.path();
        if (file != image && isPictureName(file) && nameIn(file).isCompanion() && areTogether(image, file) &&
            std::find(known.begin(), known.end(), file) == known.end())
            maps.push_back(file);
    }
    std::sort(maps.begin(), maps.end());
    return withoutRepeats(std::move(maps), std::move(had));
}

std::vector<fs::path> picturesIn(const fs::path& folder) {
    std::vector<fs::path> pictures, folders;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (entry.is_directory(error))
            folders.push_back(entry.path());
        else if (isPictureName(entry.path()))
            pictures.push_back(entry.path());
    }
    if (pictures.empty())
        for (const fs::path& inner : folders)
            for (const fs::directory_entry& entry : fs::directory_iterator(inner, error))
                if (!entry.is_directory(error) && isPictureName(entry.path()))
                    pictures.push_back(entry.path());
    std::sort(pictures.begin(), pictures.end());
    return pictures;
}

} // namespace texloom

#pragma once

#include "core/image/map_name.h"
#include "core/io/image_file.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// One file that a preset writes beside the colours: a map as it is, or several packed into channels.
struct PresetFile {
    std::string word; ///< $map in its name
    MapRole role;     ///< of a map as it is; Other for packed ones
    std::vector<PackedChannel> channels = {};
    std::optional<Depth> depth = {}; ///< of whole numbers, where not as the map's own file has
};

/// How a program wants the files of a material: their names, which maps share a file, and where green points.
struct ExportPreset {
    std::string id; ///< kebab-case
    std::string title;
    std::string pattern; ///< of names; see expandName()
    std::string color;   ///< $map of the colours
    MapRole normals;     ///< NormalGl or NormalDx; Other leaves them as they are
    std::vector<PresetFile> files;
};

/// All presets; the first keeps every map in a file of its own, named as it came.
const std::vector<ExportPreset>& exportPresets();

/// @throws UsageError that lists the known ids.
const ExportPreset& findExportPreset(std::string_view id);

} // namespace texloom

#include "core/session/export/export_preset.h"

#include "core/base/error.h"
#include "core/base/text.h"

namespace texloom {

const std::vector<ExportPreset>& exportPresets() {
    static const std::vector<ExportPreset> presets = {
        {"generic",
         TR("As the exemplar's files"),
         "$name_$method_s$seed_$size$place_$map",
         "",
         MapRole::Other,
         {}},
        {"blender",
         TR("Blender"),
         "$name_$map",
         "basecolor",
         MapRole::NormalGl,
         {{"normal", MapRole::NormalGl},
          {"roughness", MapRole::Roughness},
          {"metallic", MapRole::Metallic},
          {"ao", MapRole::Occlusion},
          {"opacity", MapRole::Opacity},
          {"height", MapRole::Height, {}, Depth::Bits16}}},
        {"unity",
         TR("Unity (mask map)"),
         "$name_$map",
         "BaseMap",
         MapRole::NormalGl,
         {{"Normal", MapRole::NormalGl, {}, Depth::Bits8},
          {"MaskMap", MapRole::Other, packingMaskMap(), Depth::Bits8},
          {"Height", MapRole::Height, {}, Depth::Bits16}}},
        {"unreal",
         TR("Unreal Engine"),
         "T_$name_$map",
         "BC",
         MapRole::NormalDx,
         {{"N", MapRole::NormalDx, {}, Depth::Bits8},
          {"ORM", MapRole::Other, packingOrm(), Depth::Bits8},
          {"H", MapRole::Height, {}, Depth::Bits16}}},
        {"godot",
         TR("Godot"),
         "$name_$map",
         "albedo",
         MapRole::NormalGl,
         {{"normal", MapRole::NormalGl, {}, Depth::Bits8},
          {"orm", MapRole::Other, packingOrm(), Depth::Bits8},
          {"height", MapRole::Height, {}, Depth::Bits16}}},
        {"gltf",
         TR("glTF"),
         "$name_$map",
         "baseColor",
         MapRole::NormalGl,
         {{"normal", MapRole::NormalGl, {}, Depth::Bits8},
          {"occlusionRoughnessMetallic", MapRole::Other, packingOrm(), Depth::Bits8}}},
    };
    return presets;
}

const ExportPreset& findExportPreset(std::string_view id) {
    std::vector<std::string> known;
    for (const ExportPreset& preset : exportPresets()) {
        if (preset.id == id)
            return preset;
        known.push_back(preset.id);
    }
    failUsage("There is no export preset {}; choose one of {}.", id, listOf(known));
}

} // namespace texloom

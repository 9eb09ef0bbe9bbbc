#include "core/session/export/export_preset.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"
#include "core/session/export/name_template.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

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

ExportPreset exportPresetFrom(const std::string& idOrFile) {
    const std::filesystem::path file(idOrFile);
    if (file.extension() != ".json")
        return findExportPreset(idOrFile);
    return ExportPreset::fromJson(file.stem().string(), readText(file));
}

namespace {

/// In files: where green points in normal maps.
constexpr std::array<std::pair<std::string_view, MapRole>, 3> kDirections = {
    {{"as-they-are", MapRole::Other}, {"up", MapRole::NormalGl}, {"down", MapRole::NormalDx}}};
constexpr std::size_t kMostChannels = 4;

JsonField::Json channelJson(const PackedChannel& channel) {
    JsonField::Json json;
    if (channel.role != MapRole::Other)
        json["map"] = mapRoleId(channel.role);
    if (channel.inverted)
        json["inverted"] = true;
    json["otherwise"] = channel.otherwise;
    return json;
}

JsonField::Json fileJson(const PresetFile& file) {
    JsonField::Json json = {{"word", file.word}};
    if (file.packed())
        for (const PackedChannel& channel : file.channels)
            json["channels"].push_back(channelJson(channel));
    else
        json["map"] = mapRoleId(file.role);
    if (file.depth)
        json["depth"] = *file.depth == Depth::Bits8 ? 8 : 16;
    return json;
}

PackedChannel channelFrom(const JsonField& field) {
    field.only({"map", "inverted", "otherwise"});
    PackedChannel channel{MapRole::Other, 0, false};
    if (field.has("map"))
        channel.role = mapRoleFrom(field.at("map").text());
    if (field.has("inverted")) {
        const Value inverted = field.at("inverted").value();
        if (!std::holds_alternative<bool>(inverted))
            field.at("inverted").wrong(TR("true or false"));
        channel.inverted = std::get<bool>(inverted);
    }
    if (field.has("otherwise"))
        channel.otherwise = static_cast<float>(field.at("otherwise").number());
    return channel;
}

PresetFile fileFrom(const JsonField& field) {
    field.only({"word", "map", "channels", "depth"});
    PresetFile file{field.at("word").text(), MapRole::Other};
    if (field.has("channels")) {
        const JsonField channels = field.at("channels");
        channels.needArray(1, kMostChannels);
        for (std::size_t i = 0; i < channels.size(); ++i)
            file.channels.push_back(channelFrom(channels.at(i)));
    } else {
        file.role = mapRoleFrom(field.at("map").text());
    }
    if (field.has("depth")) {
        const int bits = field.at("depth").whole();
        if (bits != 8 && bits != 16)
            field.at("depth").wrong(TR("8 or 16"));
        file.depth = bits == 8 ? Depth::Bits8 : Depth::Bits16;
    }
    return file;
}

MapRole directionFrom(const JsonField& field) {
    const std::string id = field.text();
    for (const auto& [name, role] : kDirections)
        if (name == id)
            return role;
    field.wrong(TR("as-they-are, up or down"));
}

/// A file's name by a pattern; see nameWords(). @throws UsageError where it holds words that there are not.
std::string nameWith(const std::string& pattern, const std::string& map) {
    return expandName(pattern, {{"name", "x"},
                                {"method", "x"},
                                {"seed", "x"},
                                {"w", "x"},
                                {"h", "x"},
                                {"size", "x"},
                                {"place", "x"},
                                {"map", map}});
}

} // namespace

ExportPreset ExportPreset::fromJson(std::string_view id, std::string_view text) {
    const JsonField::Json json = parseJson(TR("export preset"), text);
    const JsonField root(TR("export preset"), json);
    root.only({"export-preset", "title", "pattern", "color", "normals", "files"});
    const int format = root.at("export-preset").whole();
    if (format > kFormat)
        failUsage("The export preset is of format {}, made by a newer Texloom; this one ({}) reads up to {}.",
                  format, kVersion, kFormat);
    ExportPreset preset{std::string(id),         root.at("title").text(),           root.at("pattern").text(),
                        root.at("color").text(), directionFrom(root.at("normals")), {}};
    const JsonField files = root.at("files");
    files.needArray(0, 64);
    for (std::size_t i = 0; i < files.size(); ++i)
        preset.files.push_back(fileFrom(files.at(i)));
    checkExportPreset(preset);
    return preset;
}

std::string ExportPreset::toJson() const {
    JsonField::Json json = {
        {"export-preset", kFormat}, {"title", title}, {"pattern", pattern}, {"color", color}};
    for (const auto& [name, role] : kDirections)
        if (role == normals)
            json["normals"] = name;
    json["files"] = JsonField::Json::array();
    for (const PresetFile& file : files)
        json["files"].push_back(fileJson(file));
    return json.dump(2, ' ', false, JsonField::Json::error_handler_t::replace) + "\n";
}

void checkExportPreset(const ExportPreset& preset) {
    if (preset.title.find_first_not_of(" \t") == std::string::npos)
        failUsage("The export preset needs a name.");
    if (nameWith(preset.pattern, "x").empty())
        failUsage("The names of files need a letter or a word, such as $name.");
    if (!preset.files.empty() && nameWith(preset.pattern, "x") == nameWith(preset.pattern, "y"))
        failUsage("The names of files need $map, so that the maps' names differ.");
    std::set<std::string> words = {preset.color};
    for (const PresetFile& file : preset.files) {
        if (file.word.empty())
            failUsage("A file of the export preset has no word for $map.");
        if (!words.insert(file.word).second)
            failUsage("Two files of the export preset have the word {} for $map; give them different ones.",
                      file.word);
    }
    words.insert(preset.pattern);
    for (const std::string& word : words)
        if (word.find_first_of(std::string("/\\\0", 3)) != std::string::npos)
            failUsage("{} holds a slash, which no file's name can.", word);
}

std::vector<ExportPreset> exportPresetsIn(const std::filesystem::path& folder,
                                          const std::function<void(const Message&)>& refused) {
    std::vector<ExportPreset> read;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".json")
            continue;
        try {
            read.push_back(exportPresetFrom(entry.path().string()));
        } catch (const Error& wrong) {
            refused(message("{}: {}", entry.path().filename().string(), wrong.message()));
        }
    }
    std::sort(read.begin(), read.end(),
              [](const ExportPreset& a, const ExportPreset& b) { return a.title < b.title; });
    return read;
}

} // namespace texloom

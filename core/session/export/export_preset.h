#pragma once

#include "core/base/message.h"
#include "core/image/map_name.h"
#include "core/io/image_file.h"

#include <filesystem>
#include <functional>
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

    bool packed() const { return !channels.empty(); }
    bool operator==(const PresetFile&) const = default;
};

/// How a program wants the files of a material: their names, which maps share a file, and where green points.
struct ExportPreset {
    std::string id; ///< kebab-case
    std::string title;
    std::string pattern; ///< of names; see expandName()
    std::string color;   ///< $map of the colours
    MapRole normals;     ///< NormalGl or NormalDx; Other leaves them as they are
    std::vector<PresetFile> files;

    /// Version of the format that this build writes and the newest it reads.
    static constexpr int kFormat = 1;

    std::string toJson() const;
    /// @throws UsageError that names the wrong field, or says that a newer Texloom wrote it.
    static ExportPreset fromJson(std::string_view id, std::string_view text);
    bool operator==(const ExportPreset&) const = default;
};

/// The presets that Texloom ships; the first keeps every map in a file of its own, named as it came.
const std::vector<ExportPreset>& exportPresets();

/// The presets in the .json files of a folder, by title; `refused` is told of those that cannot be read.
std::vector<ExportPreset> exportPresetsIn(const std::filesystem::path& folder,
                                          const std::function<void(const Message& sentence)>& refused);

/// Checks that files can be written as a preset says: a title, names that differ from each other and hold no
/// slash, words in the pattern that there are, and packed files of at most four channels. @throws UsageError
void checkExportPreset(const ExportPreset& preset);

/// A shipped preset. @throws UsageError that lists the known ids.
const ExportPreset& findExportPreset(std::string_view id);

/// A shipped preset by its id, or one in a .json file. @throws UsageError, Error
ExportPreset exportPresetFrom(const std::string& idOrFile);

} // namespace texloom

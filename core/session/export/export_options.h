#pragma once

#include "core/session/export/export_preset.h"
#include "core/session/export/name_template.h"
#include "core/session/run/run.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace texloom {

/// What an export writes, and how.
struct ExportOptions {
    std::filesystem::path image; ///< the result's file; its extension is the format
    Depth depth = Depth::Bits8;
    std::string space;   ///< of the file; empty for the exemplar's where the format can say it, else sRGB
    bool sidecar = true; ///< the recipe beside it, as NAME.json
    std::vector<std::filesystem::path> maps; ///< position maps to write: .exr and .png
    /// Further outputs to write, by the id of their port, as writeAsset() does. Of several from one port the
    /// others get -2, -3 … after the name.
    std::map<std::string, std::filesystem::path> outputs;
    bool companions = true; ///< companion maps as NAME_COMPANION.EXT, in their own depth
    /// Which companion maps share a file, and what they are called.
    ExportPreset preset = exportPresets().front();
    /// Template with $map of companion maps' names, without extension; empty: the image's name, with _$map.
    std::string pattern;
    /// Where green points in normal maps: NormalGl or NormalDx; Other for the preset's way.
    MapRole normals = MapRole::Other;
    /// Depths of companion files, by ExportEntry::word, where not as the preset says.
    std::map<std::string, Depth> depths;
    /// Where this is given, files that are there and not among these are refused, not replaced.
    std::optional<std::set<std::filesystem::path>> mayReplace;
    std::function<void()> check; ///< called throughout; what it throws ends the export
};

/// One file of an export, before it is written.
struct ExportEntry {
    std::filesystem::path path;
    Message content; ///< "result", "position map (STMap)", "recipe", …
    bool exists = false;
    std::string word = {};           ///< of companion maps: $map of their name
    std::optional<Depth> depth = {}; ///< of pictures
    bool foreign = false;            ///< it exists, and Texloom did not write it
};

/// The words that templates of a result's names know: $name, $method, $seed, $w, $h, $size, $place (of a
/// region), and $map, which is `map`.
NameWords nameWords(const Result& result, const std::string& map);

/// The depth nearest to a source file's own that the format of `path` holds; the format's usual one where the
/// source has none.
Depth depthLike(const ImageFileInfo& source, const std::filesystem::path& path);

/// How files are named whose pictures are like the source's: .png, .tif, .exr or .hdr; without loss for a
/// JPEG's.
std::string extensionLike(const ImageFileInfo& source);

} // namespace texloom

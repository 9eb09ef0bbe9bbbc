#pragma once

#include "core/session/export/export_preset.h"
#include "core/session/export/name_template.h"
#include "core/session/export/output_guard.h"
#include "core/session/run/run.h"

#include <cstdint>
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
    bool companions = true;         ///< companion maps as NAME_COMPANION.EXT, in their own depth
    std::string preset = "generic"; ///< which companion maps share a file, and what they are called
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

/// Every file that a recipe is made from.
std::vector<std::filesystem::path> sourcesOf(const Recipe& recipe);

/// Tells a guard, before a plan is run, which files it reads and which an export of its result would write.
void announce(const RunPlan& plan, const ExportOptions& options, OutputGuard& guard);

/// The words that templates of a result's names know: $name, $method, $seed, $w, $h, $size, $place (of a
/// region), and $map, which is `map`.
NameWords nameWords(const Result& result, const std::string& map);

/// The files that exportResult() would write, in order. @throws UsageError, also where one is a file that the
/// result was made from.
std::vector<ExportEntry> exportEntries(const Result& result, const ExportOptions& options);

/// The depth nearest to a source file's own that the format of `path` holds; the format's usual one where the
/// source has none.
Depth depthLike(const ImageFileInfo& source, const std::filesystem::path& path);

/// How files are named whose pictures are like the source's: .png, .tif, .exr or .hdr; without loss for a
/// JPEG's.
std::string extensionLike(const ImageFileInfo& source);

/// The samples that files of whole numbers cut off: below 0 or above 1. @param check called for every row.
std::uint64_t clippedSamples(
    const ImageView& image, const std::function<void()>& check = [] {});

/// Writes a picture that was made from images like `source`: in that one's depth where the format holds it,
/// and as colours or data as that one is. @param check called for every row; what it throws leaves no file.
/// @throws Error, UsageError
void exportPicture(const std::filesystem::path& path, const ImageView& picture, const ExemplarFile& source,
                   const std::function<void()>& check = {});

/// Writes them; each whole or not at all. If one fails or `check` throws, files that this call made new are
/// removed.
/// @return the entries written. @throws Error, UsageError
std::vector<ExportEntry> exportResult(const Result& result, const ExportOptions& options);

/// Makes a plan with stripRows strip by strip and writes the image as it comes, so that it is never in memory
/// whole, and the recipe beside it. There are no position maps of such outputs, nor companion maps.
/// @param make runs one strip, as startRun() would. @return the plan with the time all strips took, and what
/// the first had to say. @throws what `make` throws, Error, UsageError
Result exportStrips(const RunPlan& plan, const ExportOptions& options,
                    const std::function<Result(RunPlan)>& make);

/// Recipe, timings by stage, peak memory, figures and curves as JSON: the command line's --report.
std::string reportJson(const Result& result, const std::filesystem::path& folder);

} // namespace texloom

#pragma once

#include "core/base/exemplar_edit.h"
#include "core/image/map_name.h"
#include "core/image/size.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

class JsonField;

/// A file that a recipe uses.
struct RecipeFile {
    std::filesystem::path
        path;          ///< absolute in memory; relative to the recipe's folder in JSON where that is possible
    std::string space; ///< id of the colour space that its values are in; "raw" for data
    std::string hash;  ///< SHA-1 of its bytes, or empty
    /// Of companion maps, the id of what they hold; empty: as the file's name says.
    std::string role = {};
    std::string layer = {};  ///< the part or layer of it, see ReadOptions::layer
    MapChannel channel = {}; ///< of companion maps in a file that packs several
};

/// Files by the id of the port that they go into, in the order in which they were given.
using RecipeInputs = std::map<std::string, std::vector<RecipeFile>, std::less<>>;

/// The files that a run learns one exemplar from, and what is done to them first.
struct RecipeExemplar {
    RecipeFile image;
    std::optional<RecipeFile> mask;
    std::vector<RecipeFile> companions;
    RecipeInputs inputs = {}; ///< further pictures of the exemplar's size
    ExemplarEdits edits = {}; ///< made in order, on everything that belongs to the exemplar
    double weight = 1;        ///< see Exemplar::weight
};

/// One method of a run.
struct RecipeStep {
    std::string method;
    Values parameters;
};

/// Steps from a list in JSON. @throws UsageError that names the wrong field.
std::vector<RecipeStep> stepsFrom(const JsonField& field);

/// Exemplars from a list in JSON. @param folder against which relative paths are taken.
/// @throws UsageError that names the wrong field.
std::vector<RecipeExemplar> exemplarsFrom(const JsonField& field, const std::filesystem::path& folder);

/// The methods' ids with `separator` between them.
std::string methodIds(const std::vector<RecipeStep>& steps, const std::string& separator);

/// All that a result depends on: what it takes to make the same bits again with the same build.
struct Recipe {
    /// Version of the format that this build writes and the newest it reads.
    static constexpr int kFormat = 1;

    std::string version; ///< of the Texloom that wrote it
    /// The methods in order, at least one; each takes up what the one before it made. Parameters are complete
    /// when written by Texloom; missing ones get the method's defaults.
    std::vector<RecipeStep> steps = {{}};
    std::vector<RecipeExemplar> exemplars; ///< none where the methods learn from none
    RecipeInputs inputs; ///< what else goes into the methods' ports, such as an image to start from
    Size size;
    Wrap wrap;
    std::uint64_t seed = 0;
    std::optional<Region> region; ///< the part that was made, if not all

    /// Every file that it names: all that belongs to the exemplars, and the inputs.
    std::vector<RecipeFile*> files();
    std::vector<const RecipeFile*> files() const;
    /// What results are called after: the file of the first exemplar, or else of the first input; "texture"
    /// if it names no file.
    std::string name() const;
    /// The colour space that results are written in unless another is asked for: that of the first exemplar's
    /// file, or else of the image that the run starts from; "srgb" if there is neither.
    std::string space() const;

    /// JSON text with paths relative to `folder`.
    std::string toJson(const std::filesystem::path& folder) const;
    /// @param folder against which relative paths are taken.
    /// @throws UsageError that names the wrong field, its value and what it may be.
    static Recipe fromJson(std::string_view text, const std::filesystem::path& folder);
};

/// The recipe in a .json file, or embedded in an image that Texloom wrote. @throws Error or UsageError
Recipe readRecipe(const std::filesystem::path& path);

} // namespace texloom

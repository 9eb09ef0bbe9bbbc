#pragma once

#include "core/base/value.h"
#include "core/image/exemplar_edit.h"
#include "core/image/size.h"

#include <cstdint>
#include <filesystem>
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
};

/// The files that a run learns one exemplar from, and what is done to them first.
struct RecipeExemplar {
    RecipeFile image;
    std::optional<RecipeFile> mask;
    std::vector<RecipeFile> companions;
    ExemplarEdits edits = {}; ///< made in order, on mask and companions, too
    double weight = 1;        ///< see Exemplar::weight
};

/// A method that takes up what the one before it made.
struct RecipeStep {
    std::string method;
    Values parameters;
};

/// Steps from a list in JSON. @throws UsageError that names the wrong field.
std::vector<RecipeStep> stepsFrom(const JsonField& field);

/// All that a result depends on: what it takes to make the same bits again with the same build.
struct Recipe {
    /// Version of the format that this build writes and the newest it reads.
    static constexpr int kFormat = 1;

    std::string version; ///< of the Texloom that wrote it
    std::string method;
    Values parameters; ///< complete when written by Texloom; missing ones get the method's defaults
    std::vector<RecipeStep> then; ///< further methods, each starting from the image of the one before
    std::vector<RecipeExemplar> exemplars;
    std::optional<RecipeFile> initial;
    Size size;
    Wrap wrap;
    std::uint64_t seed = 0;
    std::optional<Region> region; ///< the part that was made, if not all

    /// Every file that it names: images, masks and companions of the exemplars, and the initial image.
    std::vector<RecipeFile*> files();
    std::vector<const RecipeFile*> files() const;

    /// JSON text with paths relative to `folder`.
    std::string toJson(const std::filesystem::path& folder) const;
    /// @param folder against which relative paths are taken.
    /// @throws UsageError that names the wrong field, its value and what it may be.
    /// @param needsExemplar whether one without exemplars is refused.
    static Recipe fromJson(std::string_view text, const std::filesystem::path& folder,
                           bool needsExemplar = true);
};

/// The recipe in a .json file, or embedded in an image that Texloom wrote. @throws Error or UsageError
Recipe readRecipe(const std::filesystem::path& path);

} // namespace texloom

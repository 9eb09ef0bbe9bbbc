#pragma once

#include "core/io/recipe.h"

#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// Methods with settings under a name, to be used on any exemplar: a recipe without its images.
struct Preset {
    std::string id; ///< kebab-case
    std::string title;
    std::string summary;
    std::vector<RecipeStep> steps; ///< at least one; each starts from the image of the one before

    /// @throws UsageError that names the wrong field, method or parameter.
    static Preset fromJson(std::string_view id, std::string_view text);
};

/// The presets that Texloom ships (resources/presets), by id.
const std::vector<Preset>& presets();

/// The shipped preset of this id, or null.
const Preset* findPreset(std::string_view id);

} // namespace texloom

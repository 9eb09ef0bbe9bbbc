#pragma once

#include "core/base/message.h"
#include "core/io/recipe.h"

#include <filesystem>
#include <functional>
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

    /// Version of the format that this build writes and the newest it reads.
    static constexpr int kFormat = 1;

    std::string toJson() const;
    /// @throws UsageError that names the wrong field, method or parameter, or says that a newer Texloom wrote
    /// it.
    static Preset fromJson(std::string_view id, std::string_view text);
};

/// The presets that Texloom ships (resources/presets), by id.
const std::vector<Preset>& presets();

/// The presets in the .json files of a folder, by id; `refused` is told of those that cannot be read.
std::vector<Preset> presetsIn(const std::filesystem::path& folder,
                              const std::function<void(const Message& sentence)>& refused);

/// The shipped preset of this id, or null.
const Preset* findPreset(std::string_view id);

} // namespace texloom

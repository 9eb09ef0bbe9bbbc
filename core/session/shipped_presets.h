#pragma once

#include <span>
#include <string_view>

namespace texloom {

/// A file of resources/presets, compiled in.
struct ShippedPreset {
    std::string_view id; ///< the file's name without its extension
    std::string_view json;
};

/// Generated; by id.
std::span<const ShippedPreset> shippedPresets();

} // namespace texloom

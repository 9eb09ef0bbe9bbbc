#pragma once

#include "core/color/file_color.h"

#include <array>
#include <filesystem>
#include <optional>

namespace texloom {

/// What a PNG's chunks say of its colours, beside a profile.
struct PngColor {
    bool srgb = false;
    std::optional<double> gamma; ///< of gAMA: value = light ^ gamma
    std::optional<Chromaticities> primaries;
    std::optional<std::array<int, 4>> codes; ///< of cICP: primaries, transfer, matrix, full range
};

/// Reads the chunks before the pixels; nothing of a file that is damaged there.
PngColor readPngColor(const std::filesystem::path& path);

} // namespace texloom

#pragma once

#include "core/image/image.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace texloom::test {

/// What other programs put into their files and Texloom never writes itself.
struct ForeignFile {
    int orientation = 1;         ///< EXIF's, 1 to 8
    std::string iccProfile = {}; ///< description of a profile to embed, or empty for none
    int x = 0, y = 0;            ///< top left of an EXR's data window
    bool tiled = false;
};

/// Writes 8 bits (PNG, JPEG, TIFF) or float (EXR) as another program would: without Texloom's attributes.
void writeForeign(const std::filesystem::path& path, const ImageView& image, const ForeignFile& file = {});

/// A palette PNG of 3 × 2 px, 8 bits an index: red, green, blue; blue, green, red.
void writePalettePng(const std::filesystem::path& path);

/// A PNG whose header says that it is so large, with next to nothing in it.
void writeHugePngHeader(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height);

} // namespace texloom::test

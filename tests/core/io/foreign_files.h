#pragma once

#include "core/image/image.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace texloom::test {

/// What other programs put into their files and Texloom never writes itself.
struct ForeignFile {
    int orientation = 1;         ///< EXIF's, 1 to 8
    std::string iccProfile = {}; ///< description of a profile to embed, or empty for none
    int x = 0, y = 0;            ///< top left of an EXR's data window
    bool tiled = false;
    std::vector<std::string> channelNames = {}; ///< empty for the usual ones
    std::vector<float> chromaticities = {};     ///< of an EXR; empty for none
};

/// Writes 8 bits (PNG, JPEG, TIFF) or float (EXR) as another program would: without Texloom's attributes.
void writeForeign(const std::filesystem::path& path, const ImageView& image, const ForeignFile& file = {});

/// A palette PNG of 3 × 2 px, 8 bits an index: red, green, blue; blue, green, red.
void writePalettePng(const std::filesystem::path& path);

/// An uncompressed palette TIFF of 64 × 48 px, one bit an index: its left half red, its right half blue.
void writePaletteTiff(const std::filesystem::path& path);

/// Writes an EXR of several parts, each of the same image, by these names.
void writeParts(const std::filesystem::path& path, const std::vector<ImageView>& images,
                const std::vector<std::string>& names);

/// Writes a grey TIFF of whole numbers of 32 bits.
void writeWideTiff(const std::filesystem::path& path, Size size, const std::vector<std::uint32_t>& numbers);

/// An uncompressed TIFF of a few bytes that says it holds so many pixels of three channels. @param whole
/// makes the file as long as it says, with nothing on the disk behind its header; else it breaks off there.
void writeEmptyTiff(const std::filesystem::path& path, std::uint32_t side, bool whole);

/// A PNG of one pixel with these chunks before it, by name.
void writeTaggedPng(const std::filesystem::path& path, const std::array<std::uint8_t, 3>& color,
                    const std::vector<std::pair<std::string, std::vector<std::uint8_t>>>& chunks);

/// A PNG whose header says that it is so large, with next to nothing in it.
void writeHugePngHeader(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height);

} // namespace texloom::test

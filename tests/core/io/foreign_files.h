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
    std::string type = {};        ///< of the samples, as "uint16" or "half"; empty for the format's usual one
    std::string compression = {}; ///< of an EXR; empty for the usual one
    bool progressive = false;     ///< of a JPEG: in several scans
    int bits = 0;                 ///< of a TIFF's samples; 0 for all that the type has
    bool straightAlpha = false;   ///< of a TIFF or PNG: the samples hold it so, and the file says so
    std::vector<std::uint8_t> profileBytes = {}; ///< a whole ICC profile, or empty for none
};

/// An ICC profile of sRGB's primaries with a power for its curve.
std::vector<std::uint8_t> matrixProfile(double gamma);

/// Writes 8 bits (PNG, JPEG, TIFF) or float (EXR) as another program would: without Texloom's attributes.
void writeForeign(const std::filesystem::path& path, const ImageView& image, const ForeignFile& file = {});

/// A grey PNG of a row of whole bytes, in each of which are 8 / bits pixels. @param bits 1, 2 or 4
void writeGreyPng(const std::filesystem::path& path, int bits, const std::vector<std::uint8_t>& bytes);

/// A Radiance file of 2 × 3 px, in which only the first pixel is white. @param order as "+X 2 +Y 3" for one
/// that is stored by columns, from left to right and each upwards.
void writeOrderedHdr(const std::filesystem::path& path, const std::string& order);

/// A PNG of 3 × 1 px, white, black and black, that is to be turned to the right.
void writeTurnedPng(const std::filesystem::path& path);

/// A TIFF with a page for each picture, of 8 bits.
void writePages(const std::filesystem::path& path, const std::vector<ImageView>& pages);

/// A palette PNG of 3 × 2 px, 8 bits an index: red, green, blue; blue, green, red.
void writePalettePng(const std::filesystem::path& path);

/// An uncompressed palette TIFF of 64 × 48 px, one bit an index: its left half red, its right half blue.
void writePaletteTiff(const std::filesystem::path& path);

/// Writes an EXR of several parts, each of the same image, by these names.
void writeParts(const std::filesystem::path& path, const std::vector<ImageView>& images,
                const std::vector<std::string>& names);

/// Writes a grey TIFF of whole numbers of 32 bits.
void writeWideTiff(const std::filesystem::path& path, Size size, const std::vector<std::uint32_t>& numbers);

/// The same as an EXR.
void writeWideExr(const std::filesystem::path& path, Size size, const std::vector<std::uint32_t>& numbers);

/// A TIFF of one row of pixels of one bit, in which 1 is white.
void writeBilevelTiff(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes);

/// An uncompressed TIFF of a few bytes that says it holds so many pixels of three channels. @param whole
/// makes the file as long as it says, with nothing on the disk behind its header; else it breaks off there.
void writeEmptyTiff(const std::filesystem::path& path, std::uint32_t side, bool whole);

/// A TIFF of 64 × 64 px in tiles of JPEG with four channels of ink, at which known decoders break down.
void writeTiledInkTiff(const std::filesystem::path& path);

/// A PNG of one pixel with these chunks before it, by name.
void writeTaggedPng(const std::filesystem::path& path, const std::array<std::uint8_t, 3>& color,
                    const std::vector<std::pair<std::string, std::vector<std::uint8_t>>>& chunks);

/// A PNG whose header says that it is so large, with next to nothing in it.
void writeHugePngHeader(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height);

} // namespace texloom::test

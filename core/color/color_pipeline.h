#pragma once

#include "core/color/file_color.h"
#include "core/image/image.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// A colour space that files can be in.
struct ColorSpace {
    std::string id;    ///< as recipes and the command line write it: "srgb", "linear", "acescg", "raw"
    std::string title; ///< as the window shows it
};

/// Turns colours from a file's space to the working space, and back, through OpenColorIO with the
/// configuration in resources/color. The working space is sRGB-encoded Rec.709 without an upper bound:
/// distances between encoded values follow what the eye sees, as the sources assume, and an 8-bit sRGB file
/// passes unchanged. Only the first three channels of an image with three or more are colours; a grey image
/// is taken as equal parts of each; further channels (alpha) are never touched. "raw" is data and never
/// touched at all.
namespace color {

const std::vector<ColorSpace>& spaces();

/// Stands, in recipes, for the colours that a file's tags describe; not one of spaces().
inline constexpr const char* kFileSpace = "file";

/// @param id of one of spaces(), or kFileSpace. @throws UsageError that lists the known spaces.
const ColorSpace& findSpace(std::string_view id);

/// Converts in place from a file's space. Exact (nothing is computed) where both spaces are the same.
/// @param check called every few rows; what it throws leaves the image half converted. @throws UsageError if
/// `space` is not known.
void toWorking(Image& image, std::string_view space, const std::function<void()>& check = {});
/// Converts in place to a file's space.
void fromWorking(Image& image, std::string_view space, const std::function<void()>& check = {});
/// Converts in place to what an sRGB screen shows.
void toDisplay(Image& image);

} // namespace color
} // namespace texloom

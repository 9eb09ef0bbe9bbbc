#pragma once

#include "core/color/file_color.h"

#include <optional>
#include <string_view>

namespace texloom {

/// The colours of an ICC profile (ISO 15076-1) that is made of one curve for all channels and a matrix, or of
/// the curve for grey; none for other profiles (printers', CMYK, tables) and damaged ones. Its name is left
/// empty.
std::optional<FileColor> colorOfProfile(std::string_view profile);

} // namespace texloom

#pragma once

#include "core/io/image_file.h"

#include <OpenImageIO/imageio.h>

#include <filesystem>

namespace texloom {

/// Takes what a file's tags say of its colours into `info`: a named space, or ImageFileInfo::color, or a note
/// of what is not converted. Files of Texloom's own say their space themselves.
void takeColorTags(ImageFileInfo& info, const OIIO::ImageSpec& spec, const std::filesystem::path& path);

} // namespace texloom

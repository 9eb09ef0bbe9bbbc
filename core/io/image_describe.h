#pragma once

#include "core/io/image_file.h"

#include <OpenImageIO/imageio.h>

#include <string>

namespace texloom {

/// What a decoder's header says of an image, in Texloom's words. @param format as ImageFileInfo::format
ImageFileInfo describe(const OIIO::ImageSpec& spec, const std::string& format);

} // namespace texloom

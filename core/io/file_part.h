#pragma once

#include "core/io/image_file.h"

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <string>
#include <vector>

namespace texloom {

/// What can be read of a file at once: one of its parts (of an EXR) or pages (of a TIFF), or one layer of it.
struct FilePart {
    std::string name; ///< by which it is chosen; empty where nothing sets it apart
    int index = 0;    ///< of the part
    int firstChannel = 0;
    int channels = 0;
    std::string only = {}; ///< the layer that all its channels are in, which names it as well
};

/// Everything that can be read of a file: each part, and the layers in it where it has several.
std::vector<FilePart> partsOf(OIIO::ImageInput& input);

/// The part of this name, or the first for none. @throws UsageError with the names that there are.
FilePart chosenPart(const std::filesystem::path& path, const std::vector<FilePart>& parts,
                    const std::string& name);

/// Cuts what is known of the whole to a part, and notes what else there is where nobody chose.
void takePart(ImageFileInfo& info, const FilePart& part, const std::vector<FilePart>& parts,
              const std::string& asked);

} // namespace texloom

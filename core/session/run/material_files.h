#pragma once

#include <filesystem>
#include <vector>

namespace texloom {

/// The files of one material, as their names tell.
struct MaterialFiles {
    std::filesystem::path image;             ///< the colours; of a material without any, one of its maps
    std::vector<std::filesystem::path> maps; ///< its companion maps, one file for each kind

    bool operator==(const MaterialFiles&) const = default;
};

/// Sorts picture files into materials: see MapName. Files of the same folder belong together where their
/// bases are the same; of two normal maps the one of OpenGL counts, and packed maps give way to the same maps
/// in files of their own. Pictures that belong to none are materials without maps, unless they are a preview
/// of one, such as bark.png beside bark_color.png. In the order of the files.
std::vector<MaterialFiles> materialsOf(const std::vector<std::filesystem::path>& files);

/// The maps of the same material that lie beside a picture, without those that it has. Looks at the names
/// alone. @param known files that are not to be named again.
std::vector<std::filesystem::path> neighboursOf(const std::filesystem::path& image,
                                                const std::vector<std::filesystem::path>& known);

/// Whether a file's extension is that of a picture that can be read.
bool isPictureName(const std::filesystem::path& file);

/// The pictures in a folder, and in folders in it where it has none itself, in the order of their names.
std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder);

} // namespace texloom

#pragma once

#include "core/image/map_name.h"
#include "core/io/image_file.h"
#include "core/methods/synthesis.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace texloom {

/// An image from a file, with its colours in the working space, ready to be an exemplar.
struct ExemplarFile {
    std::filesystem::path path;
    std::string space; ///< the colour space that its values were taken to be in
    std::string hash;
    ImageFileInfo info;
    std::shared_ptr<const Image> image;
    MapRole role = MapRole::Other; ///< what the file's name says that it holds, or the user
    std::string layer = {};        ///< of the file, as ReadOptions::layer
    MapChannel channel = {};       ///< of the file, where the image is one of several that it packs

    /// File name without its extension, as labels show it.
    std::string name() const { return path.stem().string(); }
};

/// Reads a colour image. Where its alpha is 0, colours become those of what is visible around: see
/// fillHidden(). @param space id of its colour space, or empty to take what the file says.
/// @throws Error, UsageError
ExemplarFile loadExemplar(const std::filesystem::path& path, const std::string& space = {},
                          const std::string& layer = {});

/// Reads an image of data (a normal map, heights): the values stay as they are in the file.
/// @param channel all channels, or one alone. @throws UsageError where the file has no such channel.
ExemplarFile loadData(const std::filesystem::path& path, const std::string& layer = {},
                      const MapChannel& channel = {});

/// Reads the companion maps in a file: one, or of a file whose name says that it packs several, each of them
/// with what it holds. A layer's name counts before the file's. At least one.
std::vector<ExemplarFile> loadCompanions(const std::filesystem::path& path, const std::string& layer = {});

/// What a companion map's layer, or else its file, says by its name that it holds.
MapName companionName(const std::filesystem::path& path, const std::string& layer);

/// Reads an image to be laid out by a map: a colour image as loadExemplar() takes it, but in its file's
/// space where that has a name; one whose name says that it is data as loadData() does.
ExemplarFile loadUnconverted(const std::filesystem::path& path, const std::string& layer = {});

/// Reads a mask: the first channel of a file; pixels where it is 0 are left out.
ExemplarFile loadMask(const std::filesystem::path& path, const std::string& layer = {});

} // namespace texloom

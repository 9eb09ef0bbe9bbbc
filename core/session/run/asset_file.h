#pragma once

#include "core/io/image_file.h"
#include "core/methods/port.h"
#include "core/volume/box.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace texloom {

/// What goes into the ports of methods and comes out of them, as files: images and masks in any format of
/// images, position maps as .exr or .png, models as .safetensors, volumes as .json with .raw or as numbered
/// slices, meshes as .obj, .ply or .gltf.

/// "image", "model" …: a kind as reports and lists write it.
std::string kindId(AssetKind kind);
/// @throws UsageError if there is no such kind.
AssetKind kindFrom(const std::string& id);

/// The kind of what is there; a mask is an image like others.
AssetKind kindOf(const Asset& asset);

/// How large something is, without its pixels or numbers: "84,219 numbers, 330 KiB".
Message sizeText(const Asset& asset);
/// The bytes that it takes in memory; 0 of what makes its voxels when they are asked for.
std::uint64_t bytesOf(const Asset& asset);

/// All files that one of this kind consists of: the one named, and the data of a raw volume, the other
/// slices, the buffers of a .gltf. Only the one named where that cannot be told.
std::vector<std::filesystem::path> filesOf(AssetKind kind, const std::filesystem::path& path);
/// SHA-1 of a file, or, where there are several, of all their SHA-1 in order. @throws Error
std::string assetHash(AssetKind kind, const std::filesystem::path& path);

/// Reads a model, a volume or a mesh. @throws Error, UsageError
Asset readAsset(AssetKind kind, const std::filesystem::path& path, const std::function<void()>& check = {});

/// How something is written.
struct AssetWriteOptions {
    Depth depth = Depth::Bits8;              ///< of images, where their format holds it
    std::string space = "srgb";              ///< of images and volumes; "raw" for data
    Size size;                               ///< of the picture beside it: see keptBox()
    std::int64_t mostVoxels = 1 << 22;       ///< of volumes without end: see keptBox()
    std::string recipe;                      ///< written into what can hold it; empty for none
    std::vector<std::string> exemplarHashes; ///< written into models that do not say theirs
    std::function<void()> check;             ///< called all the while; what it throws leaves no file
};

/// The extension that files of a kind have unless someone wants another, such as ".safetensors".
std::string usualExtension(AssetKind kind);
/// Checks that this kind can be written under this name, before a long run. @throws Error, UsageError
void checkAssetFile(AssetKind kind, const std::filesystem::path& path);
/// The files that writeAsset() would make, `path` itself the last where it is one of them.
std::vector<std::filesystem::path> filesFor(AssetKind kind, const Asset& asset,
                                            const std::filesystem::path& path,
                                            const AssetWriteOptions& options);
/// Writes it: whole or not at all. @throws Error, UsageError
void writeAsset(AssetKind kind, const Asset& asset, const std::filesystem::path& path,
                const AssetWriteOptions& options);

/// No more than this is kept along an axis of a volume that does not end.
inline constexpr int kLongestKeptSide = 512;

/// What is kept of a volume: all of it where it ends, one period where it repeats; else as much of it from
/// the origin on as the picture beside it is wide and high, up to kLongestKeptSide, and as deep as the
/// shorter of these, or as `mostVoxels` allow.
Box keptBox(const VolumeSource& source, Size picture, std::int64_t mostVoxels);

} // namespace texloom

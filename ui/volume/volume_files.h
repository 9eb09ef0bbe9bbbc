#pragma once

#include "core/volume/slice.h"
#include "core/volume/solid_placement.h"

#include <filesystem>
#include <memory>
#include <string>

namespace texloom::ui {

/// A volume, and what is written of it into files that can hold a text.
struct SourceWithRecipe {
    std::shared_ptr<const VolumeSource> source;
    std::string recipe;
};

/// A surface, and how a solid lies in it.
struct PlacedMesh {
    std::shared_ptr<const Mesh> mesh;
    SolidPlacement placement;
};

/// Each writes one thing of a volume, whole or not at all. @return the number of files.
/// @throws Error or UsageError in one sentence
int writeSlice(const SourceWithRecipe& volume, const Plane& plane, Size size,
               const std::filesystem::path& path, JobContext& context);
/// @param path NAME.json for raw numbers, or an image's name for numbered slices.
int writeBox(const SourceWithRecipe& volume, const Box& box, const std::filesystem::path& path,
             JobContext& context);
/// The mesh with its vertices' colours, parted until there is a vertex each `fineness` voxels; 0 leaves it as
/// it is.
int writeMeshColours(const SourceWithRecipe& volume, const PlacedMesh& placed, double fineness,
                     const std::filesystem::path& path, JobContext& context);

} // namespace texloom::ui

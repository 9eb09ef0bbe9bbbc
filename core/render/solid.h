#pragma once

#include "core/render/render.h"
#include "core/volume/block_cache.h"
#include "core/volume/solid_placement.h"

#include <chrono>
#include <optional>

namespace texloom {

/// A picture of a solid on a mesh.
struct SolidPicture {
    Image image;       ///< as rendered() gives it
    bool whole = true; ///< whether all of the solid that is seen was there in time; what was not is grey
};

/// A mesh whose every point has the colour of the solid at its place in space, without places in a texture,
/// lit from all around. Of Look, what is of maps does nothing, but for Shown: Lit, or else the colour alone.
/// @param placement from coordinates of the mesh to voxels. @param patience see BlockCache::at().
/// @throws UsageError where the mesh lies too far out; Cancelled
SolidPicture rendered(const RenderMesh& mesh, const BlockCache& solid, const SolidPlacement& placement,
                      const Environment& light, const Look& look, Size size,
                      std::optional<std::chrono::milliseconds> patience, JobContext& context);

/// How the voxels of a box lie in the block of its proportions: x to the right, y down and z away, as in
/// slices.
SolidPlacement placementIn(const Box& box);
/// The sides of that block: from the first to the last voxel, at least one.
Eigen::Vector3f sidesOf(const Box& box);

} // namespace texloom

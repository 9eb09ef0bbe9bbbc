#pragma once

#include "core/image/image.h"
#include "core/image/map_role.h"
#include "core/image/warp.h"

#include <functional>

namespace texloom {

/// A normal map under a warp: resampled, each vector turned (and mirrored) with the surface it stands
/// on, and made of length 1 again. Three channels or more; x, y and z are stored as (n + 1) / 2, or, where an
/// image has values below 0, as they are. @param role says where green points.
Image placedNormals(
    const ImageView& normals, MapRole role, const Warp& warp, const std::function<void()>& check = [] {});

/// Makes every vector of a normal map 1 long, as blending leaves them shorter. Vectors of length 0 point up.
void renormalize(Image& normals);

/// Turns green about: a map of OpenGL becomes one of DirectX, and the other way round.
void flipGreen(Image& normals);

} // namespace texloom

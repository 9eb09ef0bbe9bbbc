#pragma once

#include "core/image/image.h"
#include "core/image/map_role.h"
#include "core/image/warp.h"

#include <functional>

namespace texloom {

/// A normal map under a warp: resampled, each vector turned (and mirrored) with its surface, and normalised
/// again. Three channels or more; x, y and z are stored as (n + 1) / 2, or, where an image has values below
/// 0, as they are. @param role says where green points.
Image placedNormals(
    const ImageView& normals, MapRole role, const Warp& warp, const std::function<void()>& check = [] {});

/// Turns each vector of a normal map whose pixels were moved, and normalises it. @param stored the map before
/// it was moved, which says how vectors are stored. @param jacobian the partial derivatives of the place that
/// a pixel comes from, as columns; not singular.
void turnNormals(
    Image& normals, const ImageView& stored, MapRole role,
    const std::function<Eigen::Matrix2d(int x, int y)>& jacobian, const std::function<void()>& check = [] {});

/// Normalises every vector of a normal map, as blending leaves them shorter. Vectors of length 0 are made to
/// point up.
void renormalize(Image& normals);

/// Inverts green: an OpenGL map becomes a DirectX map, and vice versa.
void flipGreen(Image& normals);

} // namespace texloom

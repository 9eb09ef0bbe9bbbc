#pragma once

#include "core/image/image.h"
#include "core/image/map_role.h"

#include <functional>

namespace texloom {

/// The depth of relief, in pixels between the lowest and the highest place of a height map (0 to 1), that
/// normals are first made with: this share of the map's longer side.
inline constexpr double kUsualRelief = 0.02;

/// The normal map of a height map, stored as (n + 1) / 2 with green up: n is along (−d ∂h/∂x, d ∂h/∂y, 1)
/// where y points down, by differences of the neighbours on either side; at a border that does not wrap of
/// the pixel and its one neighbour.
/// @param height one channel or the first of several. @param depth d, in pixels for a height of 1.
Image normalsFromHeight(
    const ImageView& height, double depth, Wrap wrap = {}, const std::function<void()>& check = [] {});

/// How a height map and a normal map belong together: n_x / n_z and n_y / n_z against the differences of
/// heights.
struct Relief {
    double depth = 0;     ///< that normalsFromHeight() comes nearest to the normals with, by least squares
    double agreement = 0; ///< the cosine between both fields of slopes, −1 to 1; 0 where one of them is flat
};
Relief reliefOf(
    const ImageView& height, const ImageView& normals, MapRole role, Wrap wrap = {},
    const std::function<void()>& check = [] {});

/// The height map, 0 to 1, that a normal map belongs to, up to its depth: the least-squares solution of
/// ∇h = (−n_x / n_z, n_y / n_z), which is Poisson's equation (Frankot & Chellappa, PAMI 1988, here with
/// differences in place of derivatives, and no flux over borders that do not wrap). Slopes are at most 10.
/// @param role says where green points; stored as (n + 1) / 2, or, with values below 0, as they are.
Image heightFromNormals(
    const ImageView& normals, MapRole role, bool wraps = false, const std::function<void()>& check = [] {});

/// A first guess of roughness from colours: dull where they are dark, smoother where they are bright and
/// pale, as highlights are; within 0.35 and 0.9. A rule of thumb: nothing measures roughness in one photo.
Image roughnessGuess(
    const ImageView& colors, const std::function<void()>& check = [] {});

/// A first guess of ambient occlusion from heights: a place is as dark as its surroundings stand above it,
/// blurred with Gaussians of 2, 4, 8 … px up to a sixteenth of the shorter side, with the mean of them. 1 is
/// open.
Image occlusionGuess(
    const ImageView& height, Wrap wrap = {}, const std::function<void()>& check = [] {});

} // namespace texloom

#pragma once

#include "core/volume/mesh.h"

#include <Eigen/Core>

#include <vector>

namespace texloom {

/// What a material can be shown on without a file.
enum class BasicShape { Plane, Sphere, Cube, Cylinder };

/// A mesh that is ready to be drawn: every vertex has a place in the texture and a tangent.
struct RenderMesh {
    Mesh mesh;
    /// Along growing u, one of length 1 for each vertex; the fourth value is 1 or -1: the side on which
    /// growing v lies, seen along the normal, as glTF has it.
    std::vector<Eigen::Vector4f> tangents;
    float radius = 1; ///< of a sphere around the origin that holds all of it
};

/// A mesh moved to the origin and scaled to a radius of 1. One without places in a texture gets them by
/// projection along the axis that its faces look along most, its longest side as wide as the texture.
/// @throws Error if it has no triangle.
RenderMesh renderMesh(Mesh mesh);

/// A shape of radius 1 or a little less. The texture goes once over a plane and over each face of a cube,
/// twice around a sphere and three times around a cylinder, as high as it is wide on the surface.
RenderMesh renderMesh(BasicShape shape);

/// What of a block is cut away, so that one sees what is inside: nothing, the corner towards the viewer as
/// Camera stands at first, or all on one side of a plane square to an axis.
enum class CutAway { Nothing, Corner, X, Y, Z };

/// A block of these sides in the middle of space, its diagonal 2 long, with a cut through a point of it:
/// what lies beyond the point along x, y and z, or along one of them, is away.
/// @param sides in any unit, each more than 0. @param cut the point, from 0 to 1 along each side.
RenderMesh carvedBlock(const Eigen::Vector3f& sides, CutAway away, const Eigen::Vector3f& cut);

} // namespace texloom

#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace texloom {

/// A surface of triangles, as it is coloured by textures and by volumes.
class Mesh {
public:
    using Triangle = std::array<std::uint32_t, 3>; ///< three vertices
    /// The smallest coordinates of all vertices, and the largest.
    struct Bounds {
        Eigen::Vector3f lowest = Eigen::Vector3f::Zero();
        Eigen::Vector3f highest = Eigen::Vector3f::Zero();
    };

    std::vector<Eigen::Vector3f> positions; ///< of the vertices
    std::vector<Eigen::Vector3f> normals;   ///< one of length 1 for each vertex
    /// One for each vertex, or none: (0, 0) is the top left of a texture and (1, 1) the bottom right.
    std::vector<Eigen::Vector2f> uvs;
    std::vector<Triangle> triangles;

    Bounds bounds() const;
};

} // namespace texloom

#pragma once

#include "core/volume/mesh.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace texloom {

/// Puts a mesh together from what a file holds, and refuses what is wrong with it in a sentence that names
/// the file: numbers that are not finite, indices that lead nowhere, more than can be.
class MeshBuilder {
public:
    /// More of each is refused.
    static constexpr std::size_t kMostVertices = 1U << 25;
    static constexpr std::size_t kMostTriangles = 1U << 25;
    static constexpr std::size_t kMostCorners = 256; ///< of one polygon
    static constexpr float kFarthest = 1e12F;        ///< of coordinates from 0

    /// One corner of a polygon: what the file has for it, by index from 0; normal and uv −1 if nothing.
    struct Corner {
        std::int64_t position = 0, normal = -1, uv = -1;
    };

    /// @param check called now and then; what it throws ends the work.
    MeshBuilder(const std::filesystem::path& path, std::function<void()> check)
        : m_path(path.string()), m_check(std::move(check)) {}

    void addPosition(const Eigen::Vector3f& position);
    /// Of any length; it counts as none if that is 0.
    void addNormal(const Eigen::Vector3f& normal);
    /// @param uv in the mesh's sense: v from the top.
    void addUv(const Eigen::Vector2f& uv);
    std::size_t positions() const { return m_positions.size(); }
    std::size_t normals() const { return m_normals.size(); }
    std::size_t uvs() const { return m_uvs.size(); }
    /// Cuts a polygon into triangles; one that has no area goes.
    void addPolygon(std::span<const Corner> corners);

    /// The mesh: a vertex for each different corner; where a file has no normals, the mean of the faces'
    /// around a position, by their areas. @throws Error if there is no triangle.
    Mesh finish();

private:
    void checkCorner(const Corner& corner) const;
    void addTriangle(const Corner& a, const Corner& b, const Corner& c);
    void clipEars(std::vector<Corner> polygon);

    std::string m_path;
    std::function<void()> m_check;
    std::vector<Eigen::Vector3f> m_positions, m_normals;
    std::vector<Eigen::Vector2f> m_uvs;
    std::vector<std::array<Corner, 3>> m_triangles;
    std::size_t m_withoutArea = 0;
};

} // namespace texloom

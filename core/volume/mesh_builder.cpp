#include "core/volume/mesh_builder.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace texloom {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

/// Polygons between two questions whether to go on.
constexpr std::size_t kTrianglesPerCheck = 4096;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether `point` lies in the triangle that turns left, or on its edge.
bool inside(const Vector2d& point, const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    return cross(b - a, point - a) >= 0 && cross(c - b, point - b) >= 0 && cross(a - c, point - c) >= 0;
}

/// The vector whose direction is a polygon's normal and whose length is twice its area (Newell).
Vector3d areaVector(const std::vector<Vector3d>& corners) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    return sum;
}

/// A polygon of space in the plane that it lies in, so that it turns left.
std::vector<Vector2d> flattened(const std::vector<Vector3d>& corners) {
    const Vector3d normal = areaVector(corners).stableNormalized();
    const Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);
    std::vector<Vector2d> flat;
    for (const Vector3d& corner : corners)
        flat.emplace_back(right.dot(corner - corners[0]), up.dot(corner - corners[0]));
    return flat;
}

/// Whether the corner `at` of what is left of a polygon can be cut off: it is convex and no other lies in it.
bool isEar(const std::vector<Vector2d>& flat, const std::vector<std::size_t>& left, std::size_t at) {
    const std::size_t count = left.size();
    const Vector2d a = flat[left[(at + count - 1) % count]], b = flat[left[at]],
                   c = flat[left[(at + 1) % count]];
    if (cross(b - a, c - b) <= 0)
        return false;
    return std::none_of(left.begin(), left.end(), [&](std::size_t i) {
        const Vector2d& point = flat[i];
        return point != a && point != b && point != c && inside(point, a, b, c);
    });
}

} // namespace

void MeshBuilder::addPosition(const Vector3f& position) {
    if (!(position.cwiseAbs().maxCoeff() <= kFarthest) || !position.allFinite())
        fail("{}: vertex {} lies at ({}, {}, {}); coordinates must be numbers of up to {}.", m_path,
             m_positions.size() + 1, position.x(), position.y(), position.z(), kFarthest);
    if (m_positions.size() >= kMostVertices)
        fail("{} has more than {} vertices; no mesh can have more.", m_path, grouped(kMostVertices));
    m_positions.push_back(position);
}

void MeshBuilder::addNormal(const Vector3f& normal) {
    if (!normal.allFinite())
        fail("{}: normal {} is not a finite vector.", m_path, m_normals.size() + 1);
    if (m_normals.size() >= kMostVertices)
        fail("{} has more than {} normals; no mesh can have more.", m_path, grouped(kMostVertices));
    m_normals.push_back(normal.stableNormalized());
}

void MeshBuilder::addUv(const Eigen::Vector2f& uv) {
    if (!uv.allFinite())
        fail("{}: texture coordinate {} is not a finite pair of numbers.", m_path, m_uvs.size() + 1);
    if (m_uvs.size() >= kMostVertices)
        fail("{} has more than {} texture coordinates; no mesh can have more.", m_path,
             grouped(kMostVertices));
    m_uvs.push_back(uv);
}

void MeshBuilder::checkCorner(const Corner& corner) const {
    const auto missing = [](std::int64_t index, std::size_t count, bool needed) {
        return index >= static_cast<std::int64_t>(count) || index < (needed ? 0 : -1);
    };
    if (missing(corner.position, m_positions.size(), true))
        fail("{}: a face uses vertex {}; there are {}.", m_path, corner.position + 1, m_positions.size());
    if (missing(corner.normal, m_normals.size(), false))
        fail("{}: a face uses normal {}; there are {}.", m_path, corner.normal + 1, m_normals.size());
    if (missing(corner.uv, m_uvs.size(), false))
        fail("{}: a face uses texture coordinate {}; there are {}.", m_path, corner.uv + 1, m_uvs.size());
}

void MeshBuilder::addTriangle(const Corner& a, const Corner& b, const Corner& c) {
    const auto at = [this](const Corner& corner) {
        return m_positions[static_cast<std::size_t>(corner.position)].cast<double>();
    };
    if (!((at(b) - at(a)).cross(at(c) - at(a)).stableNorm() > 0)) {
        ++m_withoutArea;
        return;
    }
    if (m_triangles.size() >= kMostTriangles)
        fail("{} has more than {} triangles; no mesh can have more.", m_path, grouped(kMostTriangles));
    m_triangles.push_back({a, b, c});
}

void MeshBuilder::addPolygon(std::span<const Corner> corners) {
    if (corners.size() > kMostCorners)
        fail("{} has a face of {} corners; faces can have up to {}.", m_path, corners.size(), kMostCorners);
    for (const Corner& corner : corners)
        checkCorner(corner);
    if ((m_triangles.size() + m_withoutArea) % kTrianglesPerCheck == 0)
        m_check();
    if (corners.size() < 3)
        ++m_withoutArea;
    else if (corners.size() == 3)
        addTriangle(corners[0], corners[1], corners[2]);
    else
        clipEars({corners.begin(), corners.end()});
}

/// Meisters, "Polygons have ears" (1975). What is no simple polygon gets triangles, too, whatever they are.
void MeshBuilder::clipEars(std::vector<Corner> polygon) {
    std::vector<Vector3d> corners;
    for (const Corner& corner : polygon)
        corners.emplace_back(m_positions[static_cast<std::size_t>(corner.position)].cast<double>());
    if (!(areaVector(corners).stableNorm() > 0)) {
        ++m_withoutArea;
        return;
    }
    const std::vector<Vector2d> flat = flattened(corners);
    std::vector<std::size_t> left(polygon.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    while (left.size() > 3) {
        std::size_t ear = 0;
        while (ear < left.size() && !isEar(flat, left, ear))
            ++ear;
        ear %= left.size();
        addTriangle(polygon[left[(ear + left.size() - 1) % left.size()]], polygon[left[ear]],
                    polygon[left[(ear + 1) % left.size()]]);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
        if (polygon.size() > 16)
            m_check();
    }
    addTriangle(polygon[left[0]], polygon[left[1]], polygon[left[2]]);
}

namespace {

/// The mean normal of the triangles around each position, by their areas.
std::vector<Vector3f> smoothNormals(const std::vector<Vector3f>& positions,
                                    const std::vector<std::array<MeshBuilder::Corner, 3>>& triangles) {
    std::vector<Vector3d> sums(positions.size(), Vector3d::Zero());
    for (const auto& triangle : triangles) {
        const auto at = [&](int i) {
            return positions[static_cast<std::size_t>(triangle.at(static_cast<std::size_t>(i)).position)]
                .cast<double>();
        };
        const Vector3d area = (at(1) - at(0)).cross(at(2) - at(0));
        for (const MeshBuilder::Corner& corner : triangle)
            sums[static_cast<std::size_t>(corner.position)] += area;
    }
    std::vector<Vector3f> normals;
    normals.reserve(sums.size());
    for (const Vector3d& sum : sums)
        normals.emplace_back(sum.stableNorm() > 0 ? Vector3f(sum.stableNormalized().cast<float>())
                                                  : Vector3f::UnitZ());
    return normals;
}

} // namespace

Mesh MeshBuilder::finish() {
    if (m_triangles.empty())
        fail("{} has no faces with an area ({} without one); there is nothing to see.", m_path,
             m_withoutArea);
    using Corners = std::vector<std::pair<Corner, std::uint32_t*>>;
    const auto hasUv = [](const auto& triangle) {
        return std::all_of(triangle.begin(), triangle.end(), [](const Corner& c) { return c.uv >= 0; });
    };
    const bool uvs = std::all_of(m_triangles.begin(), m_triangles.end(), hasUv);
    Mesh mesh;
    mesh.triangles.resize(m_triangles.size());
    Corners corners;
    corners.reserve(3 * m_triangles.size());
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            Corner corner = m_triangles[t][i];
            corner.uv = uvs ? corner.uv : -1;
            if (corner.normal >= 0 && m_normals[static_cast<std::size_t>(corner.normal)].isZero())
                corner.normal = -1;
            corners.emplace_back(corner, &mesh.triangles[t][i]);
        }
    m_check();
    const auto key = [](const auto& entry) {
        return std::tuple(entry.first.position, entry.first.normal, entry.first.uv);
    };
    std::sort(corners.begin(), corners.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    m_check();
    const std::vector<Vector3f> smooth = smoothNormals(m_positions, m_triangles);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner& corner = corners[i].first;
        if (i == 0 || key(corners[i]) != key(corners[i - 1])) {
            const auto position = static_cast<std::size_t>(corner.position);
            mesh.positions.push_back(m_positions[position]);
            mesh.normals.push_back(corner.normal >= 0 ? m_normals[static_cast<std::size_t>(corner.normal)]
                                                      : smooth[position]);
            if (uvs)
                mesh.uvs.push_back(m_uvs[static_cast<std::size_t>(corner.uv)]);
        }
        *corners[i].second = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    }
    return mesh;
}

} // namespace texloom

#include "core/render/render_mesh.h"

#include "core/base/at.h"
#include "core/base/error.h"
#include "core/base/text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

namespace texloom {

namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector4f;

constexpr float kHalfTurn = std::numbers::pi_v<float>;

struct Vertex {
    Vector3f position, normal;
    Vector2f uv;
};

/// A grid of columns × rows quadrangles, its vertices as `at` gives them for (0, 0) to (1, 1), seen from
/// outside with v downwards.
void addGrid(Mesh& mesh, int columns, int rows, const std::function<Vertex(float s, float t)>& at) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const Vertex vertex = at(static_cast<float>(i) / static_cast<float>(columns),
                                     static_cast<float>(j) / static_cast<float>(rows));
            mesh.positions.push_back(vertex.position);
            mesh.normals.push_back(vertex.normal);
            mesh.uvs.push_back(vertex.uv);
        }
    const auto width = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i) {
            const std::uint32_t corner = first + j * width + i;
            mesh.triangles.push_back({corner, corner + width, corner + 1});
            mesh.triangles.push_back({corner + 1, corner + width, corner + width + 1});
        }
}

/// A square of this half side around `middle`, with `right` and `down` of length 1.
void addSquare(Mesh& mesh, const Vector3f& middle, const Vector3f& right, const Vector3f& down, float half) {
    const Vector3f normal = down.cross(right);
    addGrid(mesh, 1, 1, [&](float s, float t) {
        return Vertex{middle + half * ((2 * s - 1) * right + (2 * t - 1) * down), normal, {s, t}};
    });
}

Mesh sphere() {
    constexpr int kAround = 96, kDown = 48;
    Mesh mesh;
    addGrid(mesh, kAround, kDown, [](float s, float t) {
        const float around = 2 * kHalfTurn * s, down = kHalfTurn * t;
        const Vector3f place(std::sin(down) * std::sin(around), std::cos(down),
                             std::sin(down) * std::cos(around));
        return Vertex{place, place, {2 * s, t}};
    });
    return mesh;
}

Mesh cube() {
    constexpr float kHalf = 0.57F;
    Mesh mesh;
    const Vector3f x = Vector3f::UnitX(), y = Vector3f::UnitY(), z = Vector3f::UnitZ();
    addSquare(mesh, kHalf * z, x, -y, kHalf);
    addSquare(mesh, -kHalf * z, -x, -y, kHalf);
    addSquare(mesh, kHalf * x, -z, -y, kHalf);
    addSquare(mesh, -kHalf * x, z, -y, kHalf);
    addSquare(mesh, kHalf * y, x, z, kHalf);
    addSquare(mesh, -kHalf * y, x, -z, kHalf);
    return mesh;
}

Mesh cylinder() {
    constexpr int kAround = 96;
    constexpr float kRadius = 0.62F, kHalfHeight = 0.78F;
    constexpr float kTimes = 3; // around
    const float tile = 2 * kHalfTurn * kRadius / kTimes;
    Mesh mesh;
    addGrid(mesh, kAround, 1, [&](float s, float t) {
        const float around = 2 * kHalfTurn * s;
        const Vector3f out(std::sin(around), 0, std::cos(around));
        return Vertex{kRadius * out + Vector3f(0, kHalfHeight * (1 - 2 * t), 0),
                      out,
                      {kTimes * s, 2 * kHalfHeight * t / tile}};
    });
    for (const float side : {1.0F, -1.0F})
        addGrid(mesh, kAround, 1, [&](float s, float t) {
            const float around = side * 2 * kHalfTurn * s, radius = kRadius * t;
            const Vector3f place(radius * std::sin(around), side * kHalfHeight, radius * std::cos(around));
            return Vertex{place, {0, side, 0}, {place.x() / tile + 0.5F, side * place.z() / tile + 0.5F}};
        });
    return mesh;
}

/// Gives every triangle vertices of its own, with places in the texture by projection along the axis that it
/// looks along most.
Mesh projected(const Mesh& from) {
    const Mesh::Bounds bounds = from.bounds();
    const float side = std::max((bounds.highest - bounds.lowest).maxCoeff(), 1e-20F);
    Mesh mesh;
    for (const Mesh::Triangle& triangle : from.triangles) {
        const Vector3f normal = (from.positions[triangle[1]] - from.positions[triangle[0]])
                                    .cross(from.positions[triangle[2]] - from.positions[triangle[0]]);
        int axis = 0;
        normal.cwiseAbs().maxCoeff(&axis);
        const float sign = normal[axis] < 0 ? -1.0F : 1.0F;
        for (const std::uint32_t corner : triangle) {
            const Vector3f place = (from.positions[corner] - bounds.lowest) / side;
            const Vector2f uv = axis == 0   ? Vector2f(-sign * place.z(), -place.y())
                                : axis == 1 ? Vector2f(place.x(), sign * place.z())
                                            : Vector2f(sign * place.x(), -place.y());
            mesh.positions.push_back(from.positions[corner]);
            mesh.normals.push_back(from.normals[corner]);
            mesh.uvs.push_back(uv);
        }
        const auto next = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.triangles.push_back({next - 3, next - 2, next - 1});
    }
    return mesh;
}

/// Any direction across a normal.
Vector3f across(const Vector3f& normal) {
    return normal
        .cross(std::abs(normal.y()) < 0.9F ? Vector3f(Vector3f::UnitY()) : Vector3f(Vector3f::UnitX()))
        .normalized();
}

/// Tangents from how the texture lies on the triangles around each vertex.
std::vector<Vector4f> tangentsOf(const Mesh& mesh) {
    std::vector<Vector3f> alongU(mesh.positions.size(), Vector3f::Zero()), alongV = alongU;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vector3f p = mesh.positions[b] - mesh.positions[a], q = mesh.positions[c] - mesh.positions[a];
        const Vector2f s = mesh.uvs[b] - mesh.uvs[a], t = mesh.uvs[c] - mesh.uvs[a];
        const float area = s.x() * t.y() - t.x() * s.y();
        if (area == 0)
            continue;
        const float sign = area < 0 ? -1.0F : 1.0F;
        const Vector3f u = sign * (t.y() * p - s.y() * q), v = sign * (s.x() * q - t.x() * p);
        for (const std::uint32_t corner : {a, b, c}) {
            alongU[corner] += u;
            alongV[corner] += v;
        }
    }
    std::vector<Vector4f> tangents;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vector3f& normal = mesh.normals[i];
        const Vector3f flat = alongU[i] - normal * normal.dot(alongU[i]);
        const Vector3f tangent = flat.norm() > 0 ? Vector3f(flat.normalized()) : across(normal);
        const float side = normal.cross(tangent).dot(alongV[i]) > 0 ? 1.0F : -1.0F;
        tangents.emplace_back(tangent.x(), tangent.y(), tangent.z(), side);
    }
    return tangents;
}

RenderMesh finished(Mesh mesh) {
    RenderMesh made;
    made.tangents = tangentsOf(mesh);
    made.radius = 0;
    for (const Vector3f& position : mesh.positions)
        made.radius = std::max(made.radius, position.norm());
    made.mesh = std::move(mesh);
    return made;
}

/// A block in parts: along each axis it goes up to the cut, and on behind it.
struct Parts {
    std::array<std::array<float, 3>, 3> edges{}; ///< of an axis: where it begins, the cut, where it ends
    CutAway away = CutAway::Nothing;

    /// Whether a part is there; numbers beyond 0 and 1 lie outside.
    bool has(const std::array<int, 3>& part) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (const auto i = static_cast<std::size_t>(part[axis]);
                part[axis] < 0 || part[axis] > 1 || !(edges[axis][i] < edges[axis][i + 1]))
                return false;
        switch (away) {
        case CutAway::Nothing:
            return true;
        case CutAway::Corner:
            return part != std::array<int, 3>{1, 1, 1};
        case CutAway::X:
        case CutAway::Y:
        case CutAway::Z:
            break;
        }
        return part[static_cast<std::size_t>(away) - static_cast<std::size_t>(CutAway::X)] == 0;
    }
};

/// The face of a part on one side of it along an axis.
void addFace(Mesh& mesh, const Parts& parts, const std::array<int, 3>& part, std::size_t axis, int side) {
    const auto edge = [&](std::size_t along, int further) {
        return parts.edges[along][at(part[along] + further)];
    };
    const std::size_t s = (axis + 1) % 3, t = (axis + 2) % 3;
    Vector3f corner, right = Vector3f::Zero(), down = Vector3f::Zero(), normal = Vector3f::Zero();
    const auto index = [](std::size_t number) { return static_cast<Eigen::Index>(number); };
    corner[index(axis)] = edge(axis, side > 0 ? 1 : 0);
    corner[index(s)] = edge(s, 0);
    corner[index(t)] = edge(t, side > 0 ? 1 : 0); // so that it is seen from outside
    right[index(s)] = edge(s, 1) - edge(s, 0);
    down[index(t)] = static_cast<float>(-side) * (edge(t, 1) - edge(t, 0));
    normal[index(axis)] = static_cast<float>(side);
    addGrid(mesh, 1, 1, [&](float u, float v) {
        return Vertex{corner + u * right + v * down, normal, {u, v}};
    });
}

} // namespace

RenderMesh carvedBlock(const Eigen::Vector3f& sides, CutAway away, const Eigen::Vector3f& cut) {
    Parts parts;
    parts.away = away;
    const Vector3f half = sides / sides.norm();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const float place = half[i] * (2 * std::clamp(cut[i], 0.0F, 1.0F) - 1);
        parts.edges[axis] = {-half[i], away == CutAway::Nothing ? half[i] : place, half[i]};
    }
    Mesh mesh;
    for (int number = 0; number < 8; ++number) {
        const std::array<int, 3> part{number & 1, number >> 1 & 1, number >> 2};
        if (!parts.has(part))
            continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                std::array<int, 3> beside = part;
                beside[axis] += side;
                if (!parts.has(beside))
                    addFace(mesh, parts, part, axis, side);
            }
    }
    return finished(std::move(mesh));
}

RenderMesh renderMesh(Mesh mesh) {
    if (mesh.triangles.empty())
        fail("The mesh has no face, so that there is nothing to show a material on; choose another one.");
    if (mesh.uvs.empty())
        mesh = projected(mesh);
    const Mesh::Bounds bounds = mesh.bounds();
    const Vector3f middle = (bounds.lowest + bounds.highest) / 2;
    float radius = 0;
    for (const Vector3f& position : mesh.positions)
        radius = std::max(radius, (position - middle).norm());
    for (Vector3f& position : mesh.positions)
        position = (position - middle) / std::max(radius, 1e-20F);
    return finished(std::move(mesh));
}

RenderMesh renderMesh(BasicShape shape) {
    switch (shape) {
    case BasicShape::Sphere:
        return finished(sphere());
    case BasicShape::Cube:
        return finished(cube());
    case BasicShape::Cylinder:
        return finished(cylinder());
    case BasicShape::Plane:
        break;
    }
    Mesh plane;
    addSquare(plane, Vector3f::Zero(), Vector3f::UnitX(), -Vector3f::UnitY(), 0.9F);
    return finished(std::move(plane));
}

} // namespace texloom

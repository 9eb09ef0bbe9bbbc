#include "core/volume/solid_placement.h"

#include "core/base/at.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/volume/point_samples.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace texloom {

namespace {

double longestEdgeOf(const Mesh& mesh) {
    double longest = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            longest = std::max(longest, static_cast<double>((mesh.positions[p] - mesh.positions[q]).norm()));
    return longest;
}

/// Each triangle in four, by the middles of its edges, which neighbours share.
void part(Mesh& mesh, JobContext& context) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t p, std::uint32_t q) {
        const auto [found, fresh] = middles.try_emplace({std::min(p, q), std::max(p, q)},
                                                        static_cast<std::uint32_t>(mesh.positions.size()));
        if (fresh) {
            mesh.positions.emplace_back((mesh.positions[p] + mesh.positions[q]) / 2);
            const Eigen::Vector3f normal = mesh.normals[p] + mesh.normals[q];
            mesh.normals.emplace_back(normal.norm() > 0 ? Eigen::Vector3f(normal.normalized())
                                                        : mesh.normals[p]);
            if (!mesh.uvs.empty())
                mesh.uvs.emplace_back((mesh.uvs[p] + mesh.uvs[q]) / 2);
        }
        return found->second;
    };
    std::vector<Mesh::Triangle> parts;
    parts.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        if (parts.size() % (1U << 16U) == 0)
            context.check();
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(parts);
}

} // namespace

Eigen::Matrix3d SolidPlacement::rotation() const {
    using Eigen::AngleAxisd, Eigen::Vector3d;
    return (AngleAxisd(angles.z(), Vector3d::UnitZ()) * AngleAxisd(angles.y(), Vector3d::UnitY()) *
            AngleAxisd(angles.x(), Vector3d::UnitX()))
        .toRotationMatrix();
}

std::vector<float> vertexColours(const Mesh& mesh, const VolumeSource& solid, const SolidPlacement& placement,
                                 JobContext& context) {
    if (mesh.triangles.empty())
        failUsage("The mesh has no face that could be coloured; choose another one.");
    if (!(placement.scale > 0) || !std::isfinite(placement.scale))
        failUsage("A scale of {} voxels for a unit of the mesh is none; it must be more than 0.",
                  numberText(placement.scale));
    std::vector<Eigen::Vector3d> points;
    points.reserve(mesh.positions.size());
    const Eigen::Matrix3d turn = placement.scale * placement.rotation();
    for (const Eigen::Vector3f& position : mesh.positions)
        points.emplace_back(placement.offset + turn * position.cast<double>());
    const std::vector<float> values = sampledAt(solid, points, context);
    const std::size_t channels = at(solid.channels());
    std::vector<float> colours;
    colours.reserve(3 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            colours.push_back(values[i * channels + (channels < 3 ? 0 : c)]);
    return colours;
}

Mesh refined(Mesh mesh, double longestEdge, std::size_t most, JobContext& context) {
    while (longestEdgeOf(mesh) > longestEdge && 4 * mesh.triangles.size() <= most) {
        context.check();
        part(mesh, context);
    }
    return mesh;
}

} // namespace texloom

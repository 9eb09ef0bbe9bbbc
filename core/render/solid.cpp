#include "core/render/solid.h"

#include "core/render/lighting.h"
#include "core/render/visibility.h"
#include "core/volume/point_colours.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom {

namespace {

using Eigen::Vector3f;

constexpr float kAwaited = 0.3F;    ///< grey of what is not there yet
constexpr float kRoughness = 0.75F; ///< of solids, which have no map of it

/// The points of a mesh that the samples of a picture show.
class SeenPoints {
public:
    SeenPoints(const RenderMesh& mesh, const Visibility& visibility, const SolidPlacement& placement)
        : m_mesh(mesh.mesh), m_visibility(visibility) {
        const Eigen::Matrix3d turn = placement.scale * placement.rotation();
        const Size size = visibility.size();
        m_numbers.assign(static_cast<std::size_t>(size.area()), kNone);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (const Hit& hit = visibility.at(x, y); hit.any()) {
                    m_numbers[at(x, y)] = m_voxels.size();
                    m_voxels.emplace_back(placement.offset + turn * position(hit).cast<double>());
                }
    }

    const std::vector<Eigen::Vector3d>& voxels() const { return m_voxels; }
    std::size_t number(int x, int y) const { return m_numbers[at(x, y)]; }
    Vector3f position(const Hit& hit) const { return blended(hit, m_mesh.positions); }

    SeenSurface surface(const Hit& hit, const Vector3f& eye, const Vector3f& albedo) const {
        SeenSurface seen;
        seen.normal = blended(hit, m_mesh.normals).normalized();
        seen.toViewer = (eye - position(hit)).normalized();
        if (facesAway(m_mesh, m_mesh.triangles[hit.triangle], seen.normal, seen.toViewer))
            seen.normal = -seen.normal;
        seen.outwards = seen.normal;
        seen.albedo = albedo;
        seen.roughness = kRoughness;
        return seen;
    }

private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_visibility.size().width) +
               static_cast<std::size_t>(x);
    }
    Vector3f blended(const Hit& hit, const std::vector<Vector3f>& vectors) const {
        const auto& [a, b, c] = m_mesh.triangles[hit.triangle];
        return (1 - hit.second - hit.third) * vectors[a] + hit.second * vectors[b] + hit.third * vectors[c];
    }

    const Mesh& m_mesh;
    const Visibility& m_visibility;
    std::vector<std::size_t> m_numbers;
    std::vector<Eigen::Vector3d> m_voxels;
};

} // namespace

SolidPicture rendered(const RenderMesh& mesh, const BlockCache& solid, const SolidPlacement& placement,
                      const Environment& light, const Look& look, Size size,
                      std::optional<std::chrono::milliseconds> patience, JobContext& context) {
    const int samples = std::clamp(look.samples, 1, 4);
    const Visibility visibility(mesh, look.camera, {size.width * samples, size.height * samples}, context);
    const SeenPoints points(mesh, visibility, placement);
    const BlockCache::Samples colours = solid.at(points.voxels(), patience, context);
    const Image albedos = lightOfPoints(colours.values, static_cast<std::size_t>(solid.channels()));
    const Lighting lighting(light, look);
    const Vector3f eye = look.camera.position();
    const auto shade = [&](int x, int y) -> Eigen::Vector4f {
        const Hit& hit = visibility.at(x, y);
        if (!hit.any())
            return lighting.backdrop(x, y, visibility.size());
        const auto point = static_cast<int>(points.number(x, y));
        Vector3f albedo(albedos(point, 0, 0), albedos(point, 0, 1), albedos(point, 0, 2));
        if (std::isnan(albedo.x()))
            albedo.setConstant(kAwaited);
        if (look.shown == Shown::Lit)
            albedo = lighting.reflected(points.surface(hit, eye, albedo));
        return {albedo.x(), albedo.y(), albedo.z(), 1};
    };
    return {meanOfSamples(size, samples, shade, context), colours.whole};
}

SolidPlacement placementIn(const Box& box) {
    SolidPlacement placement;
    // The vertical points down in slices, and what lies behind is at larger z: half a turn about x.
    placement.angles.x() = std::numbers::pi;
    placement.scale = static_cast<double>(sidesOf(box).norm()) / 2;
    const VolumeSize& size = box.size;
    placement.offset =
        Eigen::Vector3d(static_cast<double>(box.x), static_cast<double>(box.y), static_cast<double>(box.z)) +
        Eigen::Vector3d(size.width - 1, size.height - 1, size.depth - 1) / 2;
    return placement;
}

Vector3f sidesOf(const Box& box) {
    const auto side = [](int voxels) { return static_cast<float>(std::max(1, voxels - 1)); };
    return {side(box.size.width), side(box.size.height), side(box.size.depth)};
}

} // namespace texloom

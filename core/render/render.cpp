#include "core/render/render.h"

#include "core/render/lighting.h"
#include "core/render/visibility.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// A point of the surface as it is seen.
struct Point {
    Vector3f position, normal, alongU, alongV, toViewer;
    Vector2f uv;
    float extent = 0; ///< of a pixel in the texture
};

/// The light value that a screen shows as this share of its white, so that data look as they do in a file.
float asShown(float value) {
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

/// Widens a lobe by how much the normals within a pixel differ, which shorten their mean (Toksvig 2005).
float widened(float roughness, float meanLength) {
    const float length = std::clamp(meanLength, 0.05F, 1.0F);
    const float alpha = roughness * roughness;
    return std::min(1.0F, std::sqrt(std::sqrt(alpha * alpha + (1 - length) / length)));
}

class Shader {
public:
    Shader(const RenderMesh& mesh, const MaterialTexture& material, const Environment& light,
           const Look& look, const Visibility& visibility)
        : m_mesh(mesh), m_material(material), m_look(look), m_visibility(visibility), m_lighting(light, look),
          m_eye(look.camera.position()) {}

    /// Colour and opacity of a pixel.
    Eigen::Vector4f at(int x, int y) const {
        const Hit& hit = m_visibility.at(x, y);
        Eigen::Vector4f behind = m_lighting.backdrop(x, y, m_visibility.size());
        if (!hit.any())
            return behind;
        Point point = pointOf(hit, x, y);
        if (m_look.relief > 0 && m_material.hasHeight())
            meetRelief(point);
        const MaterialTexture::Sample sample = m_material.sample(point.uv.x(), point.uv.y(), point.extent);
        const Vector3f colour = m_look.shown == Shown::Lit ? lit(point, sample) : alone(sample);
        const float opacity = m_look.shown == Shown::Opacity ? 1 : sample[MaterialTexture::Opacity];
        Eigen::Vector4f mixed;
        const float alpha = opacity + (1 - opacity) * behind.w();
        mixed.head<3>() =
            (opacity * colour + (1 - opacity) * behind.w() * behind.head<3>()) / std::max(alpha, 1e-6F);
        mixed.w() = alpha;
        return mixed;
    }

private:
    Vector2f uvAt(const Mesh::Triangle& triangle, const std::array<double, 3>& shares) const {
        Vector2f uv = Vector2f::Zero();
        for (std::size_t i = 0; i < 3; ++i)
            uv += static_cast<float>(shares[i]) * m_mesh.mesh.uvs[triangle[i]];
        return m_look.repeat * uv;
    }

    Point pointOf(const Hit& hit, int x, int y) const {
        const Mesh::Triangle& triangle = m_mesh.mesh.triangles[hit.triangle];
        const std::array<float, 3> shares{1 - hit.second - hit.third, hit.second, hit.third};
        Point point;
        point.position = point.normal = point.alongU = Vector3f::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            point.position += shares[i] * m_mesh.mesh.positions[triangle[i]];
            point.normal += shares[i] * m_mesh.mesh.normals[triangle[i]];
            point.alongU += shares[i] * m_mesh.tangents[triangle[i]].head<3>();
        }
        point.toViewer = (m_eye - point.position).normalized();
        point.normal.normalize();
        point.alongU = (point.alongU - point.normal * point.normal.dot(point.alongU)).normalized();
        point.alongV = m_mesh.tangents[triangle[0]].w() * point.normal.cross(point.alongU);
        if (facesAway(m_mesh.mesh, triangle, point.normal, point.toViewer))
            point.normal = -point.normal;
        const SeenTriangle seen = m_visibility.seen(hit.triangle);
        const double column = x + 0.5, row = y + 0.5;
        point.uv = uvAt(triangle, seen.shares(column, row));
        point.extent =
            std::min(1.0F, std::max((uvAt(triangle, seen.shares(column + 1, row)) - point.uv).norm(),
                                    (uvAt(triangle, seen.shares(column, row + 1)) - point.uv).norm()));
        return point;
    }

    /// Moves a point in the texture to where the line of sight meets the heights.
    void meetRelief(Point& point) const {
        constexpr int kFewest = 12, kMost = 64;
        const float out = std::max(point.toViewer.dot(point.normal), 0.08F);
        const Vector2f along(-point.toViewer.dot(point.alongU) / out,
                             -point.toViewer.dot(point.alongV) / out);
        const Vector2f whole = m_look.relief * along; // until the lowest height
        const int steps = std::clamp(static_cast<int>(static_cast<float>(kFewest) / out), kFewest, kMost);
        float before = 1 - m_material.height(point.uv.x(), point.uv.y(), point.extent), depth = 0;
        Vector2f uv = point.uv;
        for (int i = 1; i <= steps && before > depth; ++i) {
            const float nextDepth = static_cast<float>(i) / static_cast<float>(steps);
            const Vector2f next = point.uv + nextDepth * whole;
            const float below = 1 - m_material.height(next.x(), next.y(), point.extent);
            if (below <= nextDepth) { // between here and the step before, as though the ground were straight
                const float share = (before - depth) / std::max(before - depth + nextDepth - below, 1e-6F);
                uv += share * (next - uv);
                break;
            }
            uv = next;
            depth = nextDepth;
            before = below;
        }
        point.uv = uv;
    }

    Vector3f alone(const MaterialTexture::Sample& sample) const {
        using Texture = MaterialTexture;
        const auto grey = [](float value) { return Vector3f(Vector3f::Constant(asShown(value))); };
        switch (m_look.shown) {
        case Shown::Color:
        case Shown::Lit:
            break;
        case Shown::Normal:
            return {asShown(sample[Texture::NormalU] / 2 + 0.5F),
                    asShown(0.5F - sample[Texture::NormalV] / 2),
                    asShown(sample[Texture::NormalOut] / 2 + 0.5F)};
        case Shown::Roughness:
            return grey(sample[Texture::Roughness]);
        case Shown::Metallic:
            return grey(sample[Texture::Metallic]);
        case Shown::Occlusion:
            return grey(sample[Texture::Occlusion]);
        case Shown::Height:
            return grey(sample[Texture::Height]);
        case Shown::Opacity:
            return grey(sample[Texture::Opacity]);
        }
        return {sample[Texture::Red], sample[Texture::Green], sample[Texture::Blue]};
    }

    Vector3f lit(const Point& point, const MaterialTexture::Sample& sample) const {
        using Texture = MaterialTexture;
        const Vector3f bent = sample[Texture::NormalU] * point.alongU +
                              sample[Texture::NormalV] * point.alongV +
                              sample[Texture::NormalOut] * point.normal;
        const float length = bent.norm();
        return m_lighting.reflected({length > 1e-6F ? Vector3f(bent / length) : point.normal,
                                     point.normal,
                                     point.toViewer,
                                     {sample[Texture::Red], sample[Texture::Green], sample[Texture::Blue]},
                                     widened(sample[Texture::Roughness], length),
                                     sample[Texture::Metallic],
                                     sample[Texture::Occlusion]});
    }

    const RenderMesh& m_mesh;
    const MaterialTexture& m_material;
    const Look& m_look;
    const Visibility& m_visibility;
    Lighting m_lighting;
    Vector3f m_eye;
};

} // namespace

Image rendered(const RenderMesh& mesh, const MaterialTexture& material, const Environment& light,
               const Look& look, Size size, JobContext& context) {
    const int samples = std::clamp(look.samples, 1, 4);
    const Visibility visibility(mesh, look.camera, {size.width * samples, size.height * samples}, context);
    const Shader shader(mesh, material, light, look, visibility);
    return meanOfSamples(
        size, samples, [&](int x, int y) { return shader.at(x, y); }, context);
}

} // namespace texloom

#include "core/render/render.h"

#include "core/render/microfacets.h"
#include "core/render/visibility.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kGlass = 0.04F;    ///< what a surface that is no metal reflects when seen straight on
constexpr float kBackdrop = 0.18F; ///< mid-grey
constexpr float kBackdropBlur = 0.3F;

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
        : m_mesh(mesh), m_material(material), m_light(light), m_look(look), m_visibility(visibility),
          m_eye(look.camera.position()), m_axes(look.camera.axes()), m_gain(std::exp2(look.exposure)),
          m_lightTurn(Eigen::AngleAxisf(-look.lightTurn, Vector3f::UnitY()).toRotationMatrix()) {}

    /// Colour and opacity of a pixel.
    Eigen::Vector4f at(int x, int y) const {
        const Hit& hit = m_visibility.at(x, y);
        Eigen::Vector4f behind = beside(x, y);
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
    Vector3f radiance(const Vector3f& direction, float roughness) const {
        return m_gain * m_light.radiance(m_lightTurn * direction, roughness);
    }

    Eigen::Vector4f beside(int x, int y) const {
        if (m_look.backdrop == Backdrop::Nothing)
            return Eigen::Vector4f::Zero();
        if (m_look.backdrop == Backdrop::Grey)
            return {kBackdrop, kBackdrop, kBackdrop, 1};
        const Size size = m_visibility.size();
        const float half = static_cast<float>(std::min(size.width, size.height)) / 2;
        const float right = (static_cast<float>(x) + 0.5F - static_cast<float>(size.width) / 2) / half;
        const float up = (static_cast<float>(size.height) / 2 - static_cast<float>(y) - 0.5F) / half;
        const float open = std::tan(m_look.camera.angle / 2);
        const Vector3f direction = m_axes.transpose() * Vector3f(right * open, up * open, -1).normalized();
        const Vector3f light = radiance(direction, kBackdropBlur);
        return {light.x(), light.y(), light.z(), 1};
    }

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
        if (facesAway(triangle, point))
            point.normal = -point.normal;
        const SeenTriangle seen = m_visibility.seen(hit.triangle);
        const double column = x + 0.5, row = y + 0.5;
        point.uv = uvAt(triangle, seen.shares(column, row));
        point.extent =
            std::min(1.0F, std::max((uvAt(triangle, seen.shares(column + 1, row)) - point.uv).norm(),
                                    (uvAt(triangle, seen.shares(column, row + 1)) - point.uv).norm()));
        return point;
    }

    /// Whether the mesh's normal is on the other side of the triangle than the viewer: then its back is seen.
    bool facesAway(const Mesh::Triangle& triangle, const Point& point) const {
        const Vector3f& corner = m_mesh.mesh.positions[triangle[0]];
        const Vector3f flat =
            (m_mesh.mesh.positions[triangle[1]] - corner).cross(m_mesh.mesh.positions[triangle[2]] - corner);
        return flat.dot(point.normal) * flat.dot(point.toViewer) < 0;
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
        const Vector3f normal = length > 1e-6F ? Vector3f(bent / length) : point.normal;
        const Vector3f albedo(sample[Texture::Red], sample[Texture::Green], sample[Texture::Blue]);
        const float roughness = widened(sample[Texture::Roughness], length);
        const float metallic = sample[Texture::Metallic], occlusion = sample[Texture::Occlusion];
        const float cosine = std::clamp(normal.dot(point.toViewer), 1e-3F, 1.0F);
        const Vector3f straightOn = Vector3f::Constant(kGlass * (1 - metallic)) + metallic * albedo;

        const Reflected once = SplitSum::table().at(cosine, roughness);
        const Vector3f single = straightOn * once.scale + Vector3f::Constant(once.bias);
        const float left = 1 - once.scale - once.bias; // what bounces on between the facets
        const Vector3f mean = straightOn + (Vector3f::Ones() - straightOn) / 21;
        const Vector3f several =
            left * single.cwiseProduct(mean).cwiseQuotient(Vector3f::Ones() - left * mean);
        const Vector3f matt = (1 - metallic) * albedo.cwiseProduct(Vector3f::Ones() - single - several);

        const Vector3f mirrored = 2 * cosine * normal - point.toViewer;
        const float horizon = std::clamp(1 + mirrored.dot(point.normal), 0.0F, 1.0F);
        const Vector3f around = m_gain * m_light.irradiance(m_lightTurn * normal);
        const Vector3f glossy = horizon * horizon * radiance(mirrored.normalized(), roughness);
        return occlusion * ((several + matt).cwiseProduct(around) + single.cwiseProduct(glossy));
    }

    const RenderMesh& m_mesh;
    const MaterialTexture& m_material;
    const Environment& m_light;
    const Look& m_look;
    const Visibility& m_visibility;
    Vector3f m_eye;
    Eigen::Matrix3f m_axes;
    float m_gain;
    Eigen::Matrix3f m_lightTurn;
};

} // namespace

Image rendered(const RenderMesh& mesh, const MaterialTexture& material, const Environment& light,
               const Look& look, Size size, JobContext& context) {
    const int samples = std::clamp(look.samples, 1, 4);
    const Visibility visibility(mesh, look.camera, {size.width * samples, size.height * samples}, context);
    const Shader shader(mesh, material, light, look, visibility);
    Image made(size, 4);
    context.parallel(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            Eigen::Vector4f sum = Eigen::Vector4f::Zero();
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i) {
                    const Eigen::Vector4f one = shader.at(x * samples + i, y * samples + j);
                    sum.head<3>() += one.w() * one.head<3>();
                    sum.w() += one.w();
                }
            if (sum.w() > 0)
                sum.head<3>() /= sum.w();
            for (int c = 0; c < 3; ++c)
                made(x, y, c) = sum[c];
            made(x, y, 3) = sum.w() / static_cast<float>(samples * samples);
        }
    });
    return made;
}

} // namespace texloom

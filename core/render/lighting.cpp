#include "core/render/lighting.h"

#include "core/render/microfacets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

using Eigen::Vector3f;

constexpr float kGlass = 0.04F;    ///< what a surface that is no metal reflects when seen straight on
constexpr float kBackdrop = 0.18F; ///< mid-grey
constexpr float kBackdropBlur = 0.3F;

} // namespace

Lighting::Lighting(const Environment& light, const Look& look)
    : m_light(light), m_look(look), m_axes(look.camera.axes()),
      m_turn(Eigen::AngleAxisf(-look.lightTurn, Vector3f::UnitY()).toRotationMatrix()),
      m_gain(std::exp2(look.exposure)) {}

Vector3f Lighting::radiance(const Vector3f& direction, float roughness) const {
    return m_gain * m_light.radiance(m_turn * direction, roughness);
}

Eigen::Vector4f Lighting::backdrop(int x, int y, Size size) const {
    if (m_look.backdrop == Backdrop::Nothing)
        return Eigen::Vector4f::Zero();
    if (m_look.backdrop == Backdrop::Grey)
        return {kBackdrop, kBackdrop, kBackdrop, 1};
    const float half = static_cast<float>(std::min(size.width, size.height)) / 2;
    const float right = (static_cast<float>(x) + 0.5F - static_cast<float>(size.width) / 2) / half;
    const float up = (static_cast<float>(size.height) / 2 - static_cast<float>(y) - 0.5F) / half;
    const float open = std::tan(m_look.camera.angle / 2);
    const Vector3f direction = m_axes.transpose() * Vector3f(right * open, up * open, -1).normalized();
    const Vector3f light = radiance(direction, kBackdropBlur);
    return {light.x(), light.y(), light.z(), 1};
}

Vector3f Lighting::reflected(const SeenSurface& surface) const {
    const Vector3f& normal = surface.normal;
    const float cosine = std::clamp(normal.dot(surface.toViewer), 1e-3F, 1.0F);
    const Vector3f straightOn =
        Vector3f::Constant(kGlass * (1 - surface.metallic)) + surface.metallic * surface.albedo;

    const Reflected once = SplitSum::table().at(cosine, surface.roughness);
    const Vector3f single = straightOn * once.scale + Vector3f::Constant(once.bias);
    const float left = 1 - once.scale - once.bias; // what bounces on between the facets
    const Vector3f mean = straightOn + (Vector3f::Ones() - straightOn) / 21;
    const Vector3f several = left * single.cwiseProduct(mean).cwiseQuotient(Vector3f::Ones() - left * mean);
    const Vector3f matt =
        (1 - surface.metallic) * surface.albedo.cwiseProduct(Vector3f::Ones() - single - several);

    const Vector3f mirrored = 2 * cosine * normal - surface.toViewer;
    const float horizon = std::clamp(1 + mirrored.dot(surface.outwards), 0.0F, 1.0F);
    const Vector3f around = m_gain * m_light.irradiance(m_turn * normal);
    const Vector3f glossy = horizon * horizon * radiance(mirrored.normalized(), surface.roughness);
    return surface.occlusion * ((several + matt).cwiseProduct(around) + single.cwiseProduct(glossy));
}

Image meanOfSamples(Size size, int samples, const std::function<Eigen::Vector4f(int x, int y)>& at,
                    JobContext& context) {
    Image made(size, 4);
    context.parallel(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            Eigen::Vector4f sum = Eigen::Vector4f::Zero();
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i) {
                    const Eigen::Vector4f one = at(x * samples + i, y * samples + j);
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

bool facesAway(const Mesh& mesh, const Mesh::Triangle& triangle, const Vector3f& normal,
               const Vector3f& toViewer) {
    const Vector3f& corner = mesh.positions[triangle[0]];
    const Vector3f flat = (mesh.positions[triangle[1]] - corner).cross(mesh.positions[triangle[2]] - corner);
    return flat.dot(normal) * flat.dot(toViewer) < 0;
}

} // namespace texloom

#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/render/environment.h"
#include "core/render/look.h"
#include "core/volume/mesh.h"

#include <Eigen/Core>

#include <functional>

namespace texloom {

/// A point of a surface as a viewer sees it; all vectors have length 1.
struct SeenSurface {
    Eigen::Vector3f normal;   ///< of what is lit, such as a bump
    Eigen::Vector3f outwards; ///< of the surface as a whole
    Eigen::Vector3f toViewer;
    Eigen::Vector3f albedo;
    float roughness = 0.6F;
    float metallic = 0;
    float occlusion = 1;
};

/// The light of an environment on surfaces: GGX by the split sum, with the energy of several bounces (Karis
/// 2013; Fdez-Agüera 2019).
class Lighting {
public:
    /// Both must stay.
    Lighting(const Environment& light, const Look& look);

    Eigen::Vector3f reflected(const SeenSurface& surface) const;
    /// What is seen beside the mesh at a pixel, and its opacity.
    Eigen::Vector4f backdrop(int x, int y, Size size) const;

private:
    Eigen::Vector3f radiance(const Eigen::Vector3f& direction, float roughness) const;

    const Environment& m_light;
    const Look& m_look;
    Eigen::Matrix3f m_axes, m_turn;
    float m_gain;
};

/// Calls `at` for every sample of a picture, on several threads, and takes the mean of each pixel's: red,
/// green, blue and opacity, not premultiplied. @param samples along each side of a pixel.
Image meanOfSamples(Size size, int samples, const std::function<Eigen::Vector4f(int x, int y)>& at,
                    JobContext& context);

/// Whether a mesh's normal is on the other side of a triangle than the viewer: then its back is seen.
bool facesAway(const Mesh& mesh, const Mesh::Triangle& triangle, const Eigen::Vector3f& normal,
               const Eigen::Vector3f& toViewer);

} // namespace texloom

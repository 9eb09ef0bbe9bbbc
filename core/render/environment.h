#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace texloom {

/// Light that comes from all around, far away, in linear values of the working space.
class Environment {
public:
    /// From a panorama in latitude and longitude: the left border looks along −z, the middle along z, x to
    /// the right of it, the top up. Negative values and suns beyond `kBrightest` times the mean are cut off;
    /// then it is scaled so that a white surface which looks up and one which looks down shine with 1 on
    /// average.
    /// @throws UsageError if it has fewer than 3 channels or no light.
    Environment(const ImageView& panorama, JobContext& context);

    static constexpr float kBrightest = 200;

    /// What comes from a direction of length 1. @param roughness 0 for the panorama itself, 1 for the widest
    /// lobe of a surface of that roughness around it.
    Eigen::Vector3f radiance(const Eigen::Vector3f& direction, float roughness) const;
    /// The mean over the hemisphere around a normal, by the cosine, which a white matt surface shines with:
    /// by nine spherical harmonics (Ramamoorthi & Hanrahan 2001, eq. 11).
    Eigen::Vector3f irradiance(const Eigen::Vector3f& normal) const;

private:
    void normalise();
    void findHarmonics();
    void blur(JobContext& context);

    Image m_panorama;
    std::vector<Image> m_blurred; ///< for roughness from 0 to 1 in equal steps
    std::array<Eigen::Vector3f, 9> m_harmonics;
};

/// A photographer's studio as a panorama of 3 channels: a grey room with a large light above, one to the
/// left, a strip to the right and a bright floor.
Image studioPanorama();

} // namespace texloom

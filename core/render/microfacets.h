#pragma once

#include <Eigen/Core>

#include <vector>

namespace texloom {

/// The ith of `count` half vectors of a GGX surface around a normal, drawn by how often its microfacets face
/// them (Walter et al. 2007, eq. 35), at the points of Hammersley. @param roughness 0 to 1; its square is
/// GGX's α.
Eigen::Vector3f lobeDirection(int i, int count, float roughness, const Eigen::Vector3f& normal);

/// How much of a white surrounding a GGX surface reflects towards the viewer (Karis 2013, split sum): F₀ ·
/// scale + bias.
struct Reflected {
    float scale = 0;
    float bias = 0;
};

/// The table of it over the cosine of the angle of view and the roughness.
class SplitSum {
public:
    /// The one table of the program; made at its first use, in some milliseconds.
    static const SplitSum& table();
    /// @param cosine of the angle between the normal and the viewer, 0 to 1. @param roughness 0 to 1.
    Reflected at(float cosine, float roughness) const;

private:
    SplitSum();

    std::vector<Reflected> m_values;
};

} // namespace texloom

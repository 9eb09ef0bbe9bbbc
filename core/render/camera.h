#pragma once

#include <Eigen/Core>

namespace texloom {

/// A camera that looks at a point from a distance; lengths are those of RenderMesh.
struct Camera {
    float turn = 0.5F;     ///< around the vertical axis, in radians; 0 looks along −z
    float rise = 0.35F;    ///< above the horizon, in radians, between −π/2 and π/2
    float distance = 3.6F; ///< from `target`
    float angle = 0.6F;    ///< of view, over the shorter side of the picture, in radians
    Eigen::Vector3f target = Eigen::Vector3f::Zero();

    static constexpr float kNearest = 0.05F; ///< what is nearer than this is not drawn

    /// Axes of the camera as rows: right, up and towards the viewer.
    Eigen::Matrix3f axes() const;
    Eigen::Vector3f position() const;
};

} // namespace texloom

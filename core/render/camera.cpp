#include "core/render/camera.h"

#include <Eigen/Geometry>

#include <cmath>

namespace texloom {

Eigen::Matrix3f Camera::axes() const {
    const Eigen::Vector3f back(std::cos(rise) * std::sin(turn), std::sin(rise),
                               std::cos(rise) * std::cos(turn));
    const Eigen::Vector3f right(std::cos(turn), 0, -std::sin(turn));
    Eigen::Matrix3f axes;
    axes.row(0) = right;
    axes.row(1) = back.cross(right);
    axes.row(2) = back;
    return axes;
}

Eigen::Vector3f Camera::position() const {
    return target + distance * axes().row(2).transpose();
}

} // namespace texloom

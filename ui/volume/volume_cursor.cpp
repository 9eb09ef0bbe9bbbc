#include "ui/volume/volume_cursor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom::ui {

namespace {

using Eigen::Vector3d;

Vector3d clamped(const Vector3d& point, const std::optional<Box>& bounds) {
    Vector3d least = Vector3d::Constant(-VolumeCursor::kFarthest),
             most = Vector3d::Constant(VolumeCursor::kFarthest);
    if (bounds) {
        least = Vector3d(static_cast<double>(bounds->x), static_cast<double>(bounds->y),
                         static_cast<double>(bounds->z));
        most = least + Vector3d(bounds->size.width - 1, bounds->size.height - 1, bounds->size.depth - 1);
    }
    return point.cwiseMax(least).cwiseMin(most);
}

} // namespace

void VolumeCursor::reset(const std::optional<Box>& bounds) {
    m_bounds = bounds;
    m_zoom = 1;
    m_middle = Vector3d::Zero();
    if (bounds)
        m_middle = Vector3d(static_cast<double>(bounds->x), static_cast<double>(bounds->y),
                            static_cast<double>(bounds->z)) +
                   Vector3d(bounds->size.width - 1, bounds->size.height - 1, bounds->size.depth - 1) / 2;
    m_cross = m_middle.array().floor();
    Q_EMIT viewMoved();
    Q_EMIT crossMoved();
}

void VolumeCursor::setCross(const Vector3d& voxel) {
    const Vector3d to = clamped(voxel.array().round(), m_bounds);
    if (to == m_cross)
        return;
    m_cross = to;
    Q_EMIT crossMoved();
}

void VolumeCursor::setMiddle(const Vector3d& point) {
    const Vector3d to = clamped(point, m_bounds);
    if (to == m_middle)
        return;
    m_middle = to;
    Q_EMIT viewMoved();
}

void VolumeCursor::setZoom(double zoom) {
    const double to = std::clamp(zoom, kSmallestZoom, kLargestZoom);
    if (to == m_zoom)
        return;
    m_zoom = to;
    Q_EMIT viewMoved();
}

void VolumeCursor::setAngles(double turn, double tilt) {
    constexpr double kWhole = 360;
    m_turn = std::remainder(turn, kWhole);
    m_tilt = std::remainder(tilt, kWhole);
    Q_EMIT turned();
}

Plane VolumeCursor::oblique() const {
    constexpr double kHalfTurn = 180;
    return texloom::turned(axisPlane(Axis::Z, m_cross), m_cross, m_turn * std::numbers::pi / kHalfTurn,
                           m_tilt * std::numbers::pi / kHalfTurn);
}

} // namespace texloom::ui

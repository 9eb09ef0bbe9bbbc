#pragma once

#include "core/volume/slice.h"

#include <QObject>

#include <optional>

namespace texloom::ui {

/// The place in a volume that all its views share: the voxel under the crosshair, what lies in the middle of
/// the slices and how large, and how the oblique plane through the crosshair is turned.
class VolumeCursor : public QObject {
    Q_OBJECT

public:
    static constexpr double kFarthest = 1e9; ///< of coordinates
    static constexpr double kSmallestZoom = 0.125, kLargestZoom = 32;

    using QObject::QObject;

    /// Goes to the middle of another volume, or to the origin of one without end.
    void reset(const std::optional<Box>& bounds);
    const std::optional<Box>& bounds() const { return m_bounds; }

    /// The nearest voxel that there is becomes the crosshair's.
    void setCross(const Eigen::Vector3d& voxel);
    const Eigen::Vector3d& cross() const { return m_cross; } ///< whole numbers
    void setMiddle(const Eigen::Vector3d& point);
    const Eigen::Vector3d& middle() const { return m_middle; }
    /// Points of the screen for each voxel, within limits.
    void setZoom(double zoom);
    double zoom() const { return m_zoom; }
    /// How the oblique plane lies to one square to z, in degrees: see turned().
    void setAngles(double turn, double tilt);
    double turn() const { return m_turn; }
    double tilt() const { return m_tilt; }
    /// The oblique plane, its origin at the crosshair.
    Plane oblique() const;

Q_SIGNALS:
    void crossMoved();
    void viewMoved();
    void turned();

private:
    std::optional<Box> m_bounds;
    Eigen::Vector3d m_cross = Eigen::Vector3d::Zero(), m_middle = Eigen::Vector3d::Zero();
    double m_zoom = 1, m_turn = 45, m_tilt = 0;
};

} // namespace texloom::ui

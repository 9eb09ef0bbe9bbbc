#pragma once

#include "core/volume/slice.h"
#include "ui/jobs/task.h"
#include "ui/picture/display_picture.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <memory>

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace texloom::ui {

class ImageViewer;
class MessageBar;

/// Looks at a volume by one of its planes: square to an axis or turned about the middle of the picture, at
/// any place, with negative coordinates, too, where the volume goes on without end. Slices are made off the
/// GUI thread and shown as ordinary pictures. Page Up and Page Down step through the volume, with Ctrl by ten
/// voxels; Ctrl with the arrow keys moves along the slice by a quarter of the picture.
class SlicePanel : public QWidget {
    Q_OBJECT

public:
    explicit SlicePanel(QWidget* parent = nullptr);
    ~SlicePanel() override;

    /// Looks at another volume, at its middle, or at the origin if it has none; at nothing if null.
    void setSource(std::shared_ptr<const VolumeSource> source);

    /// The plane that is looked at and the size of its picture in pixels.
    Plane plane() const;
    Size pictureSize() const;
    void setAxis(Axis axis);
    /// The voxel in the middle of the picture, within what the volume has.
    void setMiddle(int x, int y, int z);
    std::array<int, 3> middle() const;
    /// In degrees: the plane is turned about the picture's vertical, then tilted about its own horizontal.
    void setAngles(double turn, double tilt);

    ImageViewer* viewer() const { return m_viewer; }
    /// Whether a slice is being made.
    bool busy() const { return m_task.running(); }
    /// Why there is no slice; empty if there is one.
    QString message() const;

Q_SIGNALS:
    /// The picture is that of plane() now, or message() says why there is none.
    void shown();

private:
    void makeFields();
    void layOut();
    void addKeys();
    void fitFields(const VolumeSource& source);
    void step(int voxels);
    void moveAlong(double right, double down);
    void moveBy(const Eigen::Vector3d& distance);
    void makeSlice();

    std::shared_ptr<const VolumeSource> m_source;
    QComboBox* m_axis;
    std::array<QSpinBox*, 3> m_middle;
    QDoubleSpinBox* m_turn;
    QDoubleSpinBox* m_tilt;
    QSpinBox* m_side;
    MessageBar* m_message;
    ImageViewer* m_viewer;
    QTimer m_patience;
    Task<std::shared_ptr<const DisplayPicture>> m_task;
};

} // namespace texloom::ui

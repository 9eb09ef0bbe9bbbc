#pragma once

#include "ui/jobs/task.h"
#include "ui/picture/display_picture.h"
#include "ui/volume/volume_cursor.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <atomic>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

class QSinglePointEvent;

namespace texloom::ui {

/// A slice of a volume, as large as the widget and without end where the volume has none: made off the GUI
/// thread in tiles, only those that are seen, the ones near the crosshair first; what was there stays until
/// they come. Dragging moves along the slice, dragging the crosshair's lines moves it, and a click brings it
/// there; the wheel zooms, with Ctrl it steps through the volume. The arrow keys move along the slice, with
/// Shift the crosshair, Page Up and Page Down step through the volume, with Ctrl by ten voxels; + and − zoom,
/// 1 shows a voxel as a pixel, F brings the crosshair to the middle. The oblique slice turns by Shift and
/// dragging, or Ctrl and the arrow keys.
class SliceView : public QWidget {
    Q_OBJECT

public:
    static constexpr int kTile = 64; ///< pixels on a tile's side

    /// A part of a slice that was made.
    struct Tile {
        std::shared_ptr<const DisplayPicture> values; ///< null where the volume has nothing
        QImage picture;                               ///< transparent where it has nothing
    };

    /// @param axis that the slice is square to; none for the oblique one. @param cursor must stay.
    SliceView(std::optional<Axis> axis, VolumeCursor* cursor, QWidget* parent = nullptr);
    ~SliceView() override;

    /// Looks at another volume, or at none.
    void setSource(std::shared_ptr<const VolumeSource> source);

    /// The slice: its origin is what tiles are counted from, its steps are one voxel long.
    Plane plane() const;
    /// "XY · z = −3".
    QString title() const;
    /// The point in space under a point of the widget, and back: voxels at a whole zoom lie over whole
    /// pixels.
    Eigen::Vector3d spaceAt(QPointF point) const;
    QPointF placeOf(const Eigen::Vector3d& space) const;
    /// The plane whose pixels are what is seen, a pixel each voxel, and their number.
    std::pair<Plane, Size> seen() const;

    /// Whether something that is seen is still to be made.
    bool busy() const { return m_task.running() || m_again.isActive() || !missing().empty(); }
    /// The tile as the slice lies now; null if it is not there. One voxel is `step` pixels.
    const Tile* tile(int i, int j, int step = 1) const;
    /// What is known of a place in the slice, as text; empty if nothing.
    QString valuesAt(const Eigen::Vector3d& space) const;
    /// Voxels from one pixel to the next of what is shown: 1, 2, 4 or 8.
    int step() const;

    QSize sizeHint() const override { return {360, 240}; }
    QSize minimumSizeHint() const override { return {120, 90}; }

Q_SIGNALS:
    /// All that is seen is there.
    void shown();
    void failed(const QString& sentence);
    /// The mouse is at a place; `values` is empty where nothing is known of it.
    void hovered(const Eigen::Vector3d& space, const QString& values);
    void unhovered();
    /// It is to have all the room, or not any more.
    void enlargeWanted();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    using Place = std::tuple<int, std::int64_t, std::int64_t>; ///< step, column, row
    using Key = std::pair<std::int64_t, Place>;                ///< the slice, and where in it
    using Shared = std::shared_ptr<const Tile>;
    struct Shown {
        std::int64_t slice;
        Shared tile;
    };
    enum class Drag { None, Press, View, Across, Down, Cross, Turn };

    std::int64_t slice() const;
    Eigen::Vector2d middle() const;
    QPointF centre() const;
    QPointF pointOf(const QSinglePointEvent& event) const;
    std::vector<Place> wanted() const;
    std::vector<Place> missing() const;
    void planeChanged();
    void makeTiles();
    void take(std::int64_t slice, const std::vector<std::pair<Place, Shared>>& made);
    void forgetUnseen();
    QRect rectOf(const Place& place) const;
    Drag gripAt(QPointF point) const;
    void showGrip(QPointF point);
    void moveView(QPointF distance);
    void zoomAt(QPointF point, double factor);
    void step(int voxels);
    void tellHovered(QPointF point);
    void paintTiles(QPainter& painter) const;
    void paintCross(QPainter& painter) const;
    void paintOblique(QPainter& painter) const;
    void paintTexts(QPainter& painter) const;

    std::optional<Axis> m_axis;
    VolumeCursor* m_cursor;
    std::shared_ptr<const VolumeSource> m_source;
    Eigen::Vector2d m_shift = Eigen::Vector2d::Zero(); ///< of the oblique slice's middle from the crosshair
    std::int64_t m_turns = 0;                          ///< slices that the oblique one was
    std::map<Place, Shown> m_shown;
    mutable std::map<Key, Shared> m_kept;
    std::vector<Key> m_order; ///< of what is kept, as it came
    Drag m_drag = Drag::None;
    QPointF m_dragPoint;
    std::shared_ptr<std::atomic<bool>> m_outdated = std::make_shared<std::atomic<bool>>(false);
    QElapsedTimer m_since;
    QTimer m_again, m_patience;
    bool m_slow = false;
    Task<std::vector<std::pair<Place, Shared>>> m_task;
};

/// The colour of an axis, by which the slices square to it and its lines in others are marked.
QColor axisColor(Axis axis);

} // namespace texloom::ui

#pragma once

#include "ui/viewers/image_viewer.h"

#include <QLineF>

#include <memory>
#include <vector>

namespace texloom::ui {

/// A region of one picture that can be moved over another: what is painted, and its outline.
struct MovableRegion {
    Size picture;                      ///< the size of the picture that the region is of
    std::shared_ptr<const Image> mask; ///< as inRegion() has it; null: middleRegion()
    std::vector<QLineF> outline;       ///< in pixels of that picture
};

/// The outline of a mask's region, or where it is null of the middle. Takes a while for large masks.
MovableRegion movableRegion(Size picture, std::shared_ptr<const Image> mask);

/// A joined picture with the outline of the region that was put into it; the region can be dragged.
class RegionViewer : public ImageViewer {
    Q_OBJECT

public:
    explicit RegionViewer(QWidget* parent = nullptr);

    /// @param offset how far right and down of its place in its own picture the region lies.
    void setRegion(std::shared_ptr<const MovableRegion> region, QPoint offset);
    /// Whether the outline is drawn and can be dragged.
    void setRegionShown(bool shown);

Q_SIGNALS:
    void offsetDragged(QPoint offset);

protected:
    void paintOver(QPainter& painter) const override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    bool isOver(QPointF point) const;

    std::shared_ptr<const MovableRegion> m_region;
    QPoint m_offset, m_grabbed; ///< m_grabbed: the offset when the drag began
    QPointF m_pressed;          ///< in pixels of the picture
    bool m_shown = true;
    bool m_dragging = false;
};

} // namespace texloom::ui

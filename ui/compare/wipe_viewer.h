#pragma once

#include "ui/viewers/image_viewer.h"

#include <memory>

namespace texloom::ui {

/// Shows two pictures in one place, parted by a line. The line is moved by its handle or with Ctrl and the
/// arrow keys, and turned by the knob beside the handle or with Ctrl, Shift and the arrow keys.
class WipeViewer : public ImageViewer {
    Q_OBJECT

public:
    explicit WipeViewer(QWidget* parent = nullptr);

    /// The picture on the far side of the line; without one, the other is whole.
    void setFarPicture(std::shared_ptr<const DisplayPicture> picture);

    /// The direction in which the far side lies, in degrees: 0 is to the right, 90 down.
    double angle() const { return m_angle; }
    /// The handle's place, as shares of the viewer's width and height.
    QPointF place() const { return m_place; }
    void setAngle(double degrees);
    void setPlace(QPointF place);

Q_SIGNALS:
    void lineChanged();

protected:
    void paintOver(QPainter& painter) const override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    enum class Grip { None, Handle, Knob };

    QPointF handle() const;
    QPointF knob() const;
    QPointF normal() const;
    double radius() const;
    Grip gripAt(QPointF point) const;
    bool moveByKey(const QKeyEvent& event);
    void paintLine(QPainter& painter) const;

    std::shared_ptr<const DisplayPicture> m_far;
    double m_angle = 0;
    QPointF m_place{0.5, 0.5};
    Grip m_grip = Grip::None;
};

} // namespace texloom::ui

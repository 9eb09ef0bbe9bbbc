#pragma once

#include "core/match/blend_curve.h"
#include "ui/viewers/image_viewer.h"

namespace texloom::ui {

/// A blended picture with the curve and its band over it; the curve can be dragged.
class CurveViewer : public ImageViewer {
    Q_OBJECT

public:
    explicit CurveViewer(QWidget* parent = nullptr);

    /// @param position from 0 to 1, as BlendCurve::at() takes it. @param band in pixels to either side.
    void setCurve(BlendCurve::Shape shape, double position, int band);
    /// Whether the curve is drawn and can be dragged.
    void setCurveShown(bool shown);

Q_SIGNALS:
    void positionDragged(double position);

protected:
    void paintOver(QPainter& painter) const override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    /// How far a point of the widget lies from the curve, in widget points.
    double distanceTo(QPointF point) const;
    double positionAt(QPointF point) const;
    void paintCurve(QPainter& painter, double offset, bool middle) const;

    BlendCurve::Shape m_shape = BlendCurve::Shape::Horizontal;
    double m_position = 0.5;
    int m_band = 32;
    bool m_shown = true;
    bool m_dragging = false;
};

} // namespace texloom::ui

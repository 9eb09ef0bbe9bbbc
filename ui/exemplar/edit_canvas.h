#pragma once

#include "core/image/exemplar_edit.h"
#include "ui/viewers/image_viewer.h"

#include <QImage>
#include <QPointF>
#include <QRect>

#include <array>

namespace texloom::ui {

/// The viewer on which an exemplar is cropped, rectified and masked. Frames have four corners: drag them, or
/// choose one with N (the next) and move it with the arrow keys, by ten pixels with Ctrl; a loupe shows the
/// corner that moves. The brush paints where the mouse drags, or with the space bar at the cursor that Shift
/// and the arrow keys move. The middle button pans in every tool.
class EditCanvas : public ImageViewer {
    Q_OBJECT

public:
    enum class Tool { Look, Crop, Rectify, Hide, Show };

    explicit EditCanvas(QWidget* parent = nullptr);

    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    /// The frame of the crop, in whole pixels of the picture; not empty, within it.
    QRect cropFrame() const;
    void setCropFrame(const QRect& frame);
    /// Top left, top right, bottom right, bottom left; kept within the picture.
    const std::array<PlanePoint, 4>& corners() const { return m_corners; }
    void setCorners(const std::array<PlanePoint, 4>& corners);
    /// Diameter in pixels of the picture.
    void setBrushSize(int pixels);
    /// Puts frames back to where they start: a little within the picture.
    void resetFrames();

Q_SIGNALS:
    /// The crop's frame or a corner was moved here.
    void frameMoved();
    /// A brush stroke ended: white where it went, of the picture's size.
    void painted(const QImage& stroke);

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintOver(QPainter& painter) const override;

private:
    bool framing() const { return m_tool == Tool::Crop || m_tool == Tool::Rectify; }
    bool brushing() const { return m_tool == Tool::Hide || m_tool == Tool::Show; }
    int cornerAt(QPointF point) const;
    void moveCorner(int corner, PlanePoint to);
    void dab(QPointF from, QPointF to);
    void finishStroke();
    QPolygonF framePolygon() const;
    void paintFrame(QPainter& painter) const;
    void paintLoupe(QPainter& painter) const;
    void paintStroke(QPainter& painter) const;

    Tool m_tool = Tool::Look;
    std::array<PlanePoint, 4> m_corners{};
    int m_active = 0;      ///< the corner that keys move
    bool m_moving = false; ///< whether the mouse or keys move it now
    int m_brush = 32;
    QImage m_stroke;
    QPointF m_last;
    std::optional<QPointF> m_brushAt;
};

} // namespace texloom::ui

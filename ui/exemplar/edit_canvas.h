#pragma once

#include "core/base/param.h"
#include "ui/exemplar/area_drag.h"
#include "ui/paint/brush.h"
#include "ui/viewers/image_viewer.h"

#include <QImage>
#include <QPointF>

#include <optional>

namespace texloom::ui {

/// The viewer on which an exemplar gets a frame or a mask. A frame is an area, or points joined by lines:
/// drag its corners, or choose one with N (the next) and move it with the arrow keys, by ten pixels with
/// Ctrl; a loupe shows the corner that moves. An area is drawn by dragging outside it, moved by dragging in
/// it and at its edges; Shift makes it a square. Enter says that the frame is as wanted, Esc leaves it. The
/// brush paints where the mouse drags, or with the space bar at the cursor that Shift and the arrow keys
/// move. The middle button always pans.
class EditCanvas : public ImageViewer {
    Q_OBJECT

public:
    enum class Mode { Look, Area, Points, Hide, Show };

    explicit EditCanvas(QWidget* parent = nullptr);

    /// Looks, hides or shows.
    void setMode(Mode mode);
    /// Puts a frame for a parameter, an area or points, where it starts: a little within the picture.
    void setFrameFor(const Param& param);
    Mode mode() const { return m_mode; }
    /// The frame as the parameter's value: an area in whole pixels, not empty, or points, within the picture.
    Value frame() const;
    void setFrame(const Value& frame);
    /// Its corners: of an area top left, top right, bottom right, bottom left.
    const PlanePoints& corners() const { return m_corners; }
    /// Diameter in pixels of the picture.
    void setBrushSize(int pixels);
    /// The width of areas by their height; 0 for any. The area that is there follows.
    void setRatio(double ratio);
    /// Puts frames back to where they start: a little within the picture.
    void resetFrames();

Q_SIGNALS:
    /// The frame or a corner of it was moved here.
    void frameMoved();
    /// The frame is as wanted, or not wanted any more.
    void accepted();
    void left();
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
    bool framing() const { return m_mode == Mode::Area || m_mode == Mode::Points; }
    bool brushing() const { return m_mode == Mode::Hide || m_mode == Mode::Show; }
    void setArea(const Wholes& area);
    QRectF areaRect() const;
    void setAreaRect(const QRectF& area);
    bool pressFrame(QPointF point);
    void dragFrame(const QMouseEvent& event);
    void showCursorAt(QPointF point);
    bool frameKey(const QKeyEvent& event);
    int cornerAt(QPointF point) const;
    void moveCorner(int corner, PlanePoint to);
    void finishStroke();
    QPolygonF framePolygon() const;
    void paintFrame(QPainter& painter) const;
    void paintLoupe(QPainter& painter) const;

    Mode m_mode = Mode::Look;
    PlanePoints m_corners = PlanePoints(4);
    int m_active = 0;      ///< the corner that keys move
    bool m_moving = false; ///< whether the mouse or keys move it now
    std::optional<AreaDrag> m_drag;
    double m_ratio = 0;
    Brush m_brush;
};

} // namespace texloom::ui

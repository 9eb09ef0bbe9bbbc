#pragma once

#include "core/base/value.h"
#include "ui/paint/brush.h"
#include "ui/viewers/image_viewer.h"

namespace texloom::ui {

/// The viewer on which a mask or labels are painted. The brush paints where the mouse drags, the lasso around
/// what it drags about, the rectangle from corner to corner, and the polygon gets a corner at each click
/// until a double click; two further tools point at a pixel. With keys: Shift and the arrow keys move a
/// cursor, the space bar dabs there, points or sets a corner, Enter closes a shape, Backspace takes its last
/// corner back and Escape the whole of it. Alt takes away what is otherwise added, and the other way round,
/// or picks. The middle button pans.
class PaintCanvas : public ImageViewer {
    Q_OBJECT

public:
    enum class Tool { Brush, Lasso, Polygon, Rectangle, Fill, Pick };

    explicit PaintCanvas(QWidget* parent = nullptr);

    Tool tool() const { return m_tool; }
    void setTool(Tool tool);
    /// Whether shapes are taken away from what is painted, rather than added.
    void setTakesAway(bool takesAway) { m_takesAway = takesAway; }
    /// Diameter in pixels of the picture.
    void setBrushSize(int pixels);
    int brushSize() const { return m_brush.width(); }
    /// Shows what is painted as a veil over the picture. @param veil premultiplied, of the picture's size.
    void setVeil(const QImage& veil);
    const QImage& veil() const { return m_veil; }
    /// How much the veil hides of the picture, from 0 to 1.
    void setVeilOpacity(double opacity);
    /// The colour of a stroke under way that adds.
    void setTint(const QColor& tint);
    /// Whether Alt picks, as Tool::Pick does, rather than taking away.
    void setAltPicks(bool picks) { m_altPicks = picks; }

Q_SIGNALS:
    /// A stroke of the brush is to be added or taken away: white where it went, of the picture's size.
    void stroked(const QImage& stroke, bool add);
    /// What these corners enclose is to be added or taken away.
    void outlined(const texloom::PlanePoints& corners, bool add);
    /// A pixel of the picture was pointed at, to fill from there or to pick what is painted there.
    void pointed(QPoint pixel, texloom::ui::PaintCanvas::Tool tool);

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintOver(QPainter& painter) const override;

private:
    void begin(Qt::KeyboardModifiers keys);
    bool points(Qt::KeyboardModifiers keys) const;
    void point(QPointF at, Qt::KeyboardModifiers keys);
    void addCorner(QPointF at, Qt::KeyboardModifiers keys);
    void closeShape();
    void dropShape();
    bool shapeKey(int key);
    void spaceKey(Qt::KeyboardModifiers keys);
    QPolygonF outline() const;
    void paintOutline(QPainter& painter) const;

    Tool m_tool = Tool::Brush;
    bool m_takesAway = false;
    bool m_adds = true;      ///< what the shape under way does
    bool m_dragging = false; ///< whether the mouse draws it
    Brush m_brush;
    QPolygonF m_corners; ///< of the shape under way, in pixels of the picture
    QPointF m_last;      ///< where the mouse or the cursor is
    QImage m_veil;
    double m_veilOpacity = 1;
    QColor m_tint;
    bool m_altPicks = false;
};

} // namespace texloom::ui

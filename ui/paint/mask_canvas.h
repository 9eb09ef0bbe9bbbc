#pragma once

#include "core/base/value.h"
#include "ui/paint/brush.h"
#include "ui/viewers/image_viewer.h"

namespace texloom::ui {

/// The viewer on which a mask is painted. The brush paints where the mouse drags, the lasso around what it
/// drags about, the rectangle from corner to corner, and the polygon gets a corner at each click until a
/// double click. With keys: Shift and the arrow keys move a cursor, the space bar dabs there or sets a
/// corner, Enter closes a shape, Backspace takes its last corner back and Escape the whole of it. Alt takes
/// away what is otherwise added, and the other way round. The middle button pans.
class MaskCanvas : public ImageViewer {
    Q_OBJECT

public:
    enum class Tool { Brush, Lasso, Polygon, Rectangle };

    explicit MaskCanvas(QWidget* parent = nullptr);

    Tool tool() const { return m_tool; }
    void setTool(Tool tool);
    /// Whether shapes are taken away from what is painted, rather than added.
    void setTakesAway(bool takesAway) { m_takesAway = takesAway; }
    /// Diameter in pixels of the picture.
    void setBrushSize(int pixels);
    int brushSize() const { return m_brush.width(); }
    /// Shows what is painted as a veil over the picture. @param veil as veilOf() makes it.
    void setVeil(const QImage& veil);
    /// A selection as a veil, the denser the more it is selected. Called on a worker.
    static QImage veilOf(const Image& selection);
    /// The veil's colour, for a legend.
    static QColor veilColor();

Q_SIGNALS:
    /// A stroke of the brush is to be added or taken away: white where it went, of the picture's size.
    void stroked(const QImage& stroke, bool add);
    /// What these corners enclose is to be added or taken away.
    void outlined(const texloom::PlanePoints& corners, bool add);

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
};

} // namespace texloom::ui

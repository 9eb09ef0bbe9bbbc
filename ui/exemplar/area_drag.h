#pragma once

#include "core/image/size.h"

#include <QPointF>
#include <QRectF>

namespace texloom::ui {

/// How a rectangle on a picture changes while the mouse drags at it: by an edge, by a corner, as a whole, or
/// as a new one that is drawn. In pixels of the picture, in which it stays.
class AreaDrag {
public:
    /// Edges that are held; two that meet are a corner, all of them the rectangle as a whole.
    enum Edge { None = 0, Left = 1, Top = 2, Right = 4, Bottom = 8, All = 15 };

    /// What a point takes hold of: edges within reach, all of them inside, none outside.
    static int heldAt(const QRectF& area, QPointF point, double reach);
    /// The two edges of a corner, counted from the top left one clockwise.
    static int edgesOf(int corner);

    /// @param held as of heldAt(); none draws a new rectangle. @param from where the mouse was pressed.
    AreaDrag(const QRectF& area, int held, QPointF from, Size picture);

    int held() const { return m_held; }
    /// The rectangle before the drag.
    const QRectF& before() const { return m_area; }
    /// The rectangle with the mouse at a point, its corners on whole pixels, never empty.
    /// @param ratio its width by its height; 0 for any.
    QRectF movedTo(QPointF point, double ratio) const;

    /// The rectangle brought to a ratio: about its middle, no larger than it was on one side, in the picture.
    static QRectF withRatio(const QRectF& area, double ratio);

private:
    QRectF drawn(QPointF anchor, QPointF point, double ratio) const;
    QRectF edgeMoved(QPointF point, double ratio) const;

    QRectF m_area;
    int m_held;
    QPointF m_from;
    QSizeF m_picture;
};

} // namespace texloom::ui

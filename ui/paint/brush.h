#pragma once

#include "core/base/param.h"
#include "core/image/image.h"
#include "ui/viewers/view_transform.h"

#include <QColor>
#include <QImage>
#include <QPointF>

#include <optional>

class QPainter;

namespace texloom::ui {

/// The width of a brush as a setting, in pixels of the picture.
const Param& brushWidth();

/// What was painted, a picture of Format_Alpha8, as one channel: 1 where it is not 0.
Image shapeOf(const QImage& painted);

/// The round brush with which canvases are painted on: where it is, and the stroke under way.
class Brush {
public:
    /// @param pixels of the picture, at least 1.
    void setWidth(int pixels);
    int width() const { return m_width; }

    /// Whether a stroke is under way.
    bool stroking() const { return !m_stroke.isNull(); }
    /// Begins a stroke with a dab. @param picture the size of what is painted on; points are in its pixels.
    void begin(Size picture, QPointF at);
    /// Moves the brush, which draws the stroke on if there is one.
    void moveTo(QPointF at);
    /// The mouse is away: the brush shows no more.
    void leave() { m_at.reset(); }
    /// Ends the stroke: white where it went, Format_Alpha8, of the picture's size.
    QImage finish();

    /// Draws the stroke and the brush's outline. @param tint of the stroke. @param otherwise where the brush
    /// is while the mouse is away.
    void paint(QPainter& painter, const ViewTransform& view, QColor tint,
               std::optional<QPointF> otherwise) const;

private:
    void dab(QPointF from, QPointF to);

    int m_width = 32;
    QImage m_stroke;
    QPointF m_last;
    std::optional<QPointF> m_at;
};

} // namespace texloom::ui

#include "ui/blend/curve_viewer.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace texloom::ui {

CurveViewer::CurveViewer(QWidget* parent) : ImageViewer(parent) {}

void CurveViewer::setCurve(BlendCurve::Shape shape, double position, int band) {
    m_shape = shape;
    m_position = position;
    m_band = band;
    update();
}

void CurveViewer::setCurveShown(bool shown) {
    m_shown = shown;
    update();
}

double CurveViewer::positionAt(QPointF point) const {
    const QPointF at = view().toImage(point);
    const Size size = picture()->size();
    double position = at.y() / size.height;
    if (m_shape == BlendCurve::Shape::Vertical)
        position = at.x() / size.width;
    else if (m_shape == BlendCurve::Shape::Circular)
        position = 1 - std::hypot(size.width - at.x(), size.height - at.y()) / size.shorterSide();
    return std::clamp(position, 0.0, 1.0);
}

double CurveViewer::distanceTo(QPointF point) const {
    const Size size = picture()->size();
    const int length = m_shape == BlendCurve::Shape::Horizontal ? size.height
                       : m_shape == BlendCurve::Shape::Vertical ? size.width
                                                                : size.shorterSide();
    return std::abs(positionAt(point) - m_position) * length * view().scale();
}

void CurveViewer::mousePressEvent(QMouseEvent* event) {
    m_dragging = event->button() == Qt::LeftButton && m_shown && picture() &&
                 distanceTo(event->position()) < fontMetrics().height();
    if (!m_dragging)
        ImageViewer::mousePressEvent(event);
}

void CurveViewer::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) {
        Q_EMIT positionDragged(positionAt(event->position()));
        return;
    }
    ImageViewer::mouseMoveEvent(event);
    if (event->buttons() != Qt::NoButton || !picture())
        return;
    if (m_shown && distanceTo(event->position()) < fontMetrics().height() / 2.0)
        setCursor(m_shape == BlendCurve::Shape::Horizontal ? Qt::SplitVCursor
                  : m_shape == BlendCurve::Shape::Vertical ? Qt::SplitHCursor
                                                           : Qt::SizeFDiagCursor);
    else
        unsetCursor();
}

void CurveViewer::mouseReleaseEvent(QMouseEvent* event) {
    m_dragging = false;
    ImageViewer::mouseReleaseEvent(event);
}

void CurveViewer::paintOver(QPainter& painter) const {
    if (!m_shown || !picture())
        return;
    const Size size = picture()->size();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(QRectF(view().toWidget({0, 0}), QSizeF(size.width, size.height) * view().scale()));
    for (const int side : {-1, 1})
        paintCurve(painter, side * m_band, false);
    paintCurve(painter, 0, true);
    painter.restore();
}

/// @param offset to the right of the curve, in pixels.
void CurveViewer::paintCurve(QPainter& painter, double offset, bool middle) const {
    constexpr int kPoints = 48;
    const BlendCurve curve = BlendCurve::at(m_shape, m_position, picture()->size());
    QPainterPath path;
    for (int i = 0; i <= kPoints; ++i) {
        const BlendCurve::Point at = curve.pointAt({curve.length() * i / kPoints, offset});
        const QPointF point = view().toWidget({at.x, at.y});
        if (i == 0)
            path.moveTo(point);
        else
            path.lineTo(point);
    }
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.0);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), width * 2.6));
    painter.drawPath(path);
    painter.setPen(QPen(Qt::white, width, middle ? Qt::SolidLine : Qt::DotLine));
    painter.drawPath(path);
}

} // namespace texloom::ui

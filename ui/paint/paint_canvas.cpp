#include "ui/paint/paint_canvas.h"

#include "ui/viewers/viewer_keys.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kFewestCorners = 3; ///< of what encloses anything

PlanePoints cornersOf(const QPolygonF& polygon) {
    PlanePoints corners;
    for (const QPointF& point : polygon)
        corners.push_back({point.x(), point.y()});
    return corners;
}

/// The rectangle of whole pixels that two of its corners lie in.
QPolygonF wholeRectangle(QPointF a, QPointF b) {
    const double left = std::floor(std::min(a.x(), b.x())), right = std::floor(std::max(a.x(), b.x())) + 1,
                 top = std::floor(std::min(a.y(), b.y())), bottom = std::floor(std::max(a.y(), b.y())) + 1;
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

} // namespace

PaintCanvas::PaintCanvas(QWidget* parent) : ImageViewer(parent) {
    setObjectName(QStringLiteral("paintCanvas"));
    setCursor(Qt::CrossCursor);
}

void PaintCanvas::setTool(Tool tool) {
    m_tool = tool;
    dropShape();
}

void PaintCanvas::setBrushSize(int pixels) {
    m_brush.setWidth(pixels);
    update();
}

void PaintCanvas::setVeil(const QImage& veil) {
    m_veil = veil;
    update();
}

void PaintCanvas::setVeilOpacity(double opacity) {
    m_veilOpacity = opacity;
    update();
}

void PaintCanvas::setTint(const QColor& tint) {
    m_tint = tint;
    update();
}

/// Whether the tool, with these keys, points at a pixel rather than drawing a shape.
bool PaintCanvas::points(Qt::KeyboardModifiers keys) const {
    const bool picks = m_altPicks && keys.testFlag(Qt::AltModifier) && m_corners.isEmpty();
    return picks || m_tool == Tool::Fill || m_tool == Tool::Pick;
}

void PaintCanvas::point(QPointF at, Qt::KeyboardModifiers keys) {
    const QPoint pixel(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
    setFocus(Qt::MouseFocusReason);
    const Size size = picture()->size();
    const bool picks = m_tool == Tool::Pick || (m_altPicks && keys.testFlag(Qt::AltModifier));
    if (QRect(0, 0, size.width, size.height).contains(pixel))
        Q_EMIT pointed(pixel, picks ? Tool::Pick : Tool::Fill);
}

void PaintCanvas::begin(Qt::KeyboardModifiers keys) {
    m_adds = m_takesAway == (keys.testFlag(Qt::AltModifier) && !m_altPicks);
    setFocus(Qt::MouseFocusReason);
}

void PaintCanvas::addCorner(QPointF at, Qt::KeyboardModifiers keys) {
    if (m_corners.isEmpty())
        begin(keys);
    m_corners << at;
    m_last = at;
    if (m_tool == Tool::Rectangle && m_corners.size() == 2)
        return closeShape();
    update();
}

void PaintCanvas::closeShape() {
    const QPolygonF corners = std::exchange(m_corners, {});
    m_dragging = false;
    update();
    if (m_tool == Tool::Rectangle && corners.size() == 2)
        Q_EMIT outlined(cornersOf(wholeRectangle(corners[0], corners[1])), m_adds);
    else if (m_tool != Tool::Rectangle && corners.size() >= kFewestCorners)
        Q_EMIT outlined(cornersOf(corners), m_adds);
}

void PaintCanvas::dropShape() {
    m_corners.clear();
    m_brush.finish();
    m_dragging = false;
    update();
}

bool PaintCanvas::event(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        m_brush.leave();
        update();
    }
    return ImageViewer::event(event);
}

void PaintCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !picture())
        return ImageViewer::mousePressEvent(event);
    const QPointF at = view().toImage(event->position());
    if (points(event->modifiers())) {
        point(at, event->modifiers());
    } else if (m_tool == Tool::Brush) {
        begin(event->modifiers());
        m_brush.begin(picture()->size(), at);
        update();
    } else if (m_tool == Tool::Polygon) {
        addCorner(at, event->modifiers());
    } else {
        m_corners.clear();
        addCorner(at, event->modifiers());
        m_dragging = true;
    }
}

void PaintCanvas::mouseMoveEvent(QMouseEvent* event) {
    m_last = view().toImage(event->position());
    if (m_tool == Tool::Brush)
        m_brush.moveTo(m_last);
    if (m_tool == Tool::Lasso && m_dragging)
        m_corners << m_last;
    update();
    if (!m_dragging && !m_brush.stroking())
        ImageViewer::mouseMoveEvent(event);
}

void PaintCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (m_brush.stroking()) {
        const QImage stroke = m_brush.finish();
        update();
        Q_EMIT stroked(stroke, m_adds);
    } else if (m_dragging) {
        if (m_tool == Tool::Rectangle)
            m_corners << view().toImage(event->position());
        closeShape();
    } else {
        ImageViewer::mouseReleaseEvent(event);
    }
    setCursor(Qt::CrossCursor);
}

void PaintCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_tool == Tool::Polygon && !m_corners.isEmpty())
        return closeShape();
    mousePressEvent(event);
}

/// What a key does to the shape under way.
bool PaintCanvas::shapeKey(int key) {
    if (m_corners.isEmpty() && !m_brush.stroking())
        return false;
    switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        closeShape();
        return true;
    case Qt::Key_Escape:
        dropShape();
        return true;
    case Qt::Key_Backspace:
        if (!m_corners.isEmpty())
            m_corners.removeLast();
        update();
        return true;
    default:
        return false;
    }
}

void PaintCanvas::spaceKey(Qt::KeyboardModifiers keys) {
    if (points(keys))
        return point(*cursorMiddle(), keys);
    if (m_tool != Tool::Brush)
        return addCorner(*cursorMiddle(), keys);
    begin(keys);
    m_brush.begin(picture()->size(), *cursorMiddle());
    const QImage dab = m_brush.finish();
    update();
    Q_EMIT stroked(dab, m_adds);
}

void PaintCanvas::keyPressEvent(QKeyEvent* event) {
    if (!picture() || shapeKey(event->key()))
        return;
    if (event->key() == Qt::Key_Space && cursorPixel())
        return spaceKey(event->modifiers());
    const std::optional<ViewerCommand> command = viewerCommandAt(*event);
    if (command == ViewerCommand::Repeat || command == ViewerCommand::Seams)
        return event->ignore(); // nothing is painted on the copies
    ImageViewer::keyPressEvent(event);
    if (cursorPixel())
        m_last = *cursorMiddle();
}

/// The shape under way, to where the mouse or the cursor is, in points of the widget.
QPolygonF PaintCanvas::outline() const {
    QPolygonF shape = m_corners;
    if (m_tool == Tool::Rectangle && !shape.isEmpty())
        shape = wholeRectangle(shape[0], m_last);
    else if (!shape.isEmpty())
        shape << m_last;
    for (QPointF& point : shape)
        point = view().toWidget(point);
    return shape;
}

void PaintCanvas::paintOutline(QPainter& painter) const {
    const QPolygonF shape = outline();
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.5);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [color, share] : {std::pair(Qt::black, 3.0), std::pair(Qt::white, 1.0)}) {
        painter.setPen(QPen(color, width * share, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolygon(shape);
    }
}

void PaintCanvas::paintOver(QPainter& painter) const {
    painter.save();
    const Size size = picture()->size();
    painter.setOpacity(m_veilOpacity);
    if (!m_veil.isNull())
        painter.drawImage(QRectF(view().origin(), QSizeF(size.width, size.height) * view().scale()), m_veil);
    painter.setOpacity(1);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOutline(painter);
    if (m_tool == Tool::Brush)
        m_brush.paint(painter, view(), m_adds ? m_tint : QColor(255, 255, 255, 120), cursorMiddle());
    painter.restore();
}

} // namespace texloom::ui

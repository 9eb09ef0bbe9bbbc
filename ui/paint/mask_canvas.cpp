#include "ui/paint/mask_canvas.h"

#include "ui/viewers/viewer_keys.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>
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

MaskCanvas::MaskCanvas(QWidget* parent) : ImageViewer(parent) {
    setObjectName(QStringLiteral("maskCanvas"));
    setCursor(Qt::CrossCursor);
}

QColor MaskCanvas::veilColor() {
    return {255, 0, 110, 140};
}

QImage MaskCanvas::veilOf(const Image& selection) {
    constexpr int kWhole = 255;
    std::array<QRgb, kWhole + 1> colors{};
    const QColor color = veilColor();
    for (int i = 0; i <= kWhole; ++i)
        colors[static_cast<std::size_t>(i)] =
            qPremultiply(qRgba(color.red(), color.green(), color.blue(), color.alpha() * i / kWhole));
    QImage veil(selection.width(), selection.height(), QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < selection.height(); ++y) {
        const float* const row = selection.plane(0).row(y);
        std::transform(row, row + selection.width(), reinterpret_cast<QRgb*>(veil.scanLine(y)),
                       [&colors](float value) {
                           const float share = std::clamp(value, 0.0F, 1.0F);
                           return colors[static_cast<std::size_t>(std::lround(share * kWhole))];
                       });
    }
    return veil;
}

void MaskCanvas::setTool(Tool tool) {
    m_tool = tool;
    dropShape();
}

void MaskCanvas::setBrushSize(int pixels) {
    m_brush.setWidth(pixels);
    update();
}

void MaskCanvas::setVeil(const QImage& veil) {
    m_veil = veil;
    update();
}

void MaskCanvas::begin(Qt::KeyboardModifiers keys) {
    m_adds = m_takesAway == keys.testFlag(Qt::AltModifier);
    setFocus(Qt::MouseFocusReason);
}

void MaskCanvas::addCorner(QPointF at, Qt::KeyboardModifiers keys) {
    if (m_corners.isEmpty())
        begin(keys);
    m_corners << at;
    m_last = at;
    if (m_tool == Tool::Rectangle && m_corners.size() == 2)
        return closeShape();
    update();
}

void MaskCanvas::closeShape() {
    const QPolygonF corners = std::exchange(m_corners, {});
    m_dragging = false;
    update();
    if (m_tool == Tool::Rectangle && corners.size() == 2)
        Q_EMIT outlined(cornersOf(wholeRectangle(corners[0], corners[1])), m_adds);
    else if (m_tool != Tool::Rectangle && corners.size() >= kFewestCorners)
        Q_EMIT outlined(cornersOf(corners), m_adds);
}

void MaskCanvas::dropShape() {
    m_corners.clear();
    m_brush.finish();
    m_dragging = false;
    update();
}

bool MaskCanvas::event(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        m_brush.leave();
        update();
    }
    return ImageViewer::event(event);
}

void MaskCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !picture())
        return ImageViewer::mousePressEvent(event);
    const QPointF at = view().toImage(event->position());
    if (m_tool == Tool::Brush) {
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

void MaskCanvas::mouseMoveEvent(QMouseEvent* event) {
    m_last = view().toImage(event->position());
    if (m_tool == Tool::Brush)
        m_brush.moveTo(m_last);
    if (m_tool == Tool::Lasso && m_dragging)
        m_corners << m_last;
    update();
    if (!m_dragging && !m_brush.stroking())
        ImageViewer::mouseMoveEvent(event);
}

void MaskCanvas::mouseReleaseEvent(QMouseEvent* event) {
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

void MaskCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_tool == Tool::Polygon && !m_corners.isEmpty())
        return closeShape();
    mousePressEvent(event);
}

/// What a key does to the shape under way.
bool MaskCanvas::shapeKey(int key) {
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

void MaskCanvas::spaceKey(Qt::KeyboardModifiers keys) {
    if (m_tool != Tool::Brush)
        return addCorner(*cursorMiddle(), keys);
    begin(keys);
    m_brush.begin(picture()->size(), *cursorMiddle());
    const QImage dab = m_brush.finish();
    update();
    Q_EMIT stroked(dab, m_adds);
}

void MaskCanvas::keyPressEvent(QKeyEvent* event) {
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
QPolygonF MaskCanvas::outline() const {
    QPolygonF shape = m_corners;
    if (m_tool == Tool::Rectangle && !shape.isEmpty())
        shape = wholeRectangle(shape[0], m_last);
    else if (!shape.isEmpty())
        shape << m_last;
    for (QPointF& point : shape)
        point = view().toWidget(point);
    return shape;
}

void MaskCanvas::paintOutline(QPainter& painter) const {
    const QPolygonF shape = outline();
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.5);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [color, share] : {std::pair(Qt::black, 3.0), std::pair(Qt::white, 1.0)}) {
        painter.setPen(QPen(color, width * share, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolygon(shape);
    }
}

void MaskCanvas::paintOver(QPainter& painter) const {
    painter.save();
    const Size size = picture()->size();
    if (!m_veil.isNull())
        painter.drawImage(QRectF(view().origin(), QSizeF(size.width, size.height) * view().scale()), m_veil);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOutline(painter);
    if (m_tool == Tool::Brush)
        m_brush.paint(painter, view(), m_adds ? veilColor() : QColor(255, 255, 255, 120), cursorMiddle());
    painter.restore();
}

} // namespace texloom::ui

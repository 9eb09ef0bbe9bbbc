#include "ui/exemplar/edit_canvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace texloom::ui {

namespace {

/// Share of the picture that frames first leave at each side.
constexpr double kFirstMargin = 0.1;
constexpr int kFarStep = 10;
constexpr double kLoupeZoom = 6;

QPointF toQt(PlanePoint point) {
    return {point.x, point.y};
}

} // namespace

EditCanvas::EditCanvas(QWidget* parent) : ImageViewer(parent) {
    setObjectName(QStringLiteral("editCanvas"));
}

void EditCanvas::setMode(Mode mode) {
    m_mode = mode;
    m_moving = false;
    m_drag.reset();
    m_brush.finish();
    m_brush.leave();
    setCursor(brushing() ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

void EditCanvas::setFrameFor(const Param& param) {
    const bool area = param.type() == Param::Type::Area;
    setMode(area ? Mode::Area : Mode::Points);
    m_corners.resize(area ? 4 : param.pointCount());
    resetFrames();
}

void EditCanvas::resetFrames() {
    if (!picture())
        return;
    const Size size = picture()->size();
    const double x = std::floor(kFirstMargin * size.width), y = std::floor(kFirstMargin * size.height);
    const double width = size.width - 2 * x, height = size.height - 2 * y;
    if (m_corners.size() == 4)
        m_corners = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    for (std::size_t i = 0; m_corners.size() != 4 && i < m_corners.size(); ++i) {
        const double angle =
            2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(m_corners.size());
        m_corners[i] = {x + 0.5 * width * (1 + std::sin(angle)), y + 0.5 * height * (1 - std::cos(angle))};
    }
    m_active = 0;
    m_moving = false;
    update();
    Q_EMIT frameMoved();
}

Value EditCanvas::frame() const {
    if (m_mode != Mode::Area)
        return m_corners;
    const auto whole = [](double value) { return static_cast<int>(std::lround(value)); };
    const int left = whole(std::min(m_corners[0].x, m_corners[2].x));
    const int top = whole(std::min(m_corners[0].y, m_corners[2].y));
    return Wholes{left, top, std::max(1, whole(std::max(m_corners[0].x, m_corners[2].x)) - left),
                  std::max(1, whole(std::max(m_corners[0].y, m_corners[2].y)) - top)};
}

void EditCanvas::setFrame(const Value& frame) {
    if (!picture())
        return;
    if (const auto* area = std::get_if<Wholes>(&frame))
        setArea(*area);
    else
        m_corners = std::get<PlanePoints>(frame);
    update();
}

void EditCanvas::setArea(const Wholes& area) {
    const Size size = picture()->size();
    const int x = std::clamp(area[0], 0, size.width - 1), y = std::clamp(area[1], 0, size.height - 1);
    const double left = x, top = y, right = x + std::clamp(area[2], 1, size.width - x),
                 bottom = y + std::clamp(area[3], 1, size.height - y);
    m_corners = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

QRectF EditCanvas::areaRect() const {
    return QRectF(toQt(m_corners[0]), toQt(m_corners[2])).normalized();
}

void EditCanvas::setAreaRect(const QRectF& area) {
    m_corners = {{area.left(), area.top()},
                 {area.right(), area.top()},
                 {area.right(), area.bottom()},
                 {area.left(), area.bottom()}};
    update();
    Q_EMIT frameMoved();
}

void EditCanvas::setRatio(double ratio) {
    m_ratio = ratio;
    if (m_mode == Mode::Area && picture() && ratio > 0)
        setAreaRect(AreaDrag::withRatio(areaRect(), ratio));
}

void EditCanvas::setBrushSize(int pixels) {
    m_brush.setWidth(pixels);
    update();
}

int EditCanvas::cornerAt(QPointF point) const {
    const double reach = fontMetrics().height();
    int nearest = -1;
    double best = reach * reach;
    for (int i = 0; i < std::ssize(m_corners); ++i) {
        const QPointF away = view().toWidget(toQt(m_corners[static_cast<std::size_t>(i)])) - point;
        if (const double distance = QPointF::dotProduct(away, away); distance <= best) {
            best = distance;
            nearest = i;
        }
    }
    return nearest;
}

void EditCanvas::moveCorner(int corner, PlanePoint to) {
    const Size size = picture()->size();
    to.x = std::clamp(to.x, 0.0, static_cast<double>(size.width));
    to.y = std::clamp(to.y, 0.0, static_cast<double>(size.height));
    const auto at = static_cast<std::size_t>(corner);
    if (m_mode == Mode::Area) {
        to = {std::round(to.x), std::round(to.y)};
        // The neighbours share a side with it: 0 and 1 the top, 1 and 2 the right one, and so on.
        const bool even = corner % 2 == 0;
        PlanePoint& besideX = m_corners[even ? (at + 3) % 4 : (at + 1) % 4];
        PlanePoint& besideY = m_corners[even ? (at + 1) % 4 : (at + 3) % 4];
        besideX.x = to.x;
        besideY.y = to.y;
    }
    m_corners[at] = to;
    update();
    Q_EMIT frameMoved();
}

bool EditCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const int frameKeys[] = {Qt::Key_N, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape};
        const bool own =
            (framing() && key->modifiers() == Qt::NoModifier &&
             std::find(std::begin(frameKeys), std::end(frameKeys), key->key()) != std::end(frameKeys)) ||
            (brushing() && key->key() == Qt::Key_Space);
        if (own)
            event->accept();
    }
    if (event->type() == QEvent::Leave) {
        m_brush.leave();
        update();
    }
    return ImageViewer::event(event);
}

void EditCanvas::mousePressEvent(QMouseEvent* event) {
    const bool left = event->button() == Qt::LeftButton && picture() != nullptr;
    if (left && framing() && pressFrame(event->position()))
        return;
    if (left && brushing()) {
        setFocus(Qt::MouseFocusReason);
        m_brush.begin(picture()->size(), view().toImage(event->position()));
        update();
        return;
    }
    ImageViewer::mousePressEvent(event);
}

/// Takes hold of what of the frame lies at a point of the widget. @return whether there is anything.
bool EditCanvas::pressFrame(QPointF point) {
    const int corner = cornerAt(point);
    if (corner >= 0)
        m_active = corner;
    m_moving = corner >= 0;
    if (m_mode == Mode::Area) {
        const QPointF at = view().toImage(point);
        const double reach = fontMetrics().height() / 2.0 / view().scale();
        const int held = corner >= 0 ? AreaDrag::edgesOf(corner) : AreaDrag::heldAt(areaRect(), at, reach);
        m_drag.emplace(areaRect(), held, at, picture()->size());
    }
    if (!m_moving && !m_drag)
        return false;
    setFocus(Qt::MouseFocusReason);
    update();
    return true;
}

void EditCanvas::dragFrame(const QMouseEvent& event) {
    const QPointF at = view().toImage(event.position());
    constexpr double kSmallest = 2;
    const bool square = event.modifiers().testFlag(Qt::ShiftModifier);
    const QRectF moved = m_drag->movedTo(at, square ? 1 : m_ratio);
    if (m_drag->held() == AreaDrag::None && (moved.width() < kSmallest || moved.height() < kSmallest))
        return; // a click draws nothing
    setAreaRect(moved);
}

void EditCanvas::showCursorAt(QPointF point) {
    if (cornerAt(point) >= 0 || m_mode != Mode::Area) {
        setCursor(cornerAt(point) >= 0 ? Qt::SizeAllCursor : Qt::ArrowCursor);
        return;
    }
    const double reach = fontMetrics().height() / 2.0 / view().scale();
    const int held = AreaDrag::heldAt(areaRect(), view().toImage(point), reach);
    const bool sideways = held == AreaDrag::Left || held == AreaDrag::Right;
    setCursor(held == AreaDrag::None  ? Qt::CrossCursor
              : held == AreaDrag::All ? Qt::OpenHandCursor
              : sideways              ? Qt::SizeHorCursor
                                      : Qt::SizeVerCursor);
}

void EditCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = view().toImage(event->position());
    if (brushing() && picture()) {
        m_brush.moveTo(at);
        update();
    } else if (m_drag) {
        dragFrame(*event);
    } else if (m_moving) {
        moveCorner(m_active, {at.x(), at.y()});
    } else if (framing() && picture()) {
        showCursorAt(event->position());
    }
    if (!m_moving && !m_drag && !m_brush.stroking())
        ImageViewer::mouseMoveEvent(event);
}

void EditCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (m_brush.stroking())
        return finishStroke();
    if (m_moving || m_drag) {
        m_moving = false;
        m_drag.reset();
        update();
        return;
    }
    ImageViewer::mouseReleaseEvent(event);
}

/// Enter takes the frame as it is; Esc ends a drag as though it had not begun, or leaves the frame.
bool EditCanvas::frameKey(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        Q_EMIT accepted();
        return true;
    }
    if (event.key() != Qt::Key_Escape)
        return false;
    if (m_drag) {
        setAreaRect(m_drag->before());
        m_drag.reset();
        m_moving = false;
    } else {
        Q_EMIT left();
    }
    return true;
}

void EditCanvas::keyPressEvent(QKeyEvent* event) {
    const std::pair<int, QPointF> ways[] = {
        {Qt::Key_Left, {-1, 0}}, {Qt::Key_Right, {1, 0}}, {Qt::Key_Up, {0, -1}}, {Qt::Key_Down, {0, 1}}};
    if (picture() && framing() && event->modifiers() == Qt::NoModifier && frameKey(*event))
        return;
    if (picture() && framing() && !(event->modifiers() & Qt::ShiftModifier)) {
        if (event->key() == Qt::Key_N) {
            m_active = (m_active + 1) % static_cast<int>(m_corners.size());
            m_moving = true;
            return update();
        }
        for (const auto& [key, way] : ways)
            if (event->key() == key) {
                const QPointF step = way * ((event->modifiers() & Qt::ControlModifier) ? kFarStep : 1);
                const PlanePoint& corner = m_corners[static_cast<std::size_t>(m_active)];
                m_moving = true;
                return moveCorner(m_active, {corner.x + step.x(), corner.y + step.y()});
            }
    }
    if (picture() && brushing() && event->key() == Qt::Key_Space && cursorPixel()) {
        m_brush.begin(picture()->size(), *cursorMiddle());
        return finishStroke();
    }
    ImageViewer::keyPressEvent(event);
}

void EditCanvas::finishStroke() {
    const QImage stroke = m_brush.finish();
    update();
    Q_EMIT painted(stroke);
}

QPolygonF EditCanvas::framePolygon() const {
    QPolygonF polygon;
    for (const PlanePoint& corner : m_corners)
        polygon << view().toWidget(toQt(corner));
    return polygon;
}

void EditCanvas::paintOver(QPainter& painter) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (framing())
        paintFrame(painter);
    if (framing() && m_moving)
        paintLoupe(painter);
    if (brushing())
        m_brush.paint(painter, view(),
                      m_mode == Mode::Hide ? QColor(0, 0, 0, 150) : QColor(255, 255, 255, 120),
                      cursorMiddle());
    painter.restore();
}

void EditCanvas::paintFrame(QPainter& painter) const {
    const QPolygonF polygon = framePolygon();
    QPainterPath outside, inside;
    outside.addRect(rect());
    inside.addPolygon(polygon);
    inside.closeSubpath();
    painter.fillPath(outside.subtracted(inside), QColor(0, 0, 0, 120));
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.5),
                 handle = fontMetrics().height() * 0.3;
    for (const auto& [color, share] : {std::pair(Qt::black, 3.0), std::pair(Qt::white, 1.0)}) {
        painter.setPen(QPen(color, width * share, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(inside);
        for (int i = 0; i < polygon.size(); ++i) {
            // The active corner is a filled square, the others are rings.
            const QPointF at = polygon[i];
            painter.setBrush(i == m_active ? QBrush(Qt::white) : QBrush(Qt::NoBrush));
            if (i == m_active)
                painter.drawRect(QRectF(at - QPointF(handle, handle), at + QPointF(handle, handle)));
            else
                painter.drawEllipse(at, handle, handle);
        }
    }
}

/// The surroundings of the moving corner, enlarged, on the side where it hides neither corner nor cursor.
void EditCanvas::paintLoupe(QPainter& painter) const {
    const QPointF corner = toQt(m_corners[static_cast<std::size_t>(m_active)]);
    const QPointF at = view().toWidget(corner);
    const double radius = fontMetrics().height() * 4;
    const QPointF away(at.x() > rect().center().x() ? -1.6 : 1.6, at.y() > rect().center().y() ? -1.6 : 1.6);
    const QPointF centre = at + away * radius;
    const double scale = kLoupeZoom * std::max(1.0, view().scale());
    QPainterPath glass;
    glass.addEllipse(centre, radius, radius);
    painter.save();
    painter.setClipPath(glass);
    painter.fillPath(glass, palette().color(QPalette::Base));
    const QImage& image = picture()->image();
    const double step = picture()->step();
    QTransform transform;
    transform.translate(centre.x(), centre.y());
    transform.scale(scale, scale);
    transform.translate(-corner.x(), -corner.y());
    transform.scale(step, step);
    painter.setTransform(transform, true);
    painter.drawImage(0, 0, image);
    painter.restore();
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.5);
    for (const auto& [color, share] : {std::pair(Qt::black, 3.0), std::pair(Qt::white, 1.0)}) {
        painter.setPen(QPen(color, width * share));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, radius, radius);
        for (const QPointF way : {QPointF(1, 0), QPointF(0, 1)})
            painter.drawLine(centre - way * radius * 0.5, centre + way * radius * 0.5);
    }
}

} // namespace texloom::ui

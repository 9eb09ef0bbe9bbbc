#include "ui/compare/wipe_viewer.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace texloom::ui {

namespace {

constexpr double kKeyShare = 0.02;
constexpr double kKeyTurn = 5;

double distance(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

} // namespace

WipeViewer::WipeViewer(QWidget* parent) : ImageViewer(parent) {}

void WipeViewer::setFarPicture(std::shared_ptr<const DisplayPicture> picture) {
    m_far = std::move(picture);
    update();
}

void WipeViewer::setAngle(double degrees) {
    m_angle = std::fmod(std::fmod(degrees, 360) + 360, 360);
    update();
    Q_EMIT lineChanged();
}

void WipeViewer::setPlace(QPointF place) {
    m_place = {std::clamp(place.x(), 0.0, 1.0), std::clamp(place.y(), 0.0, 1.0)};
    update();
    Q_EMIT lineChanged();
}

QPointF WipeViewer::normal() const {
    const double radians = m_angle * std::numbers::pi / 180;
    return {std::cos(radians), std::sin(radians)};
}

double WipeViewer::radius() const {
    return fontMetrics().height() * 0.6;
}

QPointF WipeViewer::handle() const {
    return {m_place.x() * width(), m_place.y() * height()};
}

QPointF WipeViewer::knob() const {
    return handle() + QPointF(-normal().y(), normal().x()) * radius() * 5;
}

WipeViewer::Grip WipeViewer::gripAt(QPointF point) const {
    if (!m_far)
        return Grip::None;
    const double reach = radius() * 1.5;
    return distance(point, handle()) <= reach ? Grip::Handle
           : distance(point, knob()) <= reach ? Grip::Knob
                                              : Grip::None;
}

void WipeViewer::paintOver(QPainter& painter) const {
    if (!m_far)
        return;
    const QPointF along(-normal().y(), normal().x());
    const double far = width() + height();
    const QPointF centre = handle();
    QPolygonF side;
    side << centre + along * far << centre - along * far << centre - along * far + normal() * far * 2
         << centre + along * far + normal() * far * 2;
    QPainterPath path;
    path.addPolygon(side);
    painter.save();
    painter.setClipPath(path);
    paintBackground(painter, rect());
    paintPicture(painter, *m_far);
    painter.restore();
    paintLine(painter);
}

void WipeViewer::paintLine(QPainter& painter) const {
    const QPointF along(-normal().y(), normal().x());
    const double far = width() + height();
    const double line = std::max(1.0, fontMetrics().lineWidth() * 1.5);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& [color, breadth] : {std::pair(Qt::black, line * 3), std::pair(Qt::white, line)}) {
        painter.setPen(QPen(color, breadth));
        painter.setBrush(Qt::NoBrush);
        painter.drawLine(handle() - along * far, handle() + along * far);
        painter.setBrush(Qt::white);
        painter.drawEllipse(handle(), radius(), radius());
        painter.drawEllipse(knob(), radius() / 2, radius() / 2);
    }
    painter.setPen(QPen(Qt::black, line, Qt::SolidLine, Qt::RoundCap));
    const QPointF tip = normal() * radius() * 0.6;
    painter.drawLine(handle() - tip, handle() + tip);
    painter.restore();
}

bool WipeViewer::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_far) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (isArrow(key->key()) && key->modifiers().testFlag(Qt::ControlModifier))
            event->accept();
    }
    return ImageViewer::event(event);
}

bool WipeViewer::moveByKey(const QKeyEvent& event) {
    if (!m_far || !isArrow(event.key()) || !event.modifiers().testFlag(Qt::ControlModifier))
        return false;
    const int across = event.key() == Qt::Key_Right ? 1 : event.key() == Qt::Key_Left ? -1 : 0;
    const int down = event.key() == Qt::Key_Down ? 1 : event.key() == Qt::Key_Up ? -1 : 0;
    if (event.modifiers().testFlag(Qt::ShiftModifier))
        setAngle(m_angle + kKeyTurn * (across + down));
    else
        setPlace(m_place + QPointF(across, down) * kKeyShare);
    return true;
}

void WipeViewer::keyPressEvent(QKeyEvent* event) {
    if (!moveByKey(*event))
        ImageViewer::keyPressEvent(event);
}

void WipeViewer::mousePressEvent(QMouseEvent* event) {
    m_grip = event->button() == Qt::LeftButton ? gripAt(event->position()) : Grip::None;
    if (m_grip == Grip::None)
        ImageViewer::mousePressEvent(event);
}

void WipeViewer::mouseMoveEvent(QMouseEvent* event) {
    if (m_grip == Grip::Handle) {
        setPlace({event->position().x() / width(), event->position().y() / height()});
    } else if (m_grip == Grip::Knob) {
        const QPointF along = event->position() - handle();
        setAngle(std::atan2(along.y(), along.x()) * 180 / std::numbers::pi - 90);
    } else {
        const bool over = event->buttons() == Qt::NoButton && gripAt(event->position()) != Grip::None;
        if (event->buttons() == Qt::NoButton)
            setCursor(over ? Qt::SizeAllCursor : Qt::ArrowCursor);
        ImageViewer::mouseMoveEvent(event);
    }
}

void WipeViewer::mouseReleaseEvent(QMouseEvent* event) {
    m_grip = Grip::None;
    ImageViewer::mouseReleaseEvent(event);
}

} // namespace texloom::ui

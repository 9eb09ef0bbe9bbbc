#include "ui/volume/slice_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <Eigen/Geometry>

#include <cmath>

namespace texloom::ui {

namespace {

using Eigen::Vector3d;

constexpr double kGrip = 5;       ///< points beside a line at which it is taken
constexpr double kKeyPan = 32;    ///< points
constexpr double kKeyZoom = 1.25; ///< for each press, or notch of the wheel
constexpr double kKeyTurn = 5;    ///< degrees
constexpr double kDragTurn = 0.5; ///< degrees for each point
constexpr int kPage = 10;         ///< voxels
constexpr double kNotch = 120;
const QList<Qt::Key> kOwnKeys = {Qt::Key_Left,   Qt::Key_Right, Qt::Key_Up,      Qt::Key_Down, Qt::Key_Plus,
                                 Qt::Key_Equal,  Qt::Key_Minus, Qt::Key_1,       Qt::Key_F,    Qt::Key_PageUp,
                                 Qt::Key_Return, Qt::Key_Enter, Qt::Key_PageDown};

} // namespace

/// The keys of the view come before those of actions while it has the focus.
bool SliceView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* const key = static_cast<QKeyEvent*>(event);
        if (!(key->modifiers() & (Qt::AltModifier | Qt::MetaModifier)) &&
            kOwnKeys.contains(static_cast<Qt::Key>(key->key()))) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

/// The middle of the pixel that the mouse is at, not its corner.
QPointF SliceView::pointOf(const QSinglePointEvent& event) const {
    return event.position() + QPointF(0.5, 0.5) / devicePixelRatioF();
}

SliceView::Drag SliceView::gripAt(QPointF point) const {
    if (!m_axis)
        return Drag::View;
    const QPointF cross = placeOf(m_cursor->cross());
    const bool across = std::abs(point.x() - cross.x()) <= kGrip;
    const bool down = std::abs(point.y() - cross.y()) <= kGrip;
    return across && down ? Drag::Cross : across ? Drag::Across : down ? Drag::Down : Drag::View;
}

void SliceView::showGrip(QPointF point) {
    const Drag grip = gripAt(point);
    setCursor(grip == Drag::Cross    ? Qt::SizeAllCursor
              : grip == Drag::Across ? Qt::SizeHorCursor
              : grip == Drag::Down   ? Qt::SizeVerCursor
                                     : Qt::ArrowCursor);
}

void SliceView::mousePressEvent(QMouseEvent* event) {
    m_dragPoint = pointOf(*event);
    if (!m_axis && event->button() == Qt::LeftButton && event->modifiers() & Qt::ShiftModifier)
        m_drag = Drag::Turn;
    else if (event->button() == Qt::MiddleButton)
        m_drag = Drag::View;
    else if (event->button() == Qt::LeftButton)
        m_drag = gripAt(m_dragPoint) == Drag::View ? Drag::Press : gripAt(m_dragPoint);
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
    tellHovered(pointOf(*event));
    if (m_drag == Drag::None)
        return showGrip(pointOf(*event));
    const QPointF moved = pointOf(*event) - m_dragPoint;
    constexpr double kStill = 3; // a hand is not quite still while it clicks
    if (m_drag == Drag::Press && moved.manhattanLength() <= kStill)
        return;
    if (m_drag == Drag::Press)
        m_drag = Drag::View;
    m_dragPoint = pointOf(*event);
    if (m_drag == Drag::View)
        return moveView(-moved);
    if (m_drag == Drag::Turn)
        return m_cursor->setAngles(m_cursor->turn() + kDragTurn * moved.x(),
                                   m_cursor->tilt() + kDragTurn * moved.y());
    QPointF to = pointOf(*event);
    if (m_drag == Drag::Across)
        to.setY(placeOf(m_cursor->cross()).y());
    if (m_drag == Drag::Down)
        to.setX(placeOf(m_cursor->cross()).x());
    m_cursor->setCross(spaceAt(to));
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
    if (m_drag == Drag::Press) {
        const Vector3d to = spaceAt(pointOf(*event));
        if (!m_axis) // what is seen stays where it is
            m_shift -= Eigen::Vector2d(plane().right.dot(to - m_cursor->cross()),
                                       plane().down.dot(to - m_cursor->cross()));
        m_cursor->setCross(to);
    }
    m_drag = Drag::None;
    showGrip(pointOf(*event));
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        Q_EMIT enlargeWanted();
}

void SliceView::leaveEvent(QEvent*) {
    Q_EMIT unhovered();
}

QString SliceView::valuesAt(const Vector3d& space) const {
    const Plane here = plane();
    const int step = this->step();
    const auto along = [&](const Vector3d& direction) {
        return static_cast<std::int64_t>(std::floor(direction.dot(space - here.origin) / step + 0.5));
    };
    const auto parted = [](std::int64_t number) {
        const std::int64_t rest = (number % kTile + kTile) % kTile;
        return std::pair((number - rest) / kTile, static_cast<int>(rest));
    };
    const auto [i, column] = parted(along(here.right));
    const auto [j, row] = parted(along(here.down));
    const auto found = m_shown.find({step, i, j});
    const bool known =
        found != m_shown.end() && found->second.slice == slice() && found->second.tile->values != nullptr;
    return known ? found->second.tile->values->valueText(column, row) : QString();
}

void SliceView::tellHovered(QPointF point) {
    const Vector3d space = spaceAt(point);
    Q_EMIT hovered(m_axis ? Vector3d(space.array().round()) : space, valuesAt(space));
}

void SliceView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / kNotch;
    if (event->modifiers() & Qt::ControlModifier)
        step(static_cast<int>(-std::copysign(std::ceil(std::abs(notches)), notches)));
    else
        zoomAt(pointOf(*event), std::pow(kKeyZoom, notches));
    event->accept();
}

void SliceView::moveView(QPointF distance) {
    const Eigen::Vector2d by = Eigen::Vector2d(distance.x(), distance.y()) / m_cursor->zoom();
    if (m_axis) {
        const Plane here = plane();
        return m_cursor->setMiddle(m_cursor->middle() + by.x() * here.right + by.y() * here.down);
    }
    m_shift += by;
    update();
    makeTiles();
}

void SliceView::zoomAt(QPointF point, double factor) {
    const double before = m_cursor->zoom();
    m_cursor->setZoom(before * factor);
    const double grown = m_cursor->zoom() / before;
    moveView((point - centre()) * (grown - 1));
}

void SliceView::step(int voxels) {
    const Plane here = plane();
    // Of a slice that is turned the axis that it is most nearly square to.
    Vector3d across = here.right.cross(here.down).cwiseAbs();
    Eigen::Index axis = 0;
    across.maxCoeff(&axis);
    m_cursor->setCross(m_cursor->cross() + voxels * Vector3d::Unit(axis));
}

void SliceView::keyPressEvent(QKeyEvent* event) {
    const int right = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    const int down = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
    const bool control = event->modifiers() & Qt::ControlModifier;
    if (right != 0 || down != 0) {
        const Plane here = plane();
        if (event->modifiers() & Qt::ShiftModifier)
            return m_cursor->setCross(m_cursor->cross() + right * here.right + down * here.down);
        if (control && !m_axis)
            return m_cursor->setAngles(m_cursor->turn() + kKeyTurn * right,
                                       m_cursor->tilt() + kKeyTurn * down);
        return moveView(kKeyPan * QPointF(right, down));
    }
    switch (event->key()) {
    case Qt::Key_PageUp:
        return step(control ? -kPage : -1);
    case Qt::Key_PageDown:
        return step(control ? kPage : 1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomAt(centre(), kKeyZoom);
    case Qt::Key_Minus:
        return zoomAt(centre(), 1 / kKeyZoom);
    case Qt::Key_1:
        return m_cursor->setZoom(1 / devicePixelRatioF());
    case Qt::Key_F:
        m_shift.setZero();
        m_cursor->setMiddle(m_cursor->cross());
        update();
        return makeTiles();
    case Qt::Key_Return:
    case Qt::Key_Enter:
        Q_EMIT enlargeWanted();
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace texloom::ui

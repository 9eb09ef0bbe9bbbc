#include "ui/exemplar/area_drag.h"

#include <algorithm>
#include <cmath>

namespace texloom::ui {

namespace {

QRectF onPixels(const QRectF& area, QSizeF picture) {
    const double left = std::clamp(std::round(area.left()), 0.0, picture.width() - 1);
    const double top = std::clamp(std::round(area.top()), 0.0, picture.height() - 1);
    const double right = std::clamp(std::round(area.right()), left + 1, picture.width());
    const double bottom = std::clamp(std::round(area.bottom()), top + 1, picture.height());
    return {left, top, right - left, bottom - top};
}

} // namespace

int AreaDrag::heldAt(const QRectF& area, QPointF point, double reach) {
    const bool across = point.x() > area.left() - reach && point.x() < area.right() + reach;
    const bool down = point.y() > area.top() - reach && point.y() < area.bottom() + reach;
    if (!across || !down)
        return None;
    const auto near = [reach](double edge, double value) { return std::abs(edge - value) <= reach; };
    const int held = (near(area.left(), point.x())    ? Left
                      : near(area.right(), point.x()) ? Right
                                                      : 0) |
                     (near(area.top(), point.y())      ? Top
                      : near(area.bottom(), point.y()) ? Bottom
                                                       : 0);
    return held != 0 ? held : All;
}

int AreaDrag::edgesOf(int corner) {
    constexpr int corners[] = {Left | Top, Right | Top, Right | Bottom, Left | Bottom};
    return corners[corner];
}

AreaDrag::AreaDrag(const QRectF& area, int held, QPointF from, Size picture)
    : m_area(area), m_held(held), m_from(from), m_picture(picture.width, picture.height) {}

QRectF AreaDrag::movedTo(QPointF point, double ratio) const {
    if (m_held == None)
        return drawn(m_from, point, ratio);
    if (m_held == All) {
        QRectF moved = m_area.translated(point - m_from);
        moved.moveLeft(std::clamp(std::round(moved.left()), 0.0, m_picture.width() - moved.width()));
        moved.moveTop(std::clamp(std::round(moved.top()), 0.0, m_picture.height() - moved.height()));
        return moved;
    }
    const bool corner = (m_held & (Left | Right)) != 0 && (m_held & (Top | Bottom)) != 0;
    if (!corner)
        return edgeMoved(point, ratio);
    return drawn(
        {m_held & Left ? m_area.right() : m_area.left(), m_held & Top ? m_area.bottom() : m_area.top()},
        point, ratio);
}

/// The rectangle between a corner that stays and the mouse.
QRectF AreaDrag::drawn(QPointF anchor, QPointF point, double ratio) const {
    const auto within = [this](QPointF at) {
        return QPointF(std::clamp(at.x(), 0.0, m_picture.width()),
                       std::clamp(at.y(), 0.0, m_picture.height()));
    };
    anchor = within(anchor);
    const QPointF end = within(point);
    double width = std::abs(end.x() - anchor.x()), height = std::abs(end.y() - anchor.y());
    const double toX = point.x() < anchor.x() ? -1 : 1, toY = point.y() < anchor.y() ? -1 : 1;
    if (ratio > 0) {
        width = std::max(width, height * ratio);
        const double roomX = toX < 0 ? anchor.x() : m_picture.width() - anchor.x();
        const double roomY = toY < 0 ? anchor.y() : m_picture.height() - anchor.y();
        width = std::min({width, roomX, roomY * ratio});
        height = width / ratio;
    }
    const QPointF other(anchor.x() + toX * width, anchor.y() + toY * height);
    return onPixels(QRectF(anchor, other).normalized(), m_picture);
}

QRectF AreaDrag::edgeMoved(QPointF point, double ratio) const {
    QRectF moved = m_area;
    if (m_held & Left)
        moved.setLeft(std::min(point.x(), m_area.right() - 1));
    if (m_held & Right)
        moved.setRight(std::max(point.x(), m_area.left() + 1));
    if (m_held & Top)
        moved.setTop(std::min(point.y(), m_area.bottom() - 1));
    if (m_held & Bottom)
        moved.setBottom(std::max(point.y(), m_area.top() + 1));
    moved &= QRectF(QPointF(), m_picture);
    if (ratio <= 0)
        return onPixels(moved, m_picture);
    const bool sideways = (m_held & (Left | Right)) != 0; // the other side follows, about its middle
    const QPointF middle = moved.center();
    const double width = sideways ? std::min(moved.width(), m_picture.height() * ratio)
                                  : std::min(moved.height() * ratio, m_picture.width());
    QRectF fitted(0, 0, width, width / ratio);
    fitted.moveCenter(middle);
    fitted.moveLeft(std::clamp(fitted.left(), 0.0, m_picture.width() - fitted.width()));
    fitted.moveTop(std::clamp(fitted.top(), 0.0, m_picture.height() - fitted.height()));
    return onPixels(fitted, m_picture);
}

QRectF AreaDrag::withRatio(const QRectF& area, double ratio) {
    if (ratio <= 0)
        return area;
    const double width = std::min(area.width(), area.height() * ratio);
    QRectF fitted(0, 0, std::max(1.0, std::round(width)), std::max(1.0, std::round(width / ratio)));
    fitted.moveCenter(area.center());
    fitted.moveTopLeft({std::floor(fitted.left()), std::floor(fitted.top())});
    return fitted;
}

} // namespace texloom::ui

#include "ui/common/appearance.h"
#include "ui/volume/slice_view.h"

#include <QPainter>

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace texloom::ui {

namespace {

using Eigen::Vector3d;

constexpr double kGap = 7; ///< points around the crosshair's middle that stay free

/// A line that is seen on any picture.
void paintLine(QPainter& painter, QPointF from, QPointF to, const QColor& color, Qt::PenStyle style) {
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3));
    painter.drawLine(from, to);
    painter.setPen(QPen(color, 1, style));
    painter.drawLine(from, to);
}

/// A text on a dark ground in a corner. @return the room that it takes.
QRectF paintLabel(QPainter& painter, QPointF topLeft, const QString& text, const QColor& color) {
    const QFontMetrics metrics = painter.fontMetrics();
    const double margin = metrics.height() / 4.0;
    const QRectF ground(topLeft,
                        QSizeF(metrics.horizontalAdvance(text) + 4 * margin, metrics.height() + 2 * margin));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 190));
    painter.drawRoundedRect(ground, margin, margin);
    painter.setBrush(color);
    painter.drawRect(QRectF(ground.left(), ground.top() + margin, margin, ground.height() - 2 * margin));
    painter.setPen(Qt::white);
    painter.drawText(ground.adjusted(2 * margin, 0, 0, 0), Qt::AlignVCenter, text);
    return ground;
}

} // namespace

QColor axisColor(Axis axis) {
    switch (axis) {
    case Axis::X:
        return {255, 110, 100};
    case Axis::Y:
        return {120, 220, 120};
    case Axis::Z:
        break;
    }
    return {110, 170, 255};
}

void SliceView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), canvasColor());
    if (!m_source) {
        painter.setPen(Qt::white);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("There is no volume to look at."));
        return;
    }
    paintTiles(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOblique(painter);
    paintCross(painter);
    paintTexts(painter);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

/// First what there is in other sizes, the coarsest below, then what belongs here.
void SliceView::paintTiles(QPainter& painter) const {
    painter.setRenderHint(QPainter::SmoothPixmapTransform, m_cursor->zoom() * devicePixelRatioF() < 1);
    const int now = step();
    const auto paint = [&](bool current) {
        for (auto shown = m_shown.rbegin(); shown != m_shown.rend(); ++shown)
            if ((std::get<0>(shown->first) == now) == current && !shown->second.tile->picture.isNull())
                painter.drawImage(rectOf(shown->first), shown->second.tile->picture);
    };
    paint(false);
    paint(true);
}

void SliceView::paintCross(QPainter& painter) const {
    const QPointF at = placeOf(m_cursor->cross());
    QColor across = Qt::white, down = Qt::white;
    if (m_axis) { // a line has the colour of the slice that stands on it
        across = axisColor(*m_axis == Axis::X ? Axis::Z : Axis::X);
        down = axisColor(*m_axis == Axis::Y ? Axis::Z : Axis::Y);
    }
    paintLine(painter, {at.x(), 0}, {at.x(), at.y() - kGap}, across, Qt::SolidLine);
    paintLine(painter, {at.x(), at.y() + kGap}, {at.x(), height() - 1.0}, across, Qt::SolidLine);
    paintLine(painter, {0, at.y()}, {at.x() - kGap, at.y()}, down, Qt::SolidLine);
    paintLine(painter, {at.x() + kGap, at.y()}, {width() - 1.0, at.y()}, down, Qt::SolidLine);
}

/// Where the oblique slice cuts this one.
void SliceView::paintOblique(QPainter& painter) const {
    if (!m_axis)
        return;
    const Plane here = plane(), other = m_cursor->oblique();
    const Vector3d along = here.right.cross(here.down).cross(other.right.cross(other.down));
    constexpr double kParallel = 0.02;
    if (along.norm() < kParallel)
        return;
    const QPointF at = placeOf(m_cursor->cross());
    const double length = width() + height();
    const QPointF to =
        length * QPointF(along.normalized().dot(here.right), along.normalized().dot(here.down));
    paintLine(painter, at - to, at + to, QColor(255, 210, 90), Qt::DashLine);
}

void SliceView::paintTexts(QPainter& painter) const {
    const double margin = fontMetrics().height() / 3.0;
    const QColor color = m_axis ? axisColor(*m_axis) : QColor(255, 210, 90);
    const QRectF title = paintLabel(painter, {margin, margin}, this->title(), color);
    if (m_slow)
        paintLabel(painter, {title.right() + margin, margin}, tr("Making it…"), color);
    if (!m_axis)
        return;
    constexpr std::array<std::array<char, 2>, 3> kNames{{{'z', 'y'}, {'x', 'z'}, {'x', 'y'}}};
    const auto& [right, down] = kNames.at(static_cast<std::size_t>(*m_axis));
    const QString names = QStringLiteral("%1 → %2 ↓").arg(QLatin1Char(right)).arg(QLatin1Char(down));
    paintLabel(painter, {margin, height() - title.height() - margin}, names, Qt::transparent);
}

} // namespace texloom::ui

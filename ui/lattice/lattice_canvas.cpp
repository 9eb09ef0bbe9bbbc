#include "ui/lattice/lattice_canvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace texloom::ui {

namespace {

/// The closest that courses or points are drawn, in heights of a line of text.
constexpr double kClosest = 0.35;
/// A vector shorter than this, in pixels of the picture, cannot be drawn by hand.
constexpr double kShortest = 1;

const QColor kDark(0, 0, 0, 170);
const QColor kCourse(255, 255, 255, 215);
const QColor kArrow(255, 206, 64);

/// Range of the lattice's coordinates over a rectangle of points.
struct Span {
    int first = 0, last = -1;

    int count() const { return last - first + 1; }
};

std::pair<Span, Span> spansOf(const Lattice& lattice, Vec2 origin, QRectF area) {
    double lowA = 1e9, highA = -1e9, lowB = 1e9, highB = -1e9;
    for (const QPointF& corner : {area.topLeft(), area.topRight(), area.bottomLeft(), area.bottomRight()}) {
        const Vec2 at = lattice.coordinates(Vec2{corner.x(), corner.y()} - origin);
        lowA = std::min(lowA, at.x);
        highA = std::max(highA, at.x);
        lowB = std::min(lowB, at.y);
        highB = std::max(highB, at.y);
    }
    const auto span = [](double low, double high) {
        return Span{static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high))};
    };
    return {span(lowA, highA), span(lowB, highB)};
}

/// Draws lines that show on anything: light ones with a dark rim.
void stroke(QPainter& painter, const QPainterPath& path, const QColor& color, double width,
            Qt::PenStyle style = Qt::SolidLine) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kDark, width * 2.6, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(path);
    QPen pen(color, width, style, Qt::FlatCap);
    if (style != Qt::SolidLine)
        pen.setDashPattern({5, 3});
    painter.setPen(pen);
    painter.drawPath(path);
}

} // namespace

LatticeCanvas::LatticeCanvas(Style style, QWidget* parent) : ImageViewer(parent), m_style(style) {}

void LatticeCanvas::setLattice(const std::optional<Lattice>& lattice, Vec2 origin) {
    m_lattice = lattice;
    m_origin = origin;
    if (!lattice)
        setHandle(Handle::None);
    update();
}

void LatticeCanvas::setOriginFixed(bool fixed) {
    m_originFixed = fixed;
}

void LatticeCanvas::setHandle(Handle handle) {
    if (m_handle == handle)
        return;
    m_handle = handle;
    update();
    Q_EMIT handleChanged(handle);
}

Vec2 LatticeCanvas::placeOf(Handle handle) const {
    if (!m_lattice || handle == Handle::None || handle == Handle::Origin)
        return m_origin;
    return m_origin + (handle == Handle::First ? m_lattice->v1 : m_lattice->v2);
}

/// Where a handle is drawn: a vector too short to be seen ends beside the origin, rather than on it.
QPointF LatticeCanvas::handlePoint(Handle handle) const {
    const QPointF origin = toWidget(m_origin), way = toWidget(placeOf(handle)) - origin;
    const double length = std::hypot(way.x(), way.y()), least = 3 * handleRadius();
    return length > 0 && length < least ? origin + way * (least / length) : origin + way;
}

double LatticeCanvas::handleRadius() const {
    return fontMetrics().height() * 0.55;
}

LatticeCanvas::Handle LatticeCanvas::handleAt(QPointF point) const {
    if (!m_lattice || !picture())
        return Handle::None;
    Handle best = Handle::None;
    double nearest = handleRadius() * 1.6;
    for (const Handle handle : {Handle::First, Handle::Second, Handle::Origin}) {
        if (handle == Handle::Origin && m_originFixed)
            continue;
        const QPointF way = handlePoint(handle) - point;
        const double distance = std::hypot(way.x(), way.y());
        if (distance < nearest) {
            nearest = distance;
            best = handle;
        }
    }
    return best;
}

void LatticeCanvas::moveHandle(Handle handle, Vec2 to) {
    if (!m_lattice || handle == Handle::None)
        return;
    if (handle == Handle::Origin) {
        m_origin = to;
    } else {
        const Vec2 way = to - m_origin;
        const Vec2 hundredths{std::round(way.x * 100) / 100, std::round(way.y * 100) / 100};
        if (hundredths.length() < kShortest)
            return;
        (handle == Handle::First ? m_lattice->v1 : m_lattice->v2) = hundredths;
    }
    update();
    Q_EMIT edited(handle);
}

void LatticeCanvas::nextHandle(int step) {
    std::vector<Handle> order = {Handle::None, Handle::Origin, Handle::First, Handle::Second};
    if (m_originFixed)
        order.erase(order.begin() + 1);
    const auto count = static_cast<int>(order.size());
    const auto now = static_cast<int>(std::find(order.begin(), order.end(), m_handle) - order.begin());
    const int next = (now + step + count) % count;
    setHandle(order[static_cast<std::size_t>(next)]);
}

bool LatticeCanvas::nudge(const QKeyEvent& event) {
    const std::array<std::pair<int, Vec2>, 4> ways = {
        {{Qt::Key_Left, {-1, 0}}, {Qt::Key_Right, {1, 0}}, {Qt::Key_Up, {0, -1}}, {Qt::Key_Down, {0, 1}}}};
    for (const auto& [key, way] : ways)
        if (event.key() == key) {
            const bool large = event.modifiers().testFlag(Qt::ShiftModifier);
            const bool small = event.modifiers().testFlag(Qt::ControlModifier);
            moveHandle(m_handle, placeOf(m_handle) + (large ? 10.0 : small ? 0.1 : 1.0) * way);
            return true;
        }
    return false;
}

bool LatticeCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_lattice) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Space)
            event->accept();
    }
    return ImageViewer::event(event);
}

/// What is in the middle stays there, as the arrows do over the correlation.
void LatticeCanvas::resizeEvent(QResizeEvent* event) {
    ImageViewer::resizeEvent(event);
    if (fitted() || !event->oldSize().isValid())
        return;
    ViewTransform moved = view();
    moved.pan(QPointF(event->size().width() - event->oldSize().width(),
                      event->size().height() - event->oldSize().height()) /
              2);
    setView(moved, false);
}

void LatticeCanvas::keyPressEvent(QKeyEvent* event) {
    if (m_lattice && picture()) {
        if (event->key() == Qt::Key_Space)
            return nextHandle(event->modifiers().testFlag(Qt::ShiftModifier) ? -1 : 1);
        if (m_handle != Handle::None && nudge(*event))
            return;
    }
    ImageViewer::keyPressEvent(event);
}

void LatticeCanvas::mousePressEvent(QMouseEvent* event) {
    m_dragged = event->button() == Qt::LeftButton ? handleAt(event->position()) : Handle::None;
    setHandle(m_dragged);
    if (m_dragged == Handle::None)
        return ImageViewer::mousePressEvent(event);
    const QPointF at = view().toImage(event->position());
    m_grip = placeOf(m_dragged) - Vec2{at.x(), at.y()};
    setCursor(Qt::CrossCursor);
}

void LatticeCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragged == Handle::None) {
        ImageViewer::mouseMoveEvent(event);
        if (event->buttons() == Qt::NoButton && handleAt(event->position()) != Handle::None)
            setCursor(Qt::PointingHandCursor);
        else if (event->buttons() == Qt::NoButton)
            unsetCursor();
        return;
    }
    const QPointF at = view().toImage(event->position());
    moveHandle(m_dragged, m_grip + Vec2{at.x(), at.y()});
}

void LatticeCanvas::mouseReleaseEvent(QMouseEvent* event) {
    m_dragged = Handle::None;
    ImageViewer::mouseReleaseEvent(event);
}

void LatticeCanvas::paintOver(QPainter& painter) const {
    if (!m_lattice || !picture() || m_lattice->area() < 1e-3)
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_style == Style::Courses)
        paintCourses(painter);
    else
        paintPoints(painter);
    paintArrow(painter, Handle::First);
    paintArrow(painter, Handle::Second);
    for (const Handle handle : {Handle::Origin, Handle::First, Handle::Second})
        paintHandle(painter, handle);
    painter.restore();
}

void LatticeCanvas::paintCourses(QPainter& painter) const {
    const Lattice& lattice = *m_lattice;
    const Size size = picture()->size();
    const auto [along, down] = spansOf(lattice, m_origin, QRectF(0, 0, size.width, size.height));
    const double closest = fontMetrics().height() * kClosest / view().scale();
    painter.save();
    painter.setClipRect(QRectF(view().toWidget({0, 0}), QSizeF(size.width, size.height) * view().scale()));
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.0);
    if (lattice.area() / lattice.v1.length() >= closest) {
        QPainterPath courses;
        for (int b = down.first; b <= down.last; ++b) {
            courses.moveTo(toWidget(m_origin + lattice.at(along.first, b)));
            courses.lineTo(toWidget(m_origin + lattice.at(along.last, b)));
        }
        stroke(painter, courses, kCourse, width);
    }
    if (lattice.area() / lattice.v2.length() >= closest) {
        QPainterPath courses;
        for (int a = along.first; a <= along.last; ++a) {
            courses.moveTo(toWidget(m_origin + lattice.at(a, down.first)));
            courses.lineTo(toWidget(m_origin + lattice.at(a, down.last)));
        }
        stroke(painter, courses, kCourse, width, Qt::CustomDashLine);
    }
    painter.restore();
}

void LatticeCanvas::paintPoints(QPainter& painter) const {
    const Lattice& lattice = *m_lattice;
    const Size size = picture()->size();
    const auto [along, down] = spansOf(lattice, m_origin, QRectF(0, 0, size.width, size.height));
    const double apart = std::min(lattice.v1.length(), lattice.v2.length()) * view().scale();
    if (apart < fontMetrics().height() * kClosest)
        return paintCourses(painter);
    QPainterPath rings;
    const double radius = std::min(fontMetrics().height() * 0.25, apart / 3);
    for (int b = down.first; b <= down.last; ++b)
        for (int a = along.first; a <= along.last; ++a) {
            const Vec2 at = m_origin + lattice.at(a, b);
            if (at.x >= 0 && at.y >= 0 && at.x <= size.width && at.y <= size.height)
                rings.addEllipse(toWidget(at), radius, radius);
        }
    stroke(painter, rings, kCourse, std::max(1.0, fontMetrics().lineWidth() * 1.0));
}

void LatticeCanvas::paintArrow(QPainter& painter, Handle handle) const {
    QPainterPath path(toWidget(m_origin));
    path.lineTo(handlePoint(handle));
    stroke(painter, path, kArrow, fontMetrics().lineWidth() * 2.0);
}

void LatticeCanvas::paintHandle(QPainter& painter, Handle handle) const {
    const QPointF centre = handlePoint(handle);
    const bool origin = handle == Handle::Origin;
    const double radius = handleRadius() * (origin ? 0.6 : 1.0);
    const bool chosen = handle == m_handle;
    painter.setPen(QPen(Qt::black, fontMetrics().lineWidth() * 1.5));
    painter.setBrush(chosen ? Qt::white : kArrow);
    painter.drawEllipse(centre, radius, radius);
    if (chosen && hasFocus()) {
        QPainterPath ring;
        ring.addEllipse(centre, radius * 1.5, radius * 1.5);
        stroke(painter, ring, Qt::white, fontMetrics().lineWidth() * 1.5);
    }
    if (origin)
        return;
    painter.setPen(Qt::black);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.drawText(QRectF(centre - QPointF(radius, radius), QSizeF(radius, radius) * 2), Qt::AlignCenter,
                     handle == Handle::First ? QStringLiteral("1") : QStringLiteral("2"));
}

} // namespace texloom::ui

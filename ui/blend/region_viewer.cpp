#include "ui/blend/region_viewer.h"

#include "core/tools/join_region.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

bool has(const MovableRegion& region, int x, int y) {
    if (x < 0 || y < 0 || x >= region.picture.width || y >= region.picture.height)
        return false;
    if (region.mask)
        return inRegion((*region.mask)(x, y, 0));
    const Region middle = middleRegion(region.picture);
    return x >= middle.x && x < middle.right() && y >= middle.y && y < middle.bottom();
}

/// The sides that pixels of the region share with others, along one axis; those in a row are one line.
/// @param inside (along, across) whether a pixel is in the region.
template <class Inside, class Add>
void addSides(int along, int across, const Inside& inside, const Add& add) {
    for (int side = 0; side <= across; ++side)
        for (int begin = 0, at = 0; at <= along; ++at) {
            const bool edge = at < along && inside(at, side - 1) != inside(at, side);
            if (edge)
                continue;
            if (at > begin)
                add(begin, at, side);
            begin = at + 1;
        }
}

} // namespace

MovableRegion movableRegion(Size picture, std::shared_ptr<const Image> mask) {
    MovableRegion region{picture, std::move(mask), {}};
    if (!region.mask) {
        const Region middle = middleRegion(picture);
        const QRectF frame(middle.x, middle.y, middle.size.width, middle.size.height);
        region.outline = {{frame.topLeft(), frame.topRight()},
                          {frame.topRight(), frame.bottomRight()},
                          {frame.bottomRight(), frame.bottomLeft()},
                          {frame.bottomLeft(), frame.topLeft()}};
        return region;
    }
    addSides(
        picture.width, picture.height, [&](int x, int y) { return has(region, x, y); },
        [&](int from, int to, int y) { region.outline.emplace_back(from, y, to, y); });
    addSides(
        picture.height, picture.width, [&](int y, int x) { return has(region, x, y); },
        [&](int from, int to, int x) { region.outline.emplace_back(x, from, x, to); });
    return region;
}

RegionViewer::RegionViewer(QWidget* parent) : ImageViewer(parent) {}

void RegionViewer::setRegion(std::shared_ptr<const MovableRegion> region, QPoint offset) {
    m_region = std::move(region);
    m_offset = offset;
    update();
}

void RegionViewer::setRegionShown(bool shown) {
    m_shown = shown;
    update();
}

bool RegionViewer::isOver(QPointF point) const {
    if (!m_shown || !m_region || !picture())
        return false;
    const QPointF at = view().toImage(point) - QPointF(m_offset);
    return has(*m_region, static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
}

void RegionViewer::mousePressEvent(QMouseEvent* event) {
    m_dragging = event->button() == Qt::LeftButton && isOver(event->position());
    if (!m_dragging)
        return ImageViewer::mousePressEvent(event);
    m_pressed = view().toImage(event->position());
    m_grabbed = m_offset;
}

void RegionViewer::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) {
        Q_EMIT offsetDragged(m_grabbed + (view().toImage(event->position()) - m_pressed).toPoint());
        return;
    }
    ImageViewer::mouseMoveEvent(event);
    if (event->buttons() != Qt::NoButton || !picture())
        return;
    if (isOver(event->position()))
        setCursor(Qt::SizeAllCursor);
    else
        unsetCursor();
}

void RegionViewer::mouseReleaseEvent(QMouseEvent* event) {
    m_dragging = false;
    ImageViewer::mouseReleaseEvent(event);
}

void RegionViewer::paintOver(QPainter& painter) const {
    if (!m_shown || !m_region || !picture())
        return;
    const Size size = picture()->size();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(QRectF(view().toWidget({0, 0}), QSizeF(size.width, size.height) * view().scale()));
    std::vector<QLineF> lines;
    lines.reserve(m_region->outline.size());
    for (const QLineF& line : m_region->outline)
        lines.emplace_back(view().toWidget(line.p1() + m_offset), view().toWidget(line.p2() + m_offset));
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.0);
    const auto count = static_cast<int>(lines.size());
    painter.setPen(QPen(QColor(0, 0, 0, 150), width * 2.6));
    painter.drawLines(lines.data(), count);
    painter.setPen(QPen(Qt::white, width));
    painter.drawLines(lines.data(), count);
    painter.restore();
}

} // namespace texloom::ui

#include "ui/common/appearance.h"
#include "ui/viewers/image_viewer.h"

#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyle>

#include <cmath>

namespace texloom::ui {

namespace {

/// What shows behind pixels that are transparent or not made yet.
QImage checkerboard(int square, bool dark) {
    QImage tile(square * 2, square * 2, QImage::Format_RGB32);
    tile.fill(dark ? QColor(0x3a3a3a) : QColor(0xd9d9d9));
    QPainter painter(&tile);
    const QColor other = dark ? QColor(0x464646) : QColor(0xe8e8e8);
    painter.fillRect(0, 0, square, square, other);
    painter.fillRect(square, square, square, square, other);
    return tile;
}

} // namespace

void ImageViewer::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    paintBackground(painter, event->rect());
    const int margin = fontMetrics().height();
    if (m_picture) {
        paintPicture(painter, *m_picture);
        if (!m_hidden.isNull() && !m_repeat)
            paintHidden(painter);
        paintOver(painter);
    } else {
        painter.setPen(Qt::white);
        painter.drawText(rect().adjusted(margin, margin, -margin, -margin),
                         Qt::AlignCenter | Qt::TextWordWrap, m_placeholder);
    }
    if (m_picture && (m_cursor || m_marker))
        paintMarker(painter, m_cursor ? *m_cursor : *m_marker);
    if (m_picture && !m_rings.empty())
        paintRings(painter);
    paintBadge(painter);
    if (hasFocus()) {
        const int width = style()->pixelMetric(QStyle::PM_DefaultFrameWidth, nullptr, this) * 2;
        painter.setPen(QPen(palette().color(QPalette::Highlight), width));
        painter.setBrush(Qt::NoBrush);
        const double half = width / 2.0;
        painter.drawRect(QRectF(rect()).adjusted(half, half, -half, -half));
    }
}

void ImageViewer::paintBackground(QPainter& painter, const QRect& part) const {
    painter.fillRect(part, canvasColor());
}

void ImageViewer::paintOver(QPainter&) const {}

QRectF ImageViewer::placeOf(const DisplayPicture& picture) const {
    return {m_view.origin(), QSizeF(picture.size().width, picture.size().height) * m_view.scale()};
}

void ImageViewer::paintPicture(QPainter& painter, const DisplayPicture& picture) const {
    const double deviceScale = m_view.scale() * devicePixelRatioF();
    const QImage& level = picture.levelFor(deviceScale);
    if (picture.transparent())
        paintBackdrop(painter, picture);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, deviceScale * picture.step() < 1);
    if (m_repeat)
        paintRepeated(painter, picture, level);
    else
        paintOnce(painter, picture, level);
}

void ImageViewer::paintBackdrop(QPainter& painter, const DisplayPicture& picture) const {
    const int square = std::max(2, fontMetrics().height() / 2);
    const QBrush brush(checkerboard(square, isDark(palette())));
    painter.fillRect(m_repeat ? QRectF(rect()) : placeOf(picture).intersected(rect()), brush);
}

/// Hatching in screen pixels, cut out by the mask: the same density at any zoom.
void ImageViewer::paintHidden(QPainter& painter) const {
    const double ratio = devicePixelRatioF();
    QImage layer(size() * ratio, QImage::Format_ARGB32_Premultiplied);
    layer.setDevicePixelRatio(ratio);
    layer.fill(Qt::transparent);
    QPainter hatching(&layer);
    hatching.drawImage(QRectF(m_view.origin(), imageSize() * m_view.scale()), m_hidden);
    hatching.setCompositionMode(QPainter::CompositionMode_SourceIn);
    hatching.fillRect(rect(), QColor(0, 0, 0, 110));
    hatching.setCompositionMode(QPainter::CompositionMode_SourceAtop);
    hatching.setRenderHint(QPainter::Antialiasing);
    const double gap = fontMetrics().height() / 2.0;
    for (const auto& [color, share] :
         {std::pair(QColor(Qt::black), 0.3), std::pair(QColor(Qt::white), 0.12)}) {
        hatching.setPen(QPen(color, gap * share));
        for (double x = -height(); x < width(); x += gap)
            hatching.drawLine(QPointF(x, height()), QPointF(x + height(), 0));
    }
    hatching.end();
    painter.drawImage(0, 0, layer);
}

void ImageViewer::paintOnce(QPainter& painter, const DisplayPicture& picture, const QImage& level) const {
    const double cell = static_cast<double>(picture.step()) * picture.image().width() / level.width();
    const double cellDown = static_cast<double>(picture.step()) * picture.image().height() / level.height();
    const QRectF image = placeOf(picture);
    const QRectF shown = image.intersected(rect());
    if (shown.isEmpty())
        return;
    const QPointF first = m_view.toImage(shown.topLeft());
    const QPointF last = m_view.toImage(shown.bottomRight());
    const QPoint from(static_cast<int>(std::floor(first.x() / cell)),
                      static_cast<int>(std::floor(first.y() / cellDown)));
    const QPoint to(static_cast<int>(std::ceil(last.x() / cell)),
                    static_cast<int>(std::ceil(last.y() / cellDown)));
    const QRect part = QRect(from, to - QPoint(1, 1)).intersected(level.rect());
    const QRectF target(m_view.toWidget({part.x() * cell, part.y() * cellDown}),
                        QSizeF(part.width() * cell, part.height() * cellDown) * m_view.scale());
    painter.save();
    painter.setClipRect(image.toAlignedRect(), Qt::IntersectClip);
    painter.drawImage(target, level, part);
    painter.restore();
}

void ImageViewer::paintRepeated(QPainter& painter, const DisplayPicture& picture, const QImage& level) const {
    const QSizeF tile = placeOf(picture).size();
    const QPointF origin(std::fmod(m_view.origin().x(), tile.width()),
                         std::fmod(m_view.origin().y(), tile.height()));
    QTransform transform;
    transform.translate(origin.x(), origin.y());
    transform.scale(tile.width() / level.width(), tile.height() / level.height());
    QBrush brush(level);
    brush.setTransform(transform);
    painter.fillRect(rect(), brush);
}

void ImageViewer::paintMarker(QPainter& painter, QPoint pixel) const {
    const double radius = fontMetrics().height() * 0.6;
    const double reach = radius * 1.9;
    const QPointF centre = m_view.toWidget(QPointF(pixel) + QPointF(0.5, 0.5));
    QPainterPath path;
    path.addEllipse(centre, radius, radius);
    for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        path.moveTo(centre + way * radius);
        path.lineTo(centre + way * reach);
    }
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.5);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, width * 3, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(path);
    painter.setPen(QPen(Qt::white, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(path);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void ImageViewer::paintRings(QPainter& painter) const {
    const double radius = fontMetrics().height() * 0.35;
    QPainterPath path;
    const QSizeF tile = imageSize() * m_view.scale();
    for (const QPoint pixel : m_rings) {
        const QPointF centre = m_view.toWidget(QPointF(pixel) + QPointF(0.5, 0.5));
        for (const double y : copiesOf(centre.y(), tile.height(), height()))
            for (const double x : copiesOf(centre.x(), tile.width(), width()))
                path.addEllipse(QPointF(x, y), radius, radius);
    }
    const double width = std::max(1.0, fontMetrics().lineWidth() * 1.5);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, width * 2.5));
    painter.drawPath(path);
    painter.setPen(QPen(Qt::white, width));
    painter.drawPath(path);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

/// Where a place in the picture shows along one side of the viewer: once, or in every repeated tile.
std::vector<double> ImageViewer::copiesOf(double place, double tile, int side) const {
    constexpr int kMostTiles = 64;
    if (!m_repeat || tile * kMostTiles < side)
        return {place};
    std::vector<double> places;
    for (double at = place - std::floor(place / tile) * tile; at < side; at += tile)
        places.push_back(at);
    return places;
}

void ImageViewer::paintBadge(QPainter& painter) const {
    if (m_badge.isEmpty() || !m_picture)
        return;
    const int margin = fontMetrics().height() / 2;
    QRect text = fontMetrics().boundingRect(m_badge);
    text.moveTopLeft({margin * 2, margin * 2});
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 190));
    painter.drawRoundedRect(text.adjusted(-margin, -margin / 2, margin, margin / 2), margin / 2.0,
                            margin / 2.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::white);
    painter.drawText(text, Qt::AlignCenter | Qt::TextDontClip, m_badge);
}

} // namespace texloom::ui

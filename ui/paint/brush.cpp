#include "ui/paint/brush.h"

#include "core/base/settings.h"
#include "core/base/text.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

struct BrushSettings {
    int width = 32;
};

} // namespace

const Param& brushWidth() {
    static const Param width = field(&BrushSettings::width, "brush", TR("Brush")).range(1, 512).unit("px");
    return width;
}

Image shapeOf(const QImage& painted) {
    Image shape({painted.width(), painted.height()}, 1);
    for (int y = 0; y < painted.height(); ++y) {
        const uchar* const row = painted.constScanLine(y);
        std::transform(row, row + painted.width(), shape.plane(0).row(y),
                       [](uchar value) { return value != 0 ? 1.0F : 0.0F; });
    }
    return shape;
}

void Brush::setWidth(int pixels) {
    m_width = std::max(1, pixels);
}

void Brush::begin(Size picture, QPointF at) {
    m_stroke = QImage(picture.width, picture.height, QImage::Format_Alpha8);
    m_stroke.fill(0);
    m_last = at;
    dab(at, at);
}

void Brush::moveTo(QPointF at) {
    m_at = at;
    if (stroking()) {
        dab(m_last, at);
        m_last = at;
    }
}

QImage Brush::finish() {
    return std::exchange(m_stroke, QImage());
}

void Brush::dab(QPointF from, QPointF to) {
    QPainter painter(&m_stroke);
    painter.setPen(QPen(Qt::white, m_width, Qt::SolidLine, Qt::RoundCap));
    if (from == to)
        painter.drawPoint(from);
    else
        painter.drawLine(from, to);
}

void Brush::paint(QPainter& painter, const ViewTransform& view, QColor tint,
                  std::optional<QPointF> otherwise) const {
    if (stroking()) {
        QImage tinted = m_stroke.convertToFormat(QImage::Format_ARGB32_Premultiplied);
        QPainter tinting(&tinted);
        tinting.setCompositionMode(QPainter::CompositionMode_SourceIn);
        tinting.fillRect(tinted.rect(), tint);
        tinting.end();
        painter.drawImage(QRectF(view.origin(), QSizeF(m_stroke.size()) * view.scale()), tinted);
    }
    const std::optional<QPointF> at = m_at ? m_at : otherwise;
    if (!at)
        return;
    const double radius = 0.5 * m_width * view.scale();
    for (const auto& [color, share] : {std::pair(Qt::black, 3.0), std::pair(Qt::white, 1.0)}) {
        painter.setPen(QPen(color, std::max(1.0, painter.fontMetrics().lineWidth() * share)));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(view.toWidget(*at), radius, radius);
    }
}

} // namespace texloom::ui

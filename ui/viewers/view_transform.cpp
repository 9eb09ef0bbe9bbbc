#include "ui/viewers/view_transform.h"

#include <algorithm>
#include <cmath>

namespace texloom::ui {

void ViewTransform::setScaleAt(QPointF anchor, double scale) {
    const QPointF kept = toImage(anchor);
    m_scale = std::clamp(scale, kSmallestScale, kLargestScale);
    m_origin = anchor - kept * m_scale;
}

void ViewTransform::fit(QSizeF image, QSizeF viewport, double pixelRatio) {
    if (image.isEmpty() || viewport.isEmpty())
        return;
    double scale =
        std::min(viewport.width() / image.width(), viewport.height() / image.height()) * pixelRatio;
    if (scale > 1)
        scale = std::min(std::floor(scale), kLargestFit);
    m_scale = std::clamp(scale / pixelRatio, kSmallestScale, kLargestScale);
    const QSizeF left = viewport - image * m_scale;
    m_origin = QPointF(left.width(), left.height()) / 2;
}

void ViewTransform::keepInReach(QSizeF image, QSizeF viewport) {
    const auto kept = [](double origin, double length, double view) {
        const double lowest = view / 2 - length;
        const double highest = view / 2;
        return std::clamp(origin, lowest, highest);
    };
    m_origin = {kept(m_origin.x(), image.width() * m_scale, viewport.width()),
                kept(m_origin.y(), image.height() * m_scale, viewport.height())};
}

} // namespace texloom::ui

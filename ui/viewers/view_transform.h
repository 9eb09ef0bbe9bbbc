#pragma once

#include <QPointF>
#include <QSizeF>

namespace texloom::ui {

/// Where a picture lies in a viewer and how large: the map between image pixels and widget points.
class ViewTransform {
public:
    /// Widget points for one image pixel.
    double scale() const { return m_scale; }
    /// The widget point of the image's top left corner.
    QPointF origin() const { return m_origin; }
    QPointF toImage(QPointF widget) const { return (widget - m_origin) / m_scale; }
    QPointF toWidget(QPointF image) const { return image * m_scale + m_origin; }

    /// Changes the scale, within limits, so that the image point under `anchor` stays under it.
    void setScaleAt(QPointF anchor, double scale);
    void pan(QPointF distance) { m_origin += distance; }
    /// Shows the whole image in the middle of the viewport. A small one grows only by whole factors, so that
    /// its pixels stay alike. @param pixelRatio device pixels for one widget point.
    void fit(QSizeF image, QSizeF viewport, double pixelRatio);
    /// Moves the image back so that some of it stays over the viewport's middle.
    void keepInReach(QSizeF image, QSizeF viewport);

    friend bool operator==(const ViewTransform&, const ViewTransform&) = default;

    static constexpr double kSmallestScale = 1.0 / 256;
    static constexpr double kLargestScale = 128;
    /// A fitted image grows no further than this, in device pixels for one of its own.
    static constexpr double kLargestFit = 8;

private:
    double m_scale = 1;
    QPointF m_origin;
};

} // namespace texloom::ui

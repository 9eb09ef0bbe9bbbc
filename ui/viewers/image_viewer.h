#pragma once

#include "ui/picture/display_picture.h"
#include "ui/viewers/view_transform.h"

#include <QPoint>
#include <QPointF>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace texloom::ui {

class Navigator;
class Scope;
enum class ViewerCommand;

/// Shows any picture of the program. Wheel, + and − zoom at the cursor, dragging and the arrow keys pan, F
/// fits, 1 is 100 %, W repeats the picture endlessly, H with half a tile's offset, N shows and hides the
/// navigator, I histogram and waveform (or the keys that the user chose: see ViewerCommand); Shift with the
/// arrow keys moves a cursor of its own from pixel to pixel, for those who have no mouse.
class ImageViewer : public QWidget {
    Q_OBJECT

public:
    explicit ImageViewer(QWidget* parent = nullptr);

    /// Shows a picture. Zoom and pan stay if its size is that of the picture before; else it is fitted.
    void setPicture(std::shared_ptr<const DisplayPicture> picture);
    const std::shared_ptr<const DisplayPicture>& picture() const { return m_picture; }
    /// What is said in the viewer's middle while there is no picture.
    void setPlaceholder(const QString& text);
    const QString& placeholder() const { return m_placeholder; }
    /// A short text in the corner, such as "Preview 1:4"; none if empty.
    void setBadge(const QString& text);
    const QString& badge() const { return m_badge; }
    /// Marks an image pixel with a crosshair and a circle; none takes the mark away.
    void setMarker(std::optional<QPoint> pixel);
    const std::optional<QPoint>& marker() const { return m_marker; }
    /// Hatches pixels: those where `hidden`, of Format_Alpha8 and the picture's size, is not 0; none if null.
    void setHidden(const QImage& hidden);
    const QImage& hidden() const { return m_hidden; }

    /// Rings around these image pixels: where the copies of a pixel are.
    void setRings(std::vector<QPoint> pixels);
    const std::vector<QPoint>& rings() const { return m_rings; }

    bool repeats() const { return m_repeat; }
    const ViewTransform& view() const { return m_view; }
    /// Takes over another viewer's zoom and pan, for pictures of the same size.
    void setView(const ViewTransform& view, bool fitted);
    /// Shows a piece of the picture as large as can be, given by its middle and its width and height.
    void lookAt(QPointF middle, double side);
    /// Moves a place of the picture to the viewer's middle.
    void centreOn(QPointF place);
    /// Screen pixels for each of the picture's, about the viewer's middle.
    void setZoom(double zoom);
    bool fitted() const { return m_fitted; }
    /// The image pixel at a point of the widget, if there is one; while the picture repeats there always is.
    std::optional<QPoint> pixelAt(QPointF point) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public Q_SLOTS:
    void fit();
    void actualSize();
    void zoomIn();
    void zoomOut();
    /// Shows the picture tiled without end.
    void setRepeats(bool repeat);
    /// Shows it so with half a tile's offset: where four tiles meet is in the middle.
    void showSeams();
    /// The histogram of what is shown, its waveform, and neither, in turn.
    void showNextScope();
    /// Shows the navigators of all viewers, or hides them.
    void toggleNavigator();

Q_SIGNALS:
    /// The mouse or the keyboard's cursor came to an image pixel.
    void hovered(QPoint pixel);
    /// The mouse left the picture.
    void unhovered();
    /// Zoom or pan changed by hand.
    void viewChanged();
    /// Zoom or pan changed with the size of the viewer or of its picture.
    void viewSettled();
    void repeatsChanged(bool repeat);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    /// Paints over the picture, below marks and texts; nothing unless a viewer has more to show.
    virtual void paintOver(QPainter& painter) const;
    /// Paints a picture where this viewer's would lie.
    void paintPicture(QPainter& painter, const DisplayPicture& picture) const;
    void paintBackground(QPainter& painter, const QRect& part) const;
    /// The pixel under the keyboard's cursor, if it was ever moved.
    const std::optional<QPoint>& cursorPixel() const { return m_cursor; }
    /// Its middle, in pixels of the picture.
    std::optional<QPointF> cursorMiddle() const;

private:
    QSizeF imageSize() const;
    void fitQuietly();
    void zoomBy(double factor, QPointF anchor);
    QPointF zoomAnchor() const;
    void panBy(QPointF distance);
    void changedByHand();
    bool panKey(const QKeyEvent& event);
    void moveCursor(QPoint step);
    void hoverAt(QPointF point);
    void describe();
    void placeOverlays();
    void act(ViewerCommand command);

    void paintRepeated(QPainter& painter, const DisplayPicture& picture, const QImage& level) const;
    void paintOnce(QPainter& painter, const DisplayPicture& picture, const QImage& level) const;
    void paintBackdrop(QPainter& painter, const DisplayPicture& picture) const;
    QRectF placeOf(const DisplayPicture& picture) const;
    void paintHidden(QPainter& painter) const;
    void paintMarker(QPainter& painter, QPoint pixel) const;
    void paintRings(QPainter& painter) const;
    std::vector<double> copiesOf(double place, double tile, int side) const;
    void paintBadge(QPainter& painter) const;

    std::shared_ptr<const DisplayPicture> m_picture;
    QString m_placeholder;
    QString m_badge;
    QImage m_hidden;
    ViewTransform m_view;
    bool m_fitted = true;
    bool m_repeat = false;
    bool m_dragging = false;
    QPointF m_dragPoint;
    std::optional<QPoint> m_marker;
    std::optional<QPoint> m_cursor;
    std::vector<QPoint> m_rings;
    Navigator* m_navigator;
    Scope* m_scope;
};

} // namespace texloom::ui

#pragma once

#include <QWidget>

namespace texloom::ui {

class ImageViewer;

/// The whole picture, small, in the corner of a viewer that shows a part of it, with a frame around that
/// part; dragging the frame moves the view. There while the picture reaches beyond the viewer.
class Navigator : public QWidget {
    Q_OBJECT

public:
    explicit Navigator(ImageViewer* viewer);

    /// Shown or hidden, sized and placed for what the viewer shows now.
    void follow();
    /// Whether viewers have navigators at all, for the whole program; kept in the settings.
    static bool wanted();
    static void setWanted(bool wanted);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    /// The part of the picture that the viewer shows, in points of this widget.
    QRectF frame() const;
    void moveTo(QPointF point);

    ImageViewer* m_viewer;
};

} // namespace texloom::ui

#pragma once

#include "ui/picture/display_picture.h"
#include "ui/viewers/view_transform.h"

#include <QWidget>

#include <memory>

namespace texloom::ui {

/// The whole picture, small, in the corner of a viewer that shows a part of it, with a frame around that
/// part; dragging the frame moves the view. There while the picture reaches beyond the viewer.
class Navigator : public QWidget {
    Q_OBJECT

public:
    explicit Navigator(QWidget* viewer);

    /// To be called when another picture is shown, or another part of it. @param picture null for none, or
    /// for one without a place outside the view.
    void follow(std::shared_ptr<const DisplayPicture> picture, const ViewTransform& view);
    /// Shown or hidden, sized and placed for what the viewer shows now.
    void settle();
    /// Whether viewers have navigators at all, for the whole program; kept in the settings.
    static bool wanted();
    static void setWanted(bool wanted);

Q_SIGNALS:
    /// A place of the picture is to come to the viewer's middle.
    void placeWanted(QPointF place);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    /// The part of the picture that the viewer shows, in points of this widget.
    QRectF frame() const;
    void moveTo(QPointF point);

    QWidget* m_viewer;
    std::shared_ptr<const DisplayPicture> m_picture;
    ViewTransform m_view;
};

} // namespace texloom::ui

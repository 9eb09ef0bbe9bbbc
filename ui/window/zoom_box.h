#pragma once

#include <QComboBox>

#include <functional>

namespace texloom::ui {

class ImageViewer;

/// The zoom of the viewer in front: says what it is, and takes another, as a step or typed.
class ZoomBox : public QComboBox {
    Q_OBJECT

public:
    /// @param viewer the one in front.
    explicit ZoomBox(std::function<ImageViewer*()> viewer, QWidget* parent = nullptr);

    /// Says what a viewer does from now on, while it is the one in front.
    void follow(ImageViewer* viewer);
    /// Shows the zoom of the viewer in front.
    void refresh();

private:
    void take(const QString& text);

    std::function<ImageViewer*()> m_viewer;
};

} // namespace texloom::ui

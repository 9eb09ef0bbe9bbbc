#pragma once

#include <QWidget>

#include <array>

class QSpinBox;

namespace texloom::ui {

class EditCanvas;

/// The numbers of the frame that crops the exemplar on a canvas.
class CropPage : public QWidget {
    Q_OBJECT

public:
    explicit CropPage(EditCanvas* canvas, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The frame is as wanted.
    void applied();

private:
    void showFrame();
    void take();

    EditCanvas* m_canvas;
    std::array<QSpinBox*, 4> m_numbers; ///< left, top, width, height
};

/// The numbers of the four corners that rectify the exemplar on a canvas.
class CornersPage : public QWidget {
    Q_OBJECT

public:
    explicit CornersPage(EditCanvas* canvas, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The corners are as wanted.
    void applied();

private:
    void showFrame();
    void take();

    EditCanvas* m_canvas;
    std::array<QSpinBox*, 8> m_numbers{}; ///< x and y of each corner
};

} // namespace texloom::ui

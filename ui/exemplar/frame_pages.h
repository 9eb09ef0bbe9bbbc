#pragma once

#include <QWidget>

#include <array>
#include <utility>
#include <vector>

class QFormLayout;
class QSpinBox;

namespace texloom::ui {

class EditCanvas;

/// The numbers of a frame on a canvas, kept in step with it, and a button to say that it is as wanted.
class FramePage : public QWidget {
    Q_OBJECT

Q_SIGNALS:
    /// The frame is as wanted.
    void applied();

protected:
    FramePage(EditCanvas* canvas, QWidget* parent);

    EditCanvas* canvas() const { return m_canvas; }
    /// Adds two numbers side by side. @param names their object names and what a screen reader says.
    void addPair(const QString& title, const std::array<std::pair<QString, QString>, 2>& names);
    /// Adds a note and the button below the numbers.
    void addEnd(const QString& note, const QString& button, const QString& name);
    /// The frame on the canvas, one value for each number in the order they were added.
    virtual std::vector<int> frame() const = 0;
    virtual void setFrame(const std::vector<int>& values) = 0;

private:
    void showFrame();
    void take();

    EditCanvas* m_canvas;
    QFormLayout* m_form;
    std::vector<QSpinBox*> m_numbers;
};

/// The frame that crops the exemplar: left, top, width and height.
class CropPage : public FramePage {
    Q_OBJECT

public:
    explicit CropPage(EditCanvas* canvas, QWidget* parent = nullptr);

private:
    std::vector<int> frame() const override;
    void setFrame(const std::vector<int>& values) override;
};

/// The four corners that rectify the exemplar: x and y of each.
class CornersPage : public FramePage {
    Q_OBJECT

public:
    explicit CornersPage(EditCanvas* canvas, QWidget* parent = nullptr);

private:
    std::vector<int> frame() const override;
    void setFrame(const std::vector<int>& values) override;
};

} // namespace texloom::ui

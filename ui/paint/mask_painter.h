#pragma once

#include "core/image/selection_edits.h"
#include "ui/picture/display_picture.h"

#include <QDialog>
#include <QImage>

#include <deque>
#include <functional>
#include <memory>

class QAbstractButton;
class QButtonGroup;
class QCheckBox;
class QLabel;
class QLayout;
class QSpinBox;

namespace texloom::ui {

class MaskCanvas;
class ValueEditor;

/// Paints a mask over the picture that it belongs to: with brush, lasso, polygon and rectangle, by growing,
/// shrinking and softening what is painted, and with undo and redo. What is painted is a selection; see
/// selections. It changes off the GUI thread, one change after the other.
class MaskPainter : public QDialog {
    Q_OBJECT

public:
    /// @param selection what is painted already, of the picture's size.
    /// @param meaning what the mask is for, in a sentence.
    MaskPainter(std::shared_ptr<const DisplayPicture> picture, Image selection, const QString& meaning,
                QWidget* parent = nullptr);

    MaskCanvas* canvas() const { return m_canvas; }
    /// Whether changes are under way or wait.
    bool busy() const { return !m_changes.empty(); }
    /// What is painted. Not to be called while it is busy.
    const Image& selection() const { return m_edits->selection(); }

    /// Closes it once all changes are made.
    void accept() override;

private:
    using Change = std::function<void(SelectionEdits&)>;
    /// What shows of a selection.
    struct Shown {
        QImage veil;
        bool undo, redo;
    };

    void change(Change change);
    void set(const std::function<Image(const Image&)>& make);
    void nextChange();
    void changeDone();

    QLayout* makeTools();
    QLayout* makeLegend(const QString& meaning);
    QLayout* makeEdges();
    QLayout* makeWhole();
    QWidget* makeColumn(const QString& meaning);
    QAbstractButton* addButton(QLayout* layout, const char* name, const QString& text, const QString& help);
    void makeKeys();
    void resizeBrush(double factor);

    MaskCanvas* m_canvas;
    QButtonGroup* m_tools;
    QCheckBox* m_takeAway;
    ValueEditor* m_brush;
    QSpinBox* m_pixels;
    QAbstractButton* m_undo = nullptr;
    QAbstractButton* m_redo = nullptr;
    QLabel* m_problem;
    std::shared_ptr<SelectionEdits> m_edits; ///< of the worker while it is busy
    std::deque<Change> m_changes;            ///< the first one is under way
    bool m_accepting = false;
};

} // namespace texloom::ui

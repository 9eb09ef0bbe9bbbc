#pragma once

#include "core/image/selection_edits.h"
#include "ui/paint/paint_canvas.h"
#include "ui/picture/display_picture.h"

#include <QDialog>
#include <QImage>
#include <QKeySequence>

#include <deque>
#include <functional>
#include <memory>
#include <vector>

class QAbstractButton;
class QButtonGroup;
class QGridLayout;
class QLabel;
class QLayout;
class QVBoxLayout;

namespace texloom::ui {

class ValueEditor;

/// Paints over a picture: with brush, lasso, polygon and rectangle, with undo and redo. What is painted is
/// one channel of the picture's size; what its values mean, and what a shape does to them, its kinds say. It
/// changes off the GUI thread, one change after the other. Closing it asks before what was painted is lost.
class Painter : public QDialog {
    Q_OBJECT

public:
    PaintCanvas* canvas() const { return m_canvas; }
    /// Whether changes are under way or wait.
    bool busy() const { return !m_changes.empty(); }
    /// Whether something was painted that closing it would lose.
    bool changed() const { return busy() || m_changed; }
    /// What is painted. Not to be called while it is busy.
    const Image& painted() const { return m_edits->selection(); }

    /// Closes it once all changes are made.
    void accept() override;
    /// Asks first if something would be lost.
    void reject() override;

protected:
    using Make = std::function<Image(const Image& now)>;
    using Veil = std::function<QImage(const Image& now)>;

    /// @param painted what is painted already, of the picture's size.
    Painter(std::shared_ptr<const DisplayPicture> picture, Image painted, QWidget* parent);

    /// Builds the window: the picture beside the column, in which the kind's own parts follow the tools.
    /// @param parts in order. @param keys what keys and the mouse do, in sentences.
    void build(const std::vector<QLayout*>& parts, const QString& keys);
    /// A row with the legend of what is painted.
    QLayout* makeLegend(const QPixmap& swatch, const QString& text);
    /// A further tool beside the usual ones.
    void addTool(PaintCanvas::Tool tool, const char* name, const QString& text, const QString& help);
    void chooseTool(PaintCanvas::Tool tool);
    QAbstractButton* addButton(QLayout* layout, const char* name, const QString& text, const QString& help);
    /// The buttons for a step back and forth.
    void addSteps(QLayout* layout);
    void addKey(const QKeySequence& keys, const std::function<void()>& does);

    /// Changes what is painted, on a worker, which is a step.
    void set(const Make& make);
    /// Shows it anew in another way.
    void showVeil();
    /// Hands over what is painted once all changes before are made.
    void read(const std::function<void(const Image& now)>& done);

    /// What a shape does to what is painted. @param shape one channel, 1 in it.
    virtual Make withShape(std::function<Image(Size)> shape, bool add) const = 0;
    /// How what is painted is shown over the picture; called on a worker.
    virtual Veil veil() const = 0;

private:
    struct Change {
        std::function<void(SelectionEdits&)> make;                 ///< on a worker
        std::function<void(const Image& now)> done = [](auto&) {}; ///< once it shows
    };
    /// What shows of what is painted.
    struct Shown {
        QImage veil;
        bool undo, redo;
    };

    void change(Change change);
    void nextChange();
    void changeDone();
    void stepBack();
    void stepOn();
    QLayout* makeTools();
    void makeKeys();
    void resizeBrush(double factor);

    PaintCanvas* m_canvas;
    QButtonGroup* m_tools;
    QGridLayout* m_toolGrid;
    ValueEditor* m_brush;
    QAbstractButton* m_undo = nullptr;
    QAbstractButton* m_redo = nullptr;
    QLabel* m_problem;
    std::shared_ptr<SelectionEdits> m_edits; ///< of the worker while it is busy
    std::deque<Change> m_changes;            ///< the first one is under way
    bool m_changed = false;
    bool m_accepting = false;
};

} // namespace texloom::ui

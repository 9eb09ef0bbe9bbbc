#pragma once

#include "core/tools/tool.h"

#include <QWidget>

#include <vector>

class QComboBox;

namespace texloom::ui {

class EditCanvas;
class ValueEditor;

/// The form of a tool whose first parameter is an area or points: those are a frame on a canvas, kept in step
/// with the numbers here, and a button says that it is as wanted.
class FramePage : public QWidget {
    Q_OBJECT

public:
    FramePage(const Tool& tool, EditCanvas* canvas, QWidget* parent = nullptr);

    const Tool& tool() const { return m_tool; }
    /// Whether a tool has such a form.
    static bool suits(const Tool& tool);

    /// The canvas has this page's frame from now on.
    void begin();
    /// Says that the frame is as wanted.
    void apply() { Q_EMIT applied(edit()); }

Q_SIGNALS:
    /// The frame is as wanted.
    void applied(const texloom::Values& edit);

private:
    Values edit() const;
    void showFrame();
    QComboBox* makeRatios();

    const Tool& m_tool;
    EditCanvas* m_canvas;
    std::vector<ValueEditor*> m_editors; ///< by parameter
    QComboBox* m_ratios = nullptr;       ///< of areas
};

} // namespace texloom::ui

#pragma once

#include "core/base/exemplar_edit.h"
#include "core/tools/tool.h"

#include <QGroupBox>

#include <optional>
#include <vector>

class QCheckBox;
class QFormLayout;
class QWidget;

namespace texloom::ui {

class ValueEditor;

/// The form of a tool that needs no frame, as the tool declares it: its parameters, where it adjusts an edit
/// or has no presets, and a button for each preset.
class ToolForm : public QGroupBox {
    Q_OBJECT

public:
    explicit ToolForm(const Tool& tool, QWidget* parent = nullptr);

    const Tool& tool() const { return m_tool; }
    /// Whether it stands for one edit of a list, and changes that.
    bool adjusts() const { return m_tool.info().adjusts; }
    /// Shows the edit that it stands for, or that there is none.
    void setEdit(const ExemplarEdit* edit);
    /// What is asked for: none if the group is not checked, or the values change nothing.
    std::optional<ExemplarEdit> edit() const;
    /// Whether the exemplar is to be seen without the edit.
    bool showsBefore() const;

Q_SIGNALS:
    /// The user changed what edit() gives.
    void edited();
    /// The user wants a further edit.
    void added(const texloom::Values& edit);
    void beforeToggled();

private:
    void makeRows(QFormLayout* form);
    void makePresets(QFormLayout* form);
    ExemplarEdit values() const;
    void showWhatCounts();
    void tell();

    const Tool& m_tool;
    std::vector<ValueEditor*> m_editors; ///< by parameter; none where only presets are offered
    std::vector<QWidget*> m_labels;
    QCheckBox* m_before = nullptr;
    bool m_filling = false;
};

} // namespace texloom::ui

#pragma once

#include "core/session/batch/sweep.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;

namespace texloom::ui {

/// Asks which settings of a run to vary and over which values.
class SweepDialog : public QDialog {
    Q_OBJECT

public:
    /// @param input the run as the form has it; its settings are what is not varied.
    explicit SweepDialog(RunInput input, QWidget* parent = nullptr);

    /// The runs as asked for; empty while something is wrong, which is then said in the dialog.
    const std::vector<SweepCell>& cells() const { return m_cells; }
    /// Number of values of the first axis.
    int columns() const { return m_columns; }
    /// Whether the runs are to be made at a preview's size.
    bool quick() const;

private:
    /// What an axis may vary.
    struct Target {
        QString title;
        std::size_t step = 0;
        const Param* parameter = nullptr; ///< null for the seed
    };
    struct Row {
        QComboBox* target;
        QLineEdit* values;
        QLabel* limits;
    };

    QFormLayout* makeForm(QWidget* sameSeed);
    void listTargets();
    Row makeRow(const QString& name, const QString& title);
    void targetChosen(const Row& row);
    void refresh();
    SweepAxis axisOf(const Row& row) const;

    RunInput m_input;
    std::vector<Target> m_targets;
    Row m_across;
    Row m_down;
    QRadioButton* m_varySeed;
    QCheckBox* m_quick;
    QLabel* m_said;
    QPushButton* m_start;
    std::vector<SweepCell> m_cells;
    int m_columns = 0;
};

} // namespace texloom::ui

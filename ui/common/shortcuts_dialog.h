#pragma once

#include <QDialog>
#include <QList>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QPushButton;
class QTableWidget;

namespace texloom::ui {

/// All keys of the window and what they do; those of actions can be changed.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    ShortcutsDialog(const QList<QAction*>& actions, QWidget* parent);

private:
    QTableWidget* makeTable();
    QLayout* makeEditor();
    void addFixedRows();
    void showKeys(int row);
    QAction* chosen() const;
    void rowChosen();
    void take();
    void reset();
    void say(const QString& text);

    QList<QAction*> m_actions; ///< by row; further rows are fixed
    QTableWidget* m_table;
    QKeySequenceEdit* m_keys;
    QPushButton* m_take;
    QPushButton* m_reset;
    QLabel* m_said;
};

} // namespace texloom::ui

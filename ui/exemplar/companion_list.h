#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QListWidget;
class QToolButton;

namespace texloom::ui {

class ExemplarStore;

/// The companion maps of the current exemplar: what each holds, recognised by its name and open to
/// correction; maps are added here or dropped with the exemplar.
class CompanionList : public QWidget {
    Q_OBJECT

public:
    explicit CompanionList(ExemplarStore* store, QWidget* parent = nullptr);

    /// Asks for map files.
    void choose();

private:
    void fill();
    void showRole();

    ExemplarStore* m_store;
    QLabel* m_empty;
    QListWidget* m_list;
    QComboBox* m_role;
    QToolButton* m_add;
    QToolButton* m_remove;
    int m_shownId = 0;
};

} // namespace texloom::ui

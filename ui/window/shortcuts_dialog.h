#pragma once

#include <QDialog>
#include <QList>

class QAction;

namespace texloom::ui {

/// Lists every key: those of the actions, and those that the viewers understand.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    explicit ShortcutsDialog(const QList<QAction*>& actions, QWidget* parent = nullptr);
};

} // namespace texloom::ui

#pragma once

#include <QPushButton>

class QAction;

namespace texloom::ui {

/// A push button that shows an action and does it when pressed.
class ActionButton : public QPushButton {
    Q_OBJECT

public:
    explicit ActionButton(QAction* action, QWidget* parent = nullptr);

private:
    void follow();

    QAction* m_action;
};

} // namespace texloom::ui

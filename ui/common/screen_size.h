#pragma once

#include <QSize>

class QWidget;

namespace texloom::ui {

/// Gives a window the size that it would like, or as much of it as its screen has.
void resizeWithinScreen(QWidget* window, QSize wanted);

} // namespace texloom::ui

#pragma once

class QMenuBar;
class QWidget;

namespace texloom::ui {

/// Makes sure that Alt and a letter open a menu: gives each menu of the bar a letter that no other has, and
/// takes these letters from the labels, buttons and boxes of the window, which would else share them, so that
/// neither did anything. To be called again when widgets came.
void reserveMenuKeys(QMenuBar* bar, QWidget* window);

} // namespace texloom::ui

#pragma once

#include <QColor>

class QPalette;

namespace texloom::ui {

/// Whether the window is light or dark.
enum class Appearance { System, Light, Dark };

/// Sets the Fusion style and the palette for this appearance on the application. The first call also notes
/// how the desktop's own palette looks, which is what System follows.
void applyAppearance(Appearance appearance);

/// What the user chose last; Dark if nothing: colours are judged on neutral grey.
Appearance savedAppearance();
void saveAppearance(Appearance appearance);

/// Whether text is lighter than its background.
bool isDark(const QPalette& palette);

/// What lies behind pictures, light or dark window: a middle grey, on which white text can be read.
QColor canvasColor();

/// For the text of an error on the window's background; always beside an icon or the word itself.
QColor errorColor(const QPalette& palette);

} // namespace texloom::ui

#pragma once

#include <QIcon>
#include <QString>

class QAbstractButton;

namespace texloom::ui {

/// The monochrome icon of this name in the colour of the palette's text, sharp at any device pixel ratio. It
/// follows the palette when that changes. Null if there is no such icon; then texts stand alone.
QIcon icon(const QString& name);

/// The same, struck through while what it is on is not checked.
QIcon toggleIcon(const QString& name);

/// Gives a button its icon, or `text` if there is no such icon; `text` is its tooltip and accessible name as
/// well.
void setIconButton(QAbstractButton* button, const QString& name, const QString& text);

} // namespace texloom::ui

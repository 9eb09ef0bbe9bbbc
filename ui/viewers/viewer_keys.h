#pragma once

#include <QKeySequence>
#include <QList>

#include <optional>

class QKeyEvent;

namespace texloom::ui {

/// What every viewer does at a key, in the main window as in dialogs. In the main window actions do the same
/// from elsewhere; viewers have the keys that those have, which the user may choose.
enum class ViewerCommand { Fit, ActualSize, ZoomIn, ZoomOut, Repeat, Seams, Navigator, Scope };
inline constexpr std::size_t kViewerCommands = 8;

/// Gives a command other keys in all viewers. The first are F, 1, + and =, −, W, H, N and I.
void setViewerKeys(ViewerCommand command, const QList<QKeySequence>& keys);

/// The command that a key is for, if it is for one.
std::optional<ViewerCommand> viewerCommandAt(const QKeyEvent& event);

/// Numbers' fields leave letters to the viewers: no number has one. For the whole program, once.
void keepLettersFromNumbers();

} // namespace texloom::ui

#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

class QAction;

namespace texloom::ui {

/// Gives an action its help: shown as its tool tip and in the status bar, with its keys behind it.
void setHelp(QAction* action, const QString& help);
/// The help without the keys; the action's text where it was given none.
QString helpOf(const QAction* action);

/// Takes the keys that actions have as the ones they came with, and gives them those that the user chose in
/// their place, by object name.
void restoreShortcuts(const QList<QAction*>& actions);
/// Gives an action other keys, or none, and keeps them.
void chooseShortcut(QAction* action, const QKeySequence& keys);
/// Goes back to the keys that the action came with.
void resetShortcut(QAction* action);
/// Whether an action has the keys that it came with.
bool hasOwnShortcut(const QAction* action);
/// The action that these keys are for; null if there is none.
QAction* actionFor(const QKeySequence& keys, const QList<QAction*>& actions);

} // namespace texloom::ui

#include "ui/common/shortcuts.h"

#include <QAction>
#include <QSettings>

#include <algorithm>

namespace texloom::ui {

namespace {

constexpr const char* kHelp = "help";
constexpr const char* kOwn = "ownShortcuts";

QString settingOf(const QAction* action) {
    return QStringLiteral("shortcuts/") + action->objectName();
}

/// Keys as one text, and back.
QString textOf(const QList<QKeySequence>& keys) {
    return QKeySequence::listToString(keys, QKeySequence::PortableText);
}

/// Sets an action's keys and says them in its help.
void give(QAction* action, const QList<QKeySequence>& keys) {
    action->setShortcuts(keys);
    if (action->property(kHelp).isValid())
        setHelp(action, helpOf(action));
}

} // namespace

void setHelp(QAction* action, const QString& help) {
    action->setProperty(kHelp, help);
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? help : QStringLiteral("%1 (%2)").arg(help, keys));
    action->setStatusTip(action->toolTip());
}

QString helpOf(const QAction* action) {
    const QVariant help = action->property(kHelp);
    return help.isValid() ? help.toString()
                          : action->text().remove(QLatin1Char('&')).remove(QStringLiteral("…"));
}

void restoreShortcuts(const QList<QAction*>& actions) {
    const QSettings settings;
    for (QAction* action : actions) {
        if (action->objectName().isEmpty())
            continue;
        action->setProperty(kOwn, textOf(action->shortcuts()));
        if (const QVariant chosen = settings.value(settingOf(action)); chosen.isValid())
            give(action, QKeySequence::listFromString(chosen.toString(), QKeySequence::PortableText));
    }
}

void chooseShortcut(QAction* action, const QKeySequence& keys) {
    give(action, keys.isEmpty() ? QList<QKeySequence>() : QList{keys});
    QSettings().setValue(settingOf(action), textOf(action->shortcuts()));
}

void resetShortcut(QAction* action) {
    give(action, QKeySequence::listFromString(action->property(kOwn).toString(), QKeySequence::PortableText));
    QSettings().remove(settingOf(action));
}

bool hasOwnShortcut(const QAction* action) {
    return textOf(action->shortcuts()) == action->property(kOwn).toString();
}

QAction* actionFor(const QKeySequence& keys, const QList<QAction*>& actions) {
    const auto found = std::find_if(actions.begin(), actions.end(), [&](const QAction* action) {
        return action->shortcuts().contains(keys);
    });
    return found == actions.end() ? nullptr : *found;
}

} // namespace texloom::ui

#include "ui/viewers/viewer_keys.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QPointer>

#include <array>

namespace texloom::ui {

namespace {

std::array<QList<QKeySequence>, kViewerCommands>& keysOfAll() {
    static std::array<QList<QKeySequence>, kViewerCommands> keys = {{{Qt::Key_F},
                                                                     {Qt::Key_1},
                                                                     {Qt::Key_Plus, Qt::Key_Equal},
                                                                     {Qt::Key_Minus},
                                                                     {Qt::Key_W},
                                                                     {Qt::Key_H},
                                                                     {Qt::Key_N},
                                                                     {Qt::Key_I}}};
    return keys;
}

std::optional<ViewerCommand> commandOf(QKeyCombination key) {
    for (std::size_t i = 0; i < kViewerCommands; ++i)
        if (keysOfAll()[i].contains(QKeySequence(key)))
            return static_cast<ViewerCommand>(i);
    return {};
}

/// Takes from numbers' fields what they would keep for themselves of the viewers' letters.
class LetterKeys : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride)
            return false;
        const bool number = qobject_cast<QAbstractSpinBox*>(watched) != nullptr ||
                            qobject_cast<QAbstractSpinBox*>(watched->parent()) != nullptr;
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool letter = key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z;
        if (!number || !letter || !viewerCommandAt(key))
            return false;
        event->ignore(); // a shortcut may have it
        return true;
    }
};

} // namespace

void keepLettersFromNumbers() {
    static QPointer<LetterKeys> keys;
    if (!keys)
        qApp->installEventFilter(keys = new LetterKeys(qApp));
}

void setViewerKeys(ViewerCommand command, const QList<QKeySequence>& keys) {
    keysOfAll()[static_cast<std::size_t>(command)] = keys;
}

std::optional<ViewerCommand> viewerCommandAt(const QKeyEvent& event) {
    const auto key = static_cast<Qt::Key>(event.key());
    const Qt::KeyboardModifiers held = event.modifiers() & ~Qt::KeypadModifier;
    if (const auto command = commandOf(QKeyCombination(held, key)))
        return command;
    // Many signs, such as +, are typed with Shift; letters have it on purpose.
    const bool letter = key >= Qt::Key_A && key <= Qt::Key_Z;
    return letter ? std::nullopt : commandOf(QKeyCombination(held & ~Qt::ShiftModifier, key));
}

} // namespace texloom::ui

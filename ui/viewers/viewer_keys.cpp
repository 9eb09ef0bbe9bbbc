#include "ui/viewers/viewer_keys.h"

#include <QKeyEvent>

#include <array>

namespace texloom::ui {

namespace {

std::array<QList<QKeySequence>, kViewerCommands>& keysOfAll() {
    static std::array<QList<QKeySequence>, kViewerCommands> keys = {
        {{Qt::Key_F}, {Qt::Key_1}, {Qt::Key_Plus, Qt::Key_Equal}, {Qt::Key_Minus}, {Qt::Key_W}, {Qt::Key_H}}};
    return keys;
}

std::optional<ViewerCommand> commandOf(QKeyCombination key) {
    for (std::size_t i = 0; i < kViewerCommands; ++i)
        if (keysOfAll()[i].contains(QKeySequence(key)))
            return static_cast<ViewerCommand>(i);
    return {};
}

} // namespace

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

#pragma once

#include <QtCore/QCoreApplication>

namespace texloom::ui {

/// A text of a free function of this namespace in the language of the window: lupdate files it here.
inline QString tr(const char* text) {
    return QCoreApplication::translate("texloom::ui", text);
}

} // namespace texloom::ui

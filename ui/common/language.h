#pragma once

#include <QLocale>

namespace texloom::ui {

/// From now on texts are in the locale's language, as far as there is a translation: ours, and Qt's for its
/// own dialogs. To be called before the first window is made.
void useLanguage(const QLocale& locale);

} // namespace texloom::ui

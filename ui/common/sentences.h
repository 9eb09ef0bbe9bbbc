#pragma once

#include <QString>

namespace texloom::ui {

/// A sentence that core put values into, in the user's language: its pattern is found among those that core
/// has, and the values are put into the pattern's translation. What is no such sentence comes back as it is;
/// so does what stands before a colon, such as the name of a file.
QString translatedSentence(const QString& sentence);

} // namespace texloom::ui

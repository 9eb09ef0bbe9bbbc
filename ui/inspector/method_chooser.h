#pragma once

#include "core/methods/method.h"

#include <functional>

class QComboBox;

namespace texloom::ui {

/// Fills a list with methods under the headings of their categories; an entry's data is the method's id, and
/// its tooltip says what the method does. @param offered whether a method belongs into this list.
void fillWithMethods(QComboBox* chooser, const std::function<bool(const MethodInfo&)>& offered);

/// Adds the methods that this build was made without, which cannot be chosen; the tooltip of each says why.
void addAbsentMethods(QComboBox* chooser);

} // namespace texloom::ui

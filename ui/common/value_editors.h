#pragma once

#include "ui/common/value_editor.h"

namespace texloom::ui {

/// The editor that suits a parameter: a slider with a spin box in step, a check box, a list of choices, or
/// pairs of numbers.
ValueEditor* makeValueEditor(const Param& param, QWidget* parent);

} // namespace texloom::ui

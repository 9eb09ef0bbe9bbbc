#pragma once

#include "core/image/exemplar_edit.h"

#include <QString>

#include <optional>

namespace texloom::ui {

/// What the editing page keeps true of a list of edits: the light, of which there is at most one, comes last,
/// and before it the turn that the slider of the angle stands for.

/// "Turned by 12.5°": one edit in words.
QString editText(const ExemplarEdit& edit);

/// The evening out of the light among the edits; null if there is none.
const FlattenEdit* lightOf(const ExemplarEdits& edits);
/// The angle that the slider stands for, in degrees: of a turn that is no quarter, last but for the light; 0
/// without one.
double angleOf(const ExemplarEdits& edits);

/// The edits with one more, before the light.
ExemplarEdits withEdit(ExemplarEdits edits, const ExemplarEdit& edit);
/// The edits with another angle of the slider.
ExemplarEdits withAngle(ExemplarEdits edits, double degrees);
/// The edits with another light, or none.
ExemplarEdits withLight(ExemplarEdits edits, const std::optional<FlattenEdit>& light);

} // namespace texloom::ui

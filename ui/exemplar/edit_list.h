#pragma once

#include "core/base/exemplar_edit.h"
#include "core/tools/tool.h"

#include <QString>

#include <optional>

namespace texloom::ui {

/// What the editing page keeps true of a list of edits: those that change colours come last, since they suit
/// the pixels they were set for; and the form of a tool that adjusts stands for the edit of that tool that it
/// can reach without moving another: among the colours, or as the last that moves pixels.

/// "Turn: 12.5 °": one edit in words.
QString editText(const ExemplarEdit& edit);

/// The edit that the form of a tool stands for, as its place in the list. Presets stand for themselves.
std::optional<std::size_t> standingEdit(const ExemplarEdits& edits, const Tool& tool);

/// The edits with one more, in its place.
ExemplarEdits withEdit(ExemplarEdits edits, const ExemplarEdit& edit);
/// The edits with the one that the tool's form stands for changed, added, or taken out.
ExemplarEdits withStanding(ExemplarEdits edits, const Tool& tool, const std::optional<ExemplarEdit>& edit);

} // namespace texloom::ui

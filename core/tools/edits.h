#pragma once

#include "core/base/exemplar_edit.h"
#include "core/tools/tool.h"

#include <string_view>

namespace texloom {

/// The tool that an edit is made with. @throws UsageError that lists the tools there are, also for one that
/// does not edit.
const Tool& toolOf(const ExemplarEdit& edit);

/// The edit checked, complete, and without what has no effect: a parameter that does not matter under the
/// others, or one that is left to the tool. Two edits that do the same look the same so. @throws UsageError
ExemplarEdit resolved(const ExemplarEdit& edit);
ExemplarEdits resolved(const ExemplarEdits& edits);

/// Reads an edit as written on a command line: `crop=10,10,200,200`, or with further settings after blanks,
/// `flatten=smooth strength=0.5`. @throws UsageError that names the tool, the value and the limit.
ExemplarEdit parseEdit(std::string_view text);

/// The size that an image has after the edits. @throws UsageError that names the value and the limit where
/// one cannot be made.
Size sizeAfter(const ExemplarEdit& edit, Size before);
Size sizeAfter(const ExemplarEdits& edits, Size before);

/// Whether an edit is known to leave every pixel of an image as and where it is, such as a turn by 0°.
bool changesNothing(const ExemplarEdit& edit, Size size);

/// Where all edits together lead; those that change colours move nothing. @throws UsageError as sizeAfter()
Warp warpOf(const ExemplarEdits& edits, Size source);

} // namespace texloom

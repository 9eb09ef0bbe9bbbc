#pragma once

#include "core/base/exemplar_edit.h"
#include "core/io/json_field.h"

namespace texloom {

/// Edits as a list in JSON, each an object of the tool's settings by name: `[{"crop": [x, y, w, h]},
/// {"rotate": 12.5}, {"flip": "horizontal"}, {"rectify": [[x, y], …], "size": [w, h]},
/// {"flatten": "smooth", "strength": 1, "width": 0.25}]`.
JsonField::Json toJson(const ExemplarEdits& edits);

/// Which tools and settings there are is not known here; see toolOf(). @throws UsageError that names the
/// wrong field.
ExemplarEdits editsFrom(const JsonField& field);

} // namespace texloom

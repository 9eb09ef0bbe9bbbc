#pragma once

#include "core/image/exemplar_edit.h"
#include "core/io/json_field.h"

namespace texloom {

/// Edits as a list in JSON: `[{"crop": [x, y, w, h]}, {"rotate": 12.5}, {"flip": "horizontal"},
/// {"rectify": [[x, y], …], "size": [w, h]}, {"flatten": "smooth", "width": 0.25, "strength": 1}]`.
JsonField::Json toJson(const ExemplarEdits& edits);

/// @throws UsageError that names the wrong field.
ExemplarEdits editsFrom(const JsonField& field);

} // namespace texloom

#pragma once

#include "core/match/patch_match.h"

#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// How often the pixels of each patch of an exemplar are used on average by the matches of a field, relative
/// to how often they would be if all pixels were used equally (Π_patch / Π_best of Gutierrez, thesis 2020,
/// eq. 3.10–3.12).
/// @param sizes of all exemplars, of which this is the one numbered `exemplar`. @param check may throw.
/// @return one value for each top left pixel of a patch, row by row.
std::vector<float> patchUse(const PatchField& field, std::span<const Size> sizes, int exemplar, int patch,
                            const std::function<void()>& check);

} // namespace texloom

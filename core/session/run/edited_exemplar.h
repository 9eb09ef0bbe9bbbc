#pragma once

#include "core/session/run/run.h"

#include <functional>

namespace texloom {

/// An exemplar's original with edits made in order. Those that move pixels act on its mask, companion maps
/// and further pictures, too, normal maps as vectors, and are resampled once as long as none that changes
/// colours comes between.
/// @param exemplar its own edits do not count. @param check called every few milliseconds; may throw.
/// @throws UsageError where an edit cannot be made, or a mask or companion has another size than the image.
RunExemplar edited(
    const RunExemplar& exemplar, const ExemplarEdits& edits, const std::function<void()>& check = [] {});

/// Checks that a file of this exemplar has its size, in one sentence that names both. @throws UsageError
void checkSizeLike(const ExemplarFile& exemplar, const ExemplarFile& belonging, const Message& what);

} // namespace texloom

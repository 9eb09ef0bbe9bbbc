#pragma once

#include "core/session/run/run.h"

#include <functional>

namespace texloom {

/// An exemplar's original with edits made in order, on its mask and companion maps, too: geometry between two
/// flattenings is resampled once, normal maps as vectors; flattening changes the colours alone.
/// @param exemplar its own edits do not count. @param check called every few milliseconds; may throw.
/// @throws UsageError where an edit cannot be made, or a mask or companion has another size than the image.
RunExemplar edited(
    const RunExemplar& exemplar, const ExemplarEdits& edits, const std::function<void()>& check = [] {});

/// Checks that a file of this exemplar has its size, in one sentence that names both. @throws UsageError
void checkSizeLike(const ExemplarFile& exemplar, const ExemplarFile& belonging, const Message& what);

} // namespace texloom

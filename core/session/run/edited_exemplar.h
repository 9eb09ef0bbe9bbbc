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

/// A small picture of an exemplar's image as edits leave it, for a look before the whole is made.
struct EditedPreview {
    Image image;  ///< every pixel stands for `step` × `step` of the whole, those at the ends for fewer
    Size whole;   ///< the image's size after the edits
    int step = 1; ///< at least 1
};

/// An image whose pixels are the means of squares of `step` × `step`, cut off at the ends.
/// @param check called for every row; may throw.
Image reducedImage(
    const ImageView& image, int step, const std::function<void()>& check = [] {});

/// What edited() makes of the image, at most `longest` px on a side. Colours are edited after all pixels were
/// moved, and without the mask, so that it may differ a little.
/// @param source the exemplar's original; of its image only the size counts. @param reduced its image as
/// reducedImage() makes it with `reducedBy`. @param check called for every row; may throw. @throws UsageError
/// where an edit cannot be made.
EditedPreview editedPreview(
    const ExemplarFile& source, const ImageView& reduced, int reducedBy, const ExemplarEdits& edits,
    int longest, const std::function<void()>& check = [] {});

/// Checks that a file of this exemplar has its size, in one sentence that names both. @throws UsageError
void checkSizeLike(const ExemplarFile& exemplar, const ExemplarFile& belonging, const Message& what);

} // namespace texloom

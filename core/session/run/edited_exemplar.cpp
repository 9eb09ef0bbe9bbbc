#include "core/session/run/edited_exemplar.h"

#include "core/base/error.h"
#include "core/color/color_pipeline.h"
#include "core/image/flatten.h"
#include "core/image/normal_map.h"
#include "core/image/resample.h"

#include <fmt/format.h>

#include <utility>

namespace texloom {

namespace {

using Check = std::function<void()>;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

void place(RunExemplar& exemplar, const Placement& placement, const Check& check) {
    exemplar.image.image = shared(resampled(*exemplar.image.image, placement, check));
    if (exemplar.mask)
        exemplar.mask->image = shared(resampledMask(*exemplar.mask->image, placement, check));
    for (ExemplarFile& companion : exemplar.companions) {
        const bool normals = isNormal(companion.role) && companion.image->channels() >= 3;
        companion.image = shared(normals ? placedNormals(*companion.image, companion.role, placement, check)
                                         : resampled(*companion.image, placement, check));
    }
}

void flattenColours(RunExemplar& exemplar, const FlattenEdit& edit, const Check& check) {
    Image image = *exemplar.image.image;
    const bool data = exemplar.image.space == "raw";
    if (!data)
        color::fromWorking(image, "linear");
    flatten(image, edit, exemplar.mask ? exemplar.mask->image.get() : nullptr, check);
    if (!data)
        color::toWorking(image, "linear");
    exemplar.image.image = shared(std::move(image));
}

} // namespace

void checkSizeLike(const ExemplarFile& exemplar, const ExemplarFile& belonging, const Message& what) {
    const Size size = exemplar.image->size(), other = belonging.image->size();
    if (size != other)
        failUsage("The {} {} is {} × {} px, but {} is {} × {} px; they must be the same size.", what,
                  belonging.name(), other.width, other.height, exemplar.name(), size.width, size.height);
}

RunExemplar edited(const RunExemplar& exemplar, const ExemplarEdits& edits, const Check& check) {
    const RunExemplar& source = exemplar.original();
    if (edits.empty())
        return source;
    RunExemplar result = source;
    if (source.mask)
        checkSizeLike(source.image, *source.mask, TR("mask"));
    for (const ExemplarFile& companion : source.companions)
        checkSizeLike(source.image, companion, TR("companion"));
    Placement pending(source.image.image->size());
    bool moved = false;
    const auto placePending = [&] {
        if (moved)
            place(result, pending, check);
        pending = Placement(result.image.image->size());
        moved = false;
    };
    for (const ExemplarEdit& edit : edits) {
        pending = pending.after(edit);
        if (const auto* flattening = std::get_if<FlattenEdit>(&edit)) {
            placePending();
            flattenColours(result, *flattening, check);
        } else {
            moved = true;
        }
    }
    placePending();
    result.edits = edits;
    result.source = std::make_shared<const RunExemplar>(source);
    return result;
}

} // namespace texloom

#include "core/session/batch/join_input.h"

#include "core/session/batch/batch.h"
#include "core/session/run/edited_exemplar.h"

#include <algorithm>

namespace texloom {

Size JoinInput::common() const {
    return {std::min(first.image->width(), second.image->width()),
            std::min(first.image->height(), second.image->height())};
}

JoinPictures JoinInput::pictures() const {
    if (crops())
        return {first.image->view().crop(0, 0, common()), second.image->view().crop(0, 0, common()),
                region.get()};
    return {*first.image, *second.image, region.get()};
}

std::optional<Message> JoinInput::cropNote() const {
    if (!crops())
        return {};
    return message(
        "The first image is {} × {} px, the second {} × {} px: both are cropped to {} × {} px from "
        "the top left.",
        first.image->width(), first.image->height(), second.image->width(), second.image->height(),
        common().width, common().height);
}

JoinInput loadJoin(const BatchItem& item) {
    const auto loaded = [](const RecipeExemplar& exemplar) {
        return edited(loadFiles(exemplar, {}), exemplar.edits);
    };
    const RunExemplar first = loaded(item.exemplars->front()), second = loaded(item.exemplars->back());
    JoinInput input{item.join, first.image, second.image, {}, {}};
    if (second.mask)
        input.region = second.mask->image;
    input.settings = item.join->resolved(item.recipe.steps.front().parameters);
    return input;
}

} // namespace texloom

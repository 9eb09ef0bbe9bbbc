#include "core/session/batch/join_input.h"

#include "core/session/batch/batch.h"
#include "core/session/run/edited_exemplar.h"

namespace texloom {

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

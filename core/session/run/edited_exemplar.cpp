#include "core/session/run/edited_exemplar.h"

#include "core/base/error.h"
#include "core/color/color_pipeline.h"
#include "core/image/normal_map.h"
#include "core/image/resample.h"
#include "core/tools/edits.h"

#include <fmt/format.h>

#include <utility>

namespace texloom {

namespace {

using Check = std::function<void()>;

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

void place(RunExemplar& exemplar, const Warp& warp, const Check& check) {
    exemplar.image.image = shared(resampled(*exemplar.image.image, warp, check));
    if (exemplar.mask)
        exemplar.mask->image = shared(resampledMask(*exemplar.mask->image, warp, check));
    for (ExemplarFile& companion : exemplar.companions) {
        const bool normals = isNormal(companion.role) && companion.image->channels() >= 3;
        companion.image = shared(normals ? placedNormals(*companion.image, companion.role, warp, check)
                                         : resampled(*companion.image, warp, check));
    }
    for (auto& [port, files] : exemplar.inputs)
        for (InputFile& input : files)
            if (input.image()) {
                ExemplarFile picture = input.file;
                picture.image = shared(resampled(*picture.image, warp, check));
                input = std::move(picture);
            }
}

void recolor(RunExemplar& exemplar, const Tool& tool, const Values& settings, const Check& check) {
    Image image = *exemplar.image.image;
    const bool data = exemplar.image.space == "raw";
    if (!data)
        color::fromWorking(image, "linear", check);
    tool.recolor(image, settings, exemplar.mask ? exemplar.mask->image.get() : nullptr, check);
    if (!data)
        color::toWorking(image, "linear", check);
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
    for (const auto& [port, files] : source.inputs)
        for (const InputFile& input : files)
            if (input.image())
                checkSizeLike(source.image, input.file, Message::verbatim(port));
    Warp pending{Placement(source.image.image->size())};
    bool moved = false;
    const auto placePending = [&] {
        if (moved)
            place(result, pending, check);
        pending = Placement(result.image.image->size());
        moved = false;
    };
    result.edits = resolved(edits);
    for (const ExemplarEdit& edit : result.edits) {
        const Tool& tool = toolOf(edit);
        const Values settings = tool.resolved(edit);
        if (tool.warps()) {
            pending = pending.after(tool.warp(settings, pending.size()));
            moved = true;
        } else {
            placePending();
            recolor(result, tool, settings, check);
        }
    }
    placePending();
    result.source = std::make_shared<const RunExemplar>(source);
    return result;
}

} // namespace texloom

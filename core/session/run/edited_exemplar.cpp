#include "core/session/run/edited_exemplar.h"

#include "core/base/error.h"
#include "core/color/color_pipeline.h"
#include "core/image/normal_map.h"
#include "core/image/resample.h"
#include "core/tools/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

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

/// Changes colours in light, values of data as they are.
void recolor(Image& image, bool data, const Image* mask, const Tool& tool, const Values& settings,
             const Check& check) {
    if (!data)
        color::fromWorking(image, "linear", check);
    tool.recolor(image, settings, mask, check);
    if (!data)
        color::toWorking(image, "linear", check);
}

bool isData(const ExemplarFile& file) {
    return file.space == "raw";
}

/// The map of a picture's points whose source has `times` as many pixels on a side.
Placement magnified(Size size, double times) {
    return {size, Eigen::Vector3d(times, times, 1).asDiagonal().toDenseMatrix()};
}

Size reducedSize(Size size, int step) {
    return {(size.width + step - 1) / step, (size.height + step - 1) / step};
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
            Image image = *result.image.image;
            recolor(image, isData(result.image), result.mask ? result.mask->image.get() : nullptr, tool,
                    settings, check);
            result.image.image = shared(std::move(image));
        }
    }
    placePending();
    result.source = std::make_shared<const RunExemplar>(source);
    return result;
}

Image reducedImage(const ImageView& image, int step, const Check& check) {
    Image small(reducedSize(image.size(), step), image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < small.height(); ++y) {
            check();
            const int bottom = std::min(image.height, (y + 1) * step);
            for (int x = 0; x < small.width(); ++x) {
                const int right = std::min(image.width, (x + 1) * step);
                double sum = 0;
                for (int v = y * step; v < bottom; ++v)
                    for (int u = x * step; u < right; ++u)
                        sum += static_cast<double>(image(u, v, c));
                small(x, y, c) = static_cast<float>(sum / ((bottom - y * step) * (right - x * step)));
            }
        }
    return small;
}

EditedPreview editedPreview(const ExemplarFile& source, const ImageView& reduced, int reducedBy,
                            const ExemplarEdits& edits, int longest, const Check& check) {
    Warp warp = magnified(source.image->size(), 1.0 / reducedBy);
    std::vector<const ExemplarEdit*> colours;
    for (const ExemplarEdit& edit : edits) {
        const Tool& tool = toolOf(edit);
        if (tool.warps())
            warp = warp.after(tool.warp(tool.resolved(edit), warp.size()));
        else
            colours.push_back(&edit);
    }
    EditedPreview preview;
    preview.whole = warp.size();
    preview.step = std::max(1, (preview.whole.longerSide() + longest - 1) / longest);
    preview.image = resampled(
        reduced, warp.after(magnified(reducedSize(preview.whole, preview.step), preview.step)), check);
    for (const ExemplarEdit* edit : colours) {
        const Tool& tool = toolOf(*edit);
        recolor(preview.image, isData(source), nullptr, tool, tool.resolved(*edit), check);
    }
    return preview;
}

} // namespace texloom

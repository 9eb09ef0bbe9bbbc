#include "ui/runs/run_pictures.h"

#include "core/analysis/map_pictures.h"

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

/// Cuts off what a method made beyond the output.
void cropTo(Size output, Preview& preview) {
    const Size full{std::min(preview.fullSize.width, output.width),
                    std::min(preview.fullSize.height, output.height)};
    const Size sampled{(full.width + preview.step - 1) / preview.step,
                       (full.height + preview.step - 1) / preview.step};
    preview.image.shrink(sampled);
    if (!preview.map.size().empty())
        preview.map.shrink(sampled);
    preview.fullSize = full;
}

} // namespace

Source RunPictures::sourceOf(int x, int y) const {
    x /= step;
    y /= step;
    if (!map || x < 0 || y < 0 || x >= map->width() || y >= map->height())
        return {};
    return map->at(x, y);
}

RunPictures picturesOf(Preview preview, Size output) {
    cropTo(output, preview);
    RunPictures pictures;
    pictures.step = preview.step;
    auto values = std::make_shared<const Image>(std::move(preview.image));
    if (!preview.map.size().empty()) {
        pictures.map = std::make_shared<const PositionMap>(std::move(preview.map));
        pictures.mapKind = MapKind::Exact;
    }
    pictures.result = std::make_shared<const DisplayPicture>(std::move(values), preview.fullSize,
                                                             preview.step, pictures.map.get());
    if (pictures.map)
        pictures.synthesis = std::make_shared<const DisplayPicture>(
            std::make_shared<const Image>(synthesisPicture(*pictures.map)), preview.fullSize, preview.step,
            pictures.map.get());
    return pictures;
}

bool knowsExemplars(const Result& result) {
    const std::vector<Exemplar>& exemplars = result.plan.request.exemplars;
    return !exemplars.empty() &&
           std::all_of(exemplars.begin(), exemplars.end(), [&](const Exemplar& exemplar) {
               return exemplar.image->size().area() > 1 &&
                      exemplar.image->channels() >= result.synthesis.image.channels();
           });
}

RunPictures picturesOf(const std::shared_ptr<const Result>& result) {
    RunPictures pictures;
    const Synthesis& synthesis = result->synthesis;
    pictures.run = result;
    const std::shared_ptr<const Image> values(result, &synthesis.image);
    const bool mapped = synthesis.mapKind != MapKind::None && !synthesis.map.size().empty();
    pictures.result = mapped && result->stoppedAt
                          ? std::make_shared<const DisplayPicture>(values, values->size(), 1, &synthesis.map)
                          : std::make_shared<const DisplayPicture>(values);
    if (!mapped)
        return pictures;
    pictures.map = std::shared_ptr<const PositionMap>(result, &synthesis.map);
    pictures.mapKind = synthesis.mapKind;
    pictures.synthesis = std::make_shared<const DisplayPicture>(
        std::make_shared<const Image>(synthesisPicture(synthesis.map)));
    return pictures;
}

} // namespace texloom::ui

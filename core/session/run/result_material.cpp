#include "core/session/run/result_material.h"

#include "core/color/color_pipeline.h"

#include <algorithm>

namespace texloom {

namespace {

constexpr int kColours = 3;

/// Whether the companion maps of a result can be had: one that was stopped has none, and one that was read
/// back may have lost their files.
bool hasCompanionImages(const Result& result) {
    if (!result.plan.hasCompanions())
        return false;
    if (!result.companions.empty())
        return true;
    const auto there = [](const std::vector<ExemplarFile>& files) {
        return std::all_of(files.begin(), files.end(),
                           [](const ExemplarFile& file) { return file.image != nullptr; });
    };
    return result.synthesis.mapKind != MapKind::None &&
           std::all_of(result.plan.companions.begin(), result.plan.companions.end(), there);
}

} // namespace

Material materialOf(const ImageView& image) {
    Material material;
    const int colours = image.channels >= kColours ? kColours : 1;
    Image colour(image.channelRange(0, colours));
    color::fromWorking(colour, "linear");
    material.maps[MapRole::Color] = std::make_shared<const Image>(std::move(colour));
    if (image.channels == 2 || image.channels == kColours + 1)
        material.maps[MapRole::Opacity] =
            std::make_shared<const Image>(image.channelRange(image.channels - 1, 1));
    return material;
}

Material materialOf(const Result& result) {
    Material material = materialOf(result.synthesis.image);
    if (!hasCompanionImages(result))
        return material;
    const std::vector<ExemplarFile>& companions = result.plan.companions.front();
    for (std::size_t i = 0; i < companions.size(); ++i) {
        const MapRole role = companions[i].role;
        if (role != MapRole::Other && !material.maps.contains(role))
            material.maps[role] = std::make_shared<const Image>(result.companion(i));
    }
    return material;
}

} // namespace texloom

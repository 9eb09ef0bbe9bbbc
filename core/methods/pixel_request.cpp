#include "core/methods/pixel_request.h"

#include "core/base/error.h"
#include "core/match/whole_patches.h"
#include "core/methods/patch_request.h"

#include <algorithm>

namespace texloom {

namespace {

constexpr int kPreviewSide = 640;

} // namespace

void checkSquares(const Request& request, int side) {
    bool any = false;
    for (const Exemplar& exemplar : request.exemplars) {
        const Size size = exemplar.image->size();
        if (size.shorterSide() < side)
            failUsage("{} is {} × {} px, smaller than the neighbourhood of {} px; choose a neighbourhood of "
                      "at most "
                      "{} px, or a larger exemplar.",
                      exemplar.name, size.width, size.height, side, size.shorterSide());
        any = any || !exemplar.mask() || leavesWholePatch(exemplar.mask()->view().plane(0), side);
    }
    if (!any)
        failUsage("The mask leaves no whole neighbourhood of {} px; choose a smaller one or mask less.",
                  side);
}

PixelPyramid::PixelPyramid(const Request& request, int levels, int side, const std::function<void()>& check)
    : m_pyramid(patchSources(request), levels, side, check) {
    for (int level = 0; level < m_pyramid.levels(); ++level) {
        std::vector<Interleaved>& pictures = m_pixels.emplace_back();
        for (const PatchSource& source : m_pyramid.level(level)) {
            check();
            pictures.emplace_back(source.image.size(), source.image.channels)
                .load(source.image, 0, 0, source.image.size());
        }
    }
}

std::uint64_t PixelPyramid::bytesFor(const Request& request) {
    const std::vector<Size> sizes = request.exemplarSizes();
    std::uint64_t bytes = ExemplarPyramid::bytesFor(sizes, request.channels());
    for (const Size& size : sizes)
        bytes += Interleaved::bytesFor(size, request.channels()) * 4 / 3;
    return bytes;
}

Size halvedSize(Size size) {
    return {std::max(1, size.width / 2), std::max(1, size.height / 2)};
}

void previewMap(const PositionMap& map, std::span<const PatchSource> images, int level,
                const Request& request, JobContext& context) {
    if (!context.previewDue())
        return;
    const int step = (map.size().longerSide() + kPreviewSide - 1) / kPreviewSide;
    const Size size{(map.width() + step - 1) / step, (map.height() + step - 1) / step};
    std::vector<ImageView> views;
    for (const PatchSource& image : images)
        views.push_back(image.image);
    PositionMap sources(size, map.exemplarSizes()), full(size, request.exemplarSizes());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Source& source = map.at(x * step, y * step);
            sources.at(x, y) = source;
            if (source.valid())
                full.at(x, y) = {static_cast<std::uint16_t>(source.x << level),
                                 static_cast<std::uint16_t>(source.y << level), source.exemplar};
        }
    context.preview(sources.apply(views), &full);
}

} // namespace texloom

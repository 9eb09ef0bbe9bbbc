#include "core/methods/pixel_request.h"

#include "core/base/error.h"
#include "core/match/whole_patches.h"
#include "core/methods/patch_request.h"

#include <algorithm>

namespace texloom {

namespace {

/// Larger outputs are previewed without a map.
constexpr int kPreviewSide = 640;

/// An even neighbourhood counts as the next odd one, which must fit, too.
int largestOddSide(Size size) {
    return size.shorterSide() - (size.shorterSide() % 2 == 0 ? 1 : 0);
}

} // namespace

void checkSquares(const Request& request, int side) {
    bool any = false;
    for (const Exemplar& exemplar : request.exemplars) {
        const Size size = exemplar.image->size();
        if (size.shorterSide() < side)
            failUsage("{} is {} × {} px, smaller than the neighbourhood of {} px; choose a neighbourhood of "
                      "at most {} px, or a larger exemplar.",
                      exemplar.name, size.width, size.height, side, largestOddSide(size));
        any = any || !exemplar.mask() || leavesWholePatch(exemplar.mask()->view().plane(0), side);
    }
    if (!any)
        failUsage("The mask leaves no whole neighbourhood of {} px, but only some of at most {} px; choose a "
                  "smaller one or mask less.",
                  side, largestLeft(request, side));
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
    std::vector<ImageView> views;
    for (const PatchSource& image : images)
        views.push_back(image.image);
    const auto sampled = [&](Size size, int step) {
        PositionMap sources(size, map.exemplarSizes());
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                sources.at(x, y) = map.at(x * step, y * step);
        return sources;
    };
    // Where the job is to stop and keep what it has, that is all of it.
    if (map.size().longerSide() > kPreviewSide)
        return context.preview(map.size(),
                               [&](Size size, int step) { return sampled(size, step).apply(views); });
    PositionMap full(map.size(), request.exemplarSizes());
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
            const Source& source = map.at(x, y);
            if (source.valid())
                full.at(x, y) = {static_cast<std::uint16_t>(source.x << level),
                                 static_cast<std::uint16_t>(source.y << level), source.exemplar};
        }
    context.preview(map.apply(views), &full);
}

} // namespace texloom

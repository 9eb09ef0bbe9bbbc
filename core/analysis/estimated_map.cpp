#include "core/analysis/estimated_map.h"

#include <algorithm>

namespace texloom {

namespace {

/// Where the patch that decides pixel `at` begins, and which of its pixels that is.
struct Place {
    int start, within;
};

Place placeOf(int at, int length, int patch, bool wraps) {
    const int start = at - patch / 2;
    if (wraps)
        return {(start + length) % length, patch / 2};
    const int inside = std::clamp(start, 0, length - patch);
    return {inside, at - inside};
}

/// The starting matches are good; further iterations change few pixels.
constexpr int kIterations = 2;

int patchFor(int wanted, const ImageView& result, std::span<const PatchSource> exemplars) {
    int patch = std::min(wanted, result.size().shorterSide());
    for (const PatchSource& exemplar : exemplars)
        patch = std::min(patch, exemplar.image.size().shorterSide());
    return patch;
}

} // namespace

PositionMap estimatedMap(const ImageView& result, std::span<const PatchSource> exemplars, Wrap wrap,
                         JobContext& context, int patch) {
    patch = patchFor(patch, result, exemplars);
    const PatchField field = matchPatches(result, exemplars, {patch, kIterations, 2, wrap}, context);
    std::vector<Size> sizes;
    for (const PatchSource& exemplar : exemplars)
        sizes.push_back(exemplar.image.size());
    PositionMap map(result.size(), std::move(sizes));
    for (int y = 0; y < result.height; ++y) {
        context.check();
        const Place row = placeOf(y, result.height, patch, wrap.y);
        for (int x = 0; x < result.width; ++x) {
            const Place column = placeOf(x, result.width, patch, wrap.x);
            Source source = field.at(column.start, row.start).source;
            source.x = static_cast<std::uint16_t>(source.x + column.within);
            source.y = static_cast<std::uint16_t>(source.y + row.within);
            map.at(x, y) = source;
        }
    }
    return map;
}

std::uint64_t estimatedMapBytes(Size result, std::span<const Size> exemplars, int channels) {
    std::uint64_t bytes = PatchField::bytesFor(result) + PositionMap::bytesFor(result);
    for (const Size& exemplar : exemplars)
        bytes += static_cast<std::uint64_t>(exemplar.area()) *
                 (static_cast<std::uint64_t>(channels + 3) * sizeof(float) + 5);
    return bytes;
}

double estimatedMapSeconds(Size result, int channels) {
    return static_cast<double>(result.area()) * (4e-7 + 2e-7 * channels);
}

} // namespace texloom

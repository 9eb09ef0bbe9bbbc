#include "core/methods/patch_request.h"

#include "core/analysis/estimated_map.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/flat_shares.h"
#include "core/match/patch_distances.h"
#include "core/match/patch_quilter.h"
#include "core/match/whole_patches.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

void checkExemplar(const Exemplar& exemplar, int patch) {
    const Size size = exemplar.image->size();
    if (size.shorterSide() < patch)
        failUsage("{} is {} × {} px, smaller than the patch of {} px; choose a patch of at most {} px.",
                  exemplar.name, size.width, size.height, patch, size.shorterSide());
}

void checkWrap(bool wraps, int length, const char* side, int patch) {
    if (wraps && length < patch)
        failUsage("To wrap, the output's {} of {} px must be at least the patch, {} px.", side, length,
                  patch);
}

} // namespace

std::vector<PatchSource> patchSources(const Request& request) {
    std::vector<PatchSource> sources;
    for (const Exemplar& exemplar : request.exemplars)
        sources.push_back({exemplar.image->view(),
                           exemplar.mask() ? exemplar.mask()->view().plane(0) : PlaneView{},
                           exemplar.weight});
    return sources;
}

bool leavesWholePatch(const Request& request, int side) {
    return std::any_of(request.exemplars.begin(), request.exemplars.end(), [side](const Exemplar& exemplar) {
        return !exemplar.mask() || leavesWholePatch(exemplar.mask()->view().plane(0), side);
    });
}

int largestLeft(const Request& request, int side) {
    int fits = 0;
    for (int fails = side; fails - fits > 1;) {
        const int middle = (fits + fails) / 2;
        (leavesWholePatch(request, middle) ? fits : fails) = middle;
    }
    return fits;
}

void checkPatchRequest(const Request& request, int patch) {
    for (const Exemplar& exemplar : request.exemplars)
        checkExemplar(exemplar, patch);
    if (!leavesWholePatch(request, patch))
        failUsage("The mask leaves no whole patch of {} px to copy, but only some of at most {} px; choose a "
                  "smaller patch or mask less.",
                  patch, largestLeft(request, patch));
    checkWrap(request.wrap.x, request.size.width, "width", patch);
    checkWrap(request.wrap.y, request.size.height, "height", patch);
}

Image copied(const PositionMap& map, const Request& request, JobContext& context) {
    Image image(map.size(), request.channels());
    context.parallel(0, image.height(), [&](int y) {
        for (int x = 0; x < image.width(); ++x) {
            const Source& source = map.at(x, y);
            for (int c = 0; c < image.channels(); ++c)
                image(x, y, c) = (*request.exemplars[source.exemplar].image)(source.x, source.y, c);
        }
    });
    return image;
}

std::uint64_t patchSearchBytes(std::span<const Size> exemplars, int channels, int patch, int threads,
                               bool balanced) {
    // On an axis that wraps overlaps differ by a pixel: at most seven kinds along a row, for five kinds of
    // row.
    constexpr int kShapes = 35;
    std::uint64_t bytes = 0;
    for (const Size& size : exemplars)
        bytes += PatchDistances::bytesFor(size, channels, patch, kShapes, balanced) +
                 static_cast<std::uint64_t>(threads) * PatchDistances::scratchBytesFor(size, channels);
    return bytes;
}

double patchSearchSeconds(std::span<const Size> exemplars, int channels) {
    double seconds = 0;
    for (const Size& size : exemplars) {
        const auto pixels = static_cast<double>(size.area());
        seconds += pixels * (3e-9 + 7e-11 * std::log2(pixels) * (channels + 1));
    }
    return seconds;
}

Estimate growthEstimate(const Request& request, int patch, int overlap, int threads, bool balanced) {
    const std::vector<Size> exemplars = request.exemplarSizes();
    const int channels = request.channels();
    Estimate need;
    need.bytes = PatchCanvas::bytesFor(request.size, request.wrap, channels, patch, overlap) +
                 patchSearchBytes(exemplars, channels, patch, threads, balanced);
    for (const Size& size : exemplars)
        need.bytes += balanced ? FlatShares::bytesFor(size, patch) : 0;
    need.seconds = PatchCanvas::countFor(request.size, request.wrap, patch, overlap) *
                   patchSearchSeconds(exemplars, channels);
    return need;
}

Synthesis grown(PatchGrower& grower, const Request& request, const Message& stage, double mapWeight,
                JobContext& context) {
    context.stage(0.02, TR("Preparing the exemplar"));
    grower.prepare();
    context.stage(0.98 - mapWeight, stage);
    Synthesis result = withEstimatedMap(grower.grow(), request, mapWeight, context);
    result.figures = {{TR("Patches"), static_cast<double>(grower.patches())}};
    return result;
}

Synthesis quilted(Quilt quilt, MapKind kind) {
    Synthesis result;
    result.image = std::move(quilt.image);
    result.map = std::move(quilt.map);
    result.mapKind = kind;
    result.figures = {{TR("Patches"), static_cast<double>(quilt.patches)}};
    if (quilt.meanCutError)
        result.figures.push_back({TR("Mean error along a cut"), *quilt.meanCutError});
    return result;
}

Synthesis withEstimatedMap(Image image, const Request& request, double weight, JobContext& context) {
    context.preview(image);
    context.stage(weight, TR("Estimating the synthesis map"));
    Synthesis result;
    result.map = estimatedMap(image, patchSources(request), request.wrap, context);
    result.mapKind = MapKind::Estimated;
    result.image = std::move(image);
    return result;
}

void addEstimatedMap(const Request& request, Estimate& need) {
    need.bytes += estimatedMapBytes(request.size, request.exemplarSizes(), request.channels());
    need.seconds += estimatedMapSeconds(request.size, request.channels());
}

void finishPatches(PatchFinish finish, PositionMap map, const std::function<Image()>& joined,
                   const Request& request, JobContext& context, Synthesis& result) {
    map.shrink(request.size);
    if (finish == PatchFinish::Copy) {
        result.image = copied(map, request, context);
        result.mapKind = MapKind::Exact;
    } else {
        result.image = joined();
        result.image.shrink(request.size);
        result.mapKind = MapKind::Dominant;
    }
    result.map = std::move(map);
}

} // namespace texloom

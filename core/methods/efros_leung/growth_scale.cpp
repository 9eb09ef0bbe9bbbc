#include "core/methods/efros_leung/growth_scale.h"

#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace texloom::efros_leung {

namespace {

using pixel_growth::Grower;
using pixel_growth::Search;
using pixel_growth::Settings;

/// Exemplars of so many pixels are searched as a whole on the coarsest scale; larger ones by components.
constexpr std::int64_t kExactPixels = 1 << 13;
/// Work of a scale beside that of the next finer one.
constexpr double kCoarser = 0.3;

std::int64_t pixelsOf(const Request& request) {
    std::int64_t pixels = 0;
    for (const Exemplar& exemplar : request.exemplars)
        pixels += exemplar.image->size().area();
    return pixels;
}

/// The largest side of a window that fits where sources may be copied.
int fittingWindow(const Request& request, int wanted, JobContext& context) {
    int window = wanted;
    for (const Exemplar& exemplar : request.exemplars)
        window = std::min(window, (exemplar.image->size().shorterSide() - 1) | 1);
    while (window > 3 && !leavesWholePatch(request, window)) {
        context.check();
        window -= 2;
    }
    return window;
}

} // namespace

Settings settingsAt(const Request& request, const Settings& settings, int level, bool coarsest,
                    JobContext& context) {
    Settings scaled = settings;
    scaled.window = fittingWindow(request, Grower::window(settings), context);
    if (settings.radius > 0)
        scaled.radius = std::max(1, settings.radius >> level);
    if (coarsest && settings.search == Search::Auto)
        scaled.search = pixelsOf(request) <= kExactPixels ? Search::Exact : Search::Pca;
    return scaled;
}

double shareOfScale(int level, int levels) {
    double whole = 0;
    for (int other = 0; other < levels; ++other)
        whole += std::pow(kCoarser, other);
    return std::pow(kCoarser, level) / whole;
}

Settings largestAtAnyScale(Settings settings) {
    if (settings.search == Search::Auto)
        settings.search = Search::Pca;
    return settings;
}

} // namespace texloom::efros_leung

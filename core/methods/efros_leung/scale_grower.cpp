#include "core/methods/efros_leung/scale_grower.h"

#include "core/methods/efros_leung/growth_scale.h"
#include "core/methods/fill_scales.h"
#include "core/methods/fill_seams.h"
#include "core/methods/patch_request.h"
#include "core/methods/pixel_request.h"

#include <algorithm>

namespace texloom::efros_leung {

namespace {

using pixel_growth::Grower;
using pixel_growth::Settings;

/// The finest scale on which seams are moved, where there are so many. Large pieces that are cut on finer
/// ones show where brightness changes slowly, as in wood; there, growth itself joins them better. On the
/// coarsest they are always moved: what grows there out of nothing vanishes.
constexpr int kFinestMoved = 2;

/// The output's size from fine to coarse, down to one that is hardly larger than a window.
std::vector<Size> sizesOf(Size size, int window, int most) {
    std::vector<Size> sizes{size};
    while (static_cast<int>(sizes.size()) < most && sizes.back().shorterSide() >= 2 * window)
        sizes.push_back(halvedSize(sizes.back()));
    return sizes;
}

/// Of exemplars at a coarse scale: where a larger one leaves few places, garbage grows.
int largestWindow(const std::vector<Size>& exemplars) {
    int side = exemplars.front().shorterSide();
    for (const Size& exemplar : exemplars)
        side = std::min(side, exemplar.shorterSide());
    return side / 2;
}

} // namespace

ScaleGrower::ScaleGrower(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context),
      m_pyramid(patchSources(request), settings.scales, 2 * std::min(kLeastWindow, Grower::window(settings)),
                [&context] { context.check(); }),
      m_sizes(sizesOf(request.size, Grower::window(settings), m_pyramid.levels())) {}

Synthesis ScaleGrower::run() {
    PositionMap map;
    for (int level = levels() - 1; level > 0; --level)
        map = grow(level, map).map;
    return grow(0, map);
}

/// @param coarser map of the next coarser scale, if there is one.
Synthesis ScaleGrower::grow(int level, const PositionMap& coarser) {
    const Size size = m_sizes[static_cast<std::size_t>(level)];
    const Request request = level == 0 ? m_request : requestAt(m_request, m_pyramid, level, size);
    const bool coarsest = level + 1 == levels();
    Settings settings = settingsAt(request, m_settings, level, coarsest, m_context);
    if (level > 0)
        settings.window = std::min(settings.window, largestWindow(m_pyramid.sizes(level)));
    pixel_growth::Start start;
    PositionMap guess;
    if (!coarsest) {
        guess = finer(coarser, size, m_pyramid.sizes(level), [this] { m_context.check(); });
        start.guess = &guess;
    }
    start.offer = [this, level](const PositionMap& map) {
        previewMap(map, m_pyramid.level(level), level, m_request, m_context);
    };
    Synthesis grown = Grower(request, settings, start, m_context).run(shareOfScale(level, levels()));
    if (m_settings.seams && level > 0 && level >= std::min(kFinestMoved, levels() - 1)) {
        const std::vector<std::uint8_t> made(static_cast<std::size_t>(size.area()), 1);
        SeamMoves moves;
        moves.radius = settings.radius;
        moveSeams({m_pyramid.level(level), made, request.wrap}, grown.image, moves, grown.map,
                  [this] { m_context.check(); });
    }
    return grown;
}

std::uint64_t ScaleGrower::bytesFor(const Request& request, const Settings& settings, int threads) {
    const std::vector<Size> exemplars = request.exemplarSizes();
    const Size moved = halvedSize(request.size);
    // The pyramid and a scale's copy of it, guess and coarser map beside the growth itself.
    return 2 * ExemplarPyramid::bytesFor(exemplars, request.channels() + 1) +
           2 * PositionMap::bytesFor(request.size) +
           Grower::bytesFor(request, largestAtAnyScale(settings), threads) +
           (settings.seams ? seamBytes(moved, exemplars, request.channels()) : 0);
}

} // namespace texloom::efros_leung

#include "core/methods/efros_leung/hole_grower.h"

#include "core/base/text.h"
#include "core/methods/fill_join.h"
#include "core/methods/fill_tone.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace texloom::efros_leung {

namespace {

using pixel_growth::Grower;
using pixel_growth::Search;

/// Scales hold windows of this side at least; smaller ones show too little.
constexpr int kLeastWindow = 9;
/// Exemplars of so many pixels are searched as a whole on the coarsest scale; larger ones by components.
constexpr std::int64_t kExactPixels = 1 << 13;
/// Work of a scale beside that of the next finer one.
constexpr double kCoarser = 0.3;
/// Share of the run that it takes to move seams, and to even tone.
constexpr double kJoin = 0.1;

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

HoleGrower::HoleGrower(const FillWindow& window, const Settings& settings, JobContext& context)
    : m_window(window), m_request(window.request()), m_settings(settings), m_context(context),
      m_pyramid(patchSources(m_request), settings.scales, std::min(kLeastWindow, Grower::window(settings)),
                [&context] { context.check(); }),
      m_scales(fillScales(m_request, Grower::window(settings), m_pyramid.levels(),
                          [&context] { context.check(); })) {}

Synthesis HoleGrower::run() {
    for (int level = static_cast<int>(m_scales.size()) - 1; level >= 0; --level)
        grow(level);
    if (m_settings.seams) {
        m_context.stage(kJoin, TR("Moving seams"));
        joinCopies(m_request, kJoinSide, m_settings.radius, m_map, m_context);
        offer(0, m_map);
    }
    m_context.stage(0.02, TR("Copying pixels"));
    Synthesis result = m_window.filled(m_map, m_context);
    if (m_settings.tone)
        evenFilledTone(m_window.whole(), kJoin, m_context, result);
    m_context.progress(1);
    return result;
}

void HoleGrower::grow(int level) {
    const FillScale& scale = m_scales[static_cast<std::size_t>(level)];
    const Request request = level == 0 ? m_request : requestAt(m_request, m_pyramid, level, scale);
    Settings settings = m_settings;
    settings.window = fittingWindow(request, Grower::window(m_settings), m_context);
    if (settings.radius > 0)
        settings.radius = std::max(1, settings.radius >> level);
    const bool coarsest = level + 1 == static_cast<int>(m_scales.size());
    if (coarsest && settings.search == Search::Auto)
        settings.search = pixelsOf(request) <= kExactPixels ? Search::Exact : Search::Pca;
    PositionMap guess;
    if (!coarsest)
        guess = finer(m_map, scale.known, m_pyramid.sizes(level), [this] { m_context.check(); });
    double whole = 0;
    for (std::size_t other = 0; other < m_scales.size(); ++other)
        whole += std::pow(kCoarser, static_cast<double>(other));
    const double growth = 0.78 + (m_settings.seams ? 0 : kJoin) + (m_settings.tone ? 0 : kJoin);
    pixel_growth::Start start{&scale.picture, &scale.known};
    start.guess = coarsest ? nullptr : &guess;
    start.offer = [this, level](const PositionMap& map) { offer(level, map); };
    m_map = Grower(request, settings, start, m_context).run(growth * std::pow(kCoarser, level) / whole).map;
    if (m_settings.seams && level > 0)
        joinCopies(request, kCoarseJoinSide, settings.radius, m_map, m_context);
    offer(level, m_map);
}

/// Offers the whole picture with what is made at this scale, if it is looked at.
void HoleGrower::offer(int level, const PositionMap& map) {
    offerFilled(
        m_window, level,
        [&](int x, int y, float* values) {
            const Source& source = map.at(std::min(x, map.width() - 1), std::min(y, map.height() - 1));
            if (!source.valid())
                return false;
            const ImageView& image = m_pyramid.level(level)[source.exemplar].image;
            for (int c = 0; c < image.channels; ++c)
                values[c] = image(source.x, source.y, c);
            return true;
        },
        m_context);
}

std::uint64_t HoleGrower::bytesFor(const Request& request, const Settings& settings, int threads) {
    // Exemplars, masks, pictures, guess and map of a scale beside those of the growth itself.
    const std::uint64_t scale = FillWindow::bytesFor(request) + 2 * PositionMap::bytesFor(request.size) +
                                Image::bytesFor(request.size, request.channels() + 1) +
                                2 * ExemplarPyramid::bytesFor(request.exemplarSizes(), request.channels()) +
                                fillScalesBytes(request);
    Settings growth = settings;
    if (growth.search == Search::Auto)
        growth.search = Search::Pca;
    return scale + Grower::bytesFor(request, growth, threads) + fillMaskBytes(request) +
           (settings.seams ? joinBytes(request, threads) : 0) + (settings.tone ? toneBytes(request) : 0);
}

} // namespace texloom::efros_leung

#include "core/methods/efros_leung/hole_grower.h"

#include "core/base/text.h"
#include "core/methods/efros_leung/growth_scale.h"
#include "core/methods/fill_join.h"
#include "core/methods/fill_tone.h"
#include "core/methods/patch_request.h"

#include <algorithm>

namespace texloom::efros_leung {

namespace {

using pixel_growth::Grower;

/// Share of the run that it takes to move seams, and to even tone.
constexpr double kJoin = 0.1;

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
    const int levels = static_cast<int>(m_scales.size());
    const bool coarsest = level + 1 == levels;
    const Settings settings = settingsAt(request, m_settings, level, coarsest, m_context);
    PositionMap guess;
    if (!coarsest)
        guess = finer(m_map, scale.known, m_pyramid.sizes(level), [this] { m_context.check(); });
    const double growth = 0.78 + (m_settings.seams ? 0 : kJoin) + (m_settings.tone ? 0 : kJoin);
    pixel_growth::Start start{&scale.picture, &scale.known};
    start.guess = coarsest ? nullptr : &guess;
    start.offer = [this, level](const PositionMap& map) { offer(level, map); };
    m_map = Grower(request, settings, start, m_context).run(growth * shareOfScale(level, levels)).map;
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
    return scale + Grower::bytesFor(request, largestAtAnyScale(settings), threads) + fillMaskBytes(request) +
           (settings.seams ? joinBytes(request, threads) : 0) + (settings.tone ? toneBytes(request) : 0);
}

} // namespace texloom::efros_leung

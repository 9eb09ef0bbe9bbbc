#include "core/methods/multiscale_gaussian/scale.h"

#include "core/match/gaussian_patches.h"
#include "core/match/patch_stitch.h"

#include <algorithm>

namespace texloom::multiscale_gaussian {

namespace {

Image difference(const Image& a, const Image& b) {
    Image result(a.size(), a.channels());
    for (int c = 0; c < a.channels(); ++c)
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                result(x, y, c) = a(x, y, c) - b(x, y, c);
    return result;
}

std::vector<PatchSource> sourcesOf(const std::vector<ExemplarScales>& exemplars, int scale,
                                   Image ExemplarScale::*which) {
    std::vector<PatchSource> sources;
    for (const ExemplarScales& scales : exemplars) {
        const ExemplarScale& one = scales[static_cast<std::size_t>(scale)];
        sources.push_back({(one.*which).view(), one.mask.empty() ? PlaneView{} : one.mask.view().plane(0)});
    }
    return sources;
}

} // namespace

ExemplarScales exemplarScales(const Exemplar& exemplar, int scales, const std::function<void()>& check) {
    ExemplarScales made;
    for (int scale = 0; scale < scales; ++scale) {
        ExemplarScale& one = made.emplace_back();
        const ExemplarScale* finer = scale > 0 ? &made[static_cast<std::size_t>(scale) - 1] : nullptr;
        one.image = finer ? everySecond(finer->low) : *exemplar.image;
        if (exemplar.mask())
            one.mask = finer ? everySecond(finer->mask) : *exemplar.mask();
        if (scale + 1 < scales) {
            one.low = blurred(one.image, kZoomSigma, {}, check);
            one.high = difference(one.image, one.low);
        }
    }
    return made;
}

ScaleSampler::ScaleSampler(const std::vector<ExemplarScales>& exemplars, int scale, const Settings& settings,
                           Size size, Wrap wrap, const Image& low, JobContext& context)
    : PatchGrower(sourcesOf(exemplars, scale, &ExemplarScale::image),
                  {size, wrap, settings.patch, settings.overlapPixels(), settings.contrast}, context,
                  PatchStitcher(low.empty() ? settings.coarsest : settings.stitch, settings.patch)),
      m_scale(scale), m_settings(settings) {
    if (low.empty())
        return;
    m_lowSearch.emplace(
        sourcesOf(exemplars, scale, &ExemplarScale::low), settings.patch, [&context] { context.check(); },
        settings.contrast);
    m_lowSearch->prepare(Footprint::filled(patchSize()));
    m_low.emplace(size, wrap, low.channels(), settings.patch, settings.overlapPixels());
    m_low->fill(low, context);
    canvas().fill(low, context);
    for (const ExemplarScales& scales : exemplars)
        m_high.push_back(scales[static_cast<std::size_t>(scale)].high);
}

std::vector<PatchPosition> ScaleSampler::neighbours(const PatchCell& cell, Workspace& work,
                                                    LowWorkspace& low) const {
    m_lowSearch->compute(low.patch, Footprint::filled(patchSize()), low.search,
                         [this] { context().check(); });
    if (cell.overlap.none())
        return m_lowSearch->nearest(m_settings.neighbours, low.search);
    // Eq. 3.13 times n²: mean squares of both terms.
    compare(cell, work.known, work);
    const double area = m_settings.patch * m_settings.patch;
    search().add(low.search, area / compared(cell).pixels(m_settings.patch), work.search);
    return search().nearest(m_settings.neighbours, work.search);
}

std::vector<ImageView> ScaleSampler::pieces(const std::vector<PatchPosition>& positions) const {
    std::vector<ImageView> views;
    for (const PatchPosition& position : positions)
        views.push_back(
            m_high[static_cast<std::size_t>(position.exemplar)].crop(position.x, position.y, patchSize()));
    return views;
}

void ScaleSampler::sample(const PatchCell& cell, const std::vector<ImageView>& patches, Image& to) const {
    drawPatch(patches, context().random(), cell, (static_cast<std::uint32_t>(m_scale) << 16U) + 2,
              m_settings.bounded, to);
}

void ScaleSampler::make(const PatchCell& cell, Workspace& work) {
    if (!m_low) {
        sample(cell, search().pixels(nearest(cell, m_settings.neighbours, work)), work.fresh);
        return join(cell, work);
    }
    const auto low = m_pool.borrow([this] {
        return LowWorkspace{Image(patchSize(), canvas().image().channels()), m_lowSearch->scratch()};
    });
    m_low->read(cell, low->patch);
    sample(cell, pieces(neighbours(cell, work, *low)), work.fresh);
    for (int c = 0; c < work.fresh.channels(); ++c)
        for (int y = 0; y < m_settings.patch; ++y)
            for (int x = 0; x < m_settings.patch; ++x)
                work.fresh(x, y, c) += low->patch(x, y, c);
    join(cell, work);
}

} // namespace texloom::multiscale_gaussian

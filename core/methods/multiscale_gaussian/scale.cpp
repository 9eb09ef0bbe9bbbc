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

/// Pixels that a footprint counts.
double areaOf(const Footprint& shape, int patch) {
    int count = 0;
    for (int y = 0; y < patch; ++y)
        for (int x = 0; x < patch; ++x)
            count += shape.contains(x, y, patch) ? 1 : 0;
    return count;
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
    : m_scale(scale), m_settings(settings), m_context(context),
      m_canvas(size, wrap, exemplars.front().front().image.channels(), settings.patch,
               settings.overlapPixels()),
      m_search(
          sourcesOf(exemplars, scale, &ExemplarScale::image), settings.patch, [&context] { context.check(); },
          settings.contrast),
      m_stitcher(low.empty() ? settings.coarsest : settings.stitch, settings.patch) {
    if (low.empty())
        return;
    m_lowSearch.emplace(
        sourcesOf(exemplars, scale, &ExemplarScale::low), settings.patch, [&context] { context.check(); },
        settings.contrast);
    m_low.emplace(size, wrap, low.channels(), settings.patch, settings.overlapPixels());
    m_low->fill(low);
    m_canvas.fill(low);
    for (const ExemplarScales& scales : exemplars)
        m_high.push_back(scales[static_cast<std::size_t>(scale)].high);
}

Footprint ScaleSampler::compared(const PatchCell& cell) const {
    return cell.overlap.none() ? Footprint::filled({m_settings.patch, m_settings.patch})
                               : Footprint(cell.overlap);
}

Image ScaleSampler::run() {
    const Size whole{m_settings.patch, m_settings.patch};
    for (const PatchCell& cell : m_canvas.grid().cells()) {
        m_search.prepare(compared(cell));
        m_stitcher.prepare(cell.overlap);
    }
    if (m_lowSearch)
        m_lowSearch->prepare(Footprint::filled(whole));
    m_canvas.grow(
        m_context, [this](int index) { place(m_canvas.grid().cell(index)); },
        [this] { m_context.preview(m_canvas.image()); });
    return m_canvas.take();
}

std::vector<PatchPosition> ScaleSampler::neighbours(const PatchCell& cell, Workspace& work) const {
    const auto check = [this] { m_context.check(); };
    const double area = m_settings.patch * m_settings.patch;
    if (coarsest()) {
        if (cell.overlap.none())
            work.known = Image(m_search.pixels(m_search.drawn(m_context.random().uniform(0, 0))));
        m_search.compute(work.known, compared(cell), work.search, check);
        return m_search.nearest(m_settings.neighbours, work.search);
    }
    m_lowSearch->compute(work.low, Footprint::filled({m_settings.patch, m_settings.patch}), work.lowSearch,
                         check);
    if (cell.overlap.none())
        return m_lowSearch->nearest(m_settings.neighbours, work.lowSearch);
    // Eq. 3.13 times n²: mean squares of both terms.
    const Footprint shape = compared(cell);
    m_search.compute(work.known, shape, work.search, check);
    m_search.add(work.lowSearch, area / areaOf(shape, m_settings.patch), work.search);
    return m_search.nearest(m_settings.neighbours, work.search);
}

std::vector<ImageView> ScaleSampler::pieces(const std::vector<PatchPosition>& positions) const {
    if (coarsest())
        return m_search.pixels(positions);
    std::vector<ImageView> views;
    for (const PatchPosition& position : positions)
        views.push_back(m_high[static_cast<std::size_t>(position.exemplar)].crop(
            position.x, position.y, {m_settings.patch, m_settings.patch}));
    return views;
}

void ScaleSampler::place(const PatchCell& cell) {
    const auto work = m_pool.borrow([this] {
        const Size patch{m_settings.patch, m_settings.patch};
        const int channels = m_canvas.image().channels();
        return Workspace{
            Image(patch, channels), Image(patch, channels),
            Image(patch, channels), m_stitcher.scratch(),
            m_search.scratch(),     m_lowSearch ? m_lowSearch->scratch() : PatchSearch::Scratch{}};
    });
    m_canvas.read(cell, work->known);
    if (m_low)
        m_low->read(cell, work->low);
    const std::vector<ImageView> patches = pieces(neighbours(cell, *work));
    combinePatches(patches,
                   gaussianWeights(normalNumbers(m_context.random(), cell, patches.size(), firstDraw() + 2)),
                   work->fresh);
    if (m_low)
        for (int c = 0; c < work->fresh.channels(); ++c)
            for (int y = 0; y < m_settings.patch; ++y)
                for (int x = 0; x < m_settings.patch; ++x)
                    work->fresh(x, y, c) += work->low(x, y, c);
    m_stitcher.join(work->known, cell.overlap, work->fresh, work->stitch);
    m_canvas.place(cell, work->fresh);
}

} // namespace texloom::multiscale_gaussian

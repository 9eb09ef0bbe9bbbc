#include "core/methods/quilting/quilter.h"

#include "core/base/text.h"
#include "core/match/patch_stitch.h"
#include "core/methods/patch_request.h"

#include <numeric>

namespace texloom::quilting {

Quilter::Quilter(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context),
      m_search(
          patchSources(request), settings.patch, [&context] { context.check(); }, settings.contrast),
      m_canvas(request.size, request.wrap, request.channels(), settings.patch, settings.overlapPixels()),
      m_map(m_canvas.image().size(), request.exemplarSizes()),
      m_cutCosts(static_cast<std::size_t>(m_canvas.grid().count()), 0.0) {}

void Quilter::prepareExemplars() {
    for (const PatchCell& cell : m_canvas.grid().cells())
        m_search.prepare(compared(cell));
}

Footprint Quilter::compared(const PatchCell& cell) const {
    // The last patches reach beyond the output, where the initial image says nothing.
    return m_request.initial() ? Footprint::filled(m_canvas.visible(cell)) : Footprint(cell.overlap);
}

PatchPosition Quilter::choose(const PatchCell& cell, Workspace& work) const {
    if (cell.overlap.none() && !m_request.initial())
        return m_search.drawn(m_context.random().uniform(cell.column, cell.row));
    m_search.compute(work.known, compared(cell), work.scratch, [this] { m_context.check(); });
    return m_search.drawn(m_search.within(m_settings.tolerance, work.scratch), m_context.random(),
                          cell.column, cell.row);
}

void Quilter::trace(const PatchCell& cell, const PatchPosition& source, const PlaneView& weight) {
    for (int y = 0; y < m_settings.patch; ++y) {
        const int toY = (cell.y + y) % m_map.height();
        for (int x = 0; x < m_settings.patch; ++x)
            if (weight(x, y) < 0.5F)
                m_map.at((cell.x + x) % m_map.width(), toY) = {static_cast<std::uint16_t>(source.x + x),
                                                               static_cast<std::uint16_t>(source.y + y),
                                                               static_cast<std::uint16_t>(source.exemplar)};
    }
}

void Quilter::place(int index) {
    const PatchCell& cell = m_canvas.grid().cell(index);
    const auto work = m_pool.borrow([this] {
        const Size patch{m_settings.patch, m_settings.patch};
        return Workspace{Image(patch, m_request.channels()), Image(patch, 1), Image(patch, 1),
                         m_search.scratch()};
    });
    m_canvas.read(cell, work->known);
    const PatchPosition source = choose(cell, *work);
    const ImageView fresh = m_search.pixels(source);
    const int softness = m_settings.stitch == Stitch::SmoothCut ? m_settings.softness : 0;
    m_cutCosts[static_cast<std::size_t>(index)] =
        cutWeights(work->known, fresh, cell.overlap, softness, work->error.plane(0), work->weight.plane(0));
    const PlaneView weight = work->weight.plane(0);
    m_canvas.place(cell, work->known, fresh, weight);
    trace(cell, source, weight);
}

Synthesis Quilter::run(Order order) {
    m_context.stage(0.05, TR("Preparing the exemplar"));
    prepareExemplars();
    if (m_request.initial())
        m_canvas.fill(*m_request.initial());
    m_context.stage(0.95, TR("Placing patches"));
    const auto body = [this](int index) { place(index); };
    const auto show = [this] { m_context.preview(m_canvas.image(), &m_map); };
    const int count = m_canvas.grid().count();
    if (order == Order::Wavefront)
        m_canvas.grow(m_context, body, show);
    else
        for (int index = 0; index < count; ++index)
            body(index);
    Synthesis result;
    result.image = m_canvas.take();
    m_map.shrink(m_request.size);
    result.map = std::move(m_map);
    result.mapKind = m_settings.stitch == Stitch::Cut ? MapKind::Exact : MapKind::Dominant;
    const double cost = std::accumulate(m_cutCosts.begin(), m_cutCosts.end(), 0.0);
    result.figures = {{TR("Patches"), static_cast<double>(count)},
                      {TR("Mean error along a cut"), cost / count}};
    return result;
}

} // namespace texloom::quilting

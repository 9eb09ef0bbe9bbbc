#include "core/match/patch_grower.h"

#include <utility>

namespace texloom {

namespace {

int channelsOf(const std::vector<PatchSource>& sources) {
    return sources.front().image.channels;
}

} // namespace

PatchGrower::PatchGrower(const std::vector<PatchSource>& sources, const Layout& layout, JobContext& context,
                         std::optional<PatchStitcher> stitcher)
    : m_context(context), m_search(
                              sources, layout.patch, [&context] { context.check(); }, layout.contrast),
      m_canvas(layout.output, layout.wrap, channelsOf(sources), layout.patch, layout.overlap),
      m_stitcher(std::move(stitcher)) {}

void PatchGrower::prepare() {
    for (const PatchCell& cell : m_canvas.grid().cells()) {
        m_search.prepare(compared(cell));
        if (m_stitcher)
            m_stitcher->prepare(cell.overlap);
    }
}

Image PatchGrower::grow() {
    m_canvas.grow(
        m_context, [this](int index) { grow(m_canvas.grid().cell(index)); },
        [this] { m_context.preview(m_canvas.image()); });
    return m_canvas.take();
}

Footprint PatchGrower::compared(const PatchCell& cell) const {
    return cell.overlap.none() ? Footprint::filled(patchSize()) : Footprint(cell.overlap);
}

void PatchGrower::compare(const PatchCell& cell, const Image& known, Workspace& work) const {
    m_search.compute(known, compared(cell), work.search, [this] { m_context.check(); });
}

std::vector<PatchPosition> PatchGrower::nearest(const PatchCell& cell, int count, Workspace& work) const {
    if (cell.overlap.none())
        work.known = Image(m_search.pixels(m_search.drawn(m_context.random().uniform(0, 0))));
    compare(cell, work.known, work);
    return m_search.nearest(count, work.search);
}

void PatchGrower::join(const PatchCell& cell, Workspace& work) const {
    m_stitcher->join(work.known, cell.overlap, work.fresh, work.stitch);
}

void PatchGrower::place(const PatchCell& cell, Workspace& work) {
    m_canvas.place(cell, work.fresh);
}

void PatchGrower::grow(const PatchCell& cell) {
    const auto work = m_pool.borrow([this] {
        const int channels = m_canvas.image().channels();
        return Workspace{Image(patchSize(), channels), Image(patchSize(), channels), m_search.scratch(),
                         m_stitcher ? m_stitcher->scratch() : PatchStitcher::Scratch{}};
    });
    m_canvas.read(cell, work->known);
    make(cell, *work);
    place(cell, *work);
}

} // namespace texloom
